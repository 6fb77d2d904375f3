#pragma once
#include <cstdint>

namespace ostraka {

/// The most of something that is read from a file. docs/limits.md shows them all.
struct Limit {
  const char* what;
  std::uint64_t most;
  const char* unit;
  const char* reason;
};

namespace limits {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

inline constexpr Limit kFileBytes{"Any file read at once", 4096 * kMiB, "bytes",
                                  "a file is held in memory whole"};
inline constexpr Limit kJsonBytes{"JSON text", 64 * kMiB, "bytes",
                                  "parsed it takes ten times as much memory"};
inline constexpr Limit kJsonDepth{"JSON lists and objects within each other", 64, "levels",
                                  "the deepest file of the program has 9"};
inline constexpr Limit kPlateMarkers{"Markers of a plate", 1024, "markers",
                                     "the largest dictionary has as many"};
inline constexpr Limit kPlateReach_mm{"Distance of a marker from the plate's middle", 10'000, "mm",
                                      "a plate of 20 m is a mistake in the unit"};
inline constexpr Limit kPoseReach_mm{"Distance of a camera or a sherd from the plate's middle",
                                     20'000, "mm", "the width of the largest plate"};
inline constexpr Limit kScanReach_mm{"Distance between the origins of two scans", 1'000'000, "mm",
                                     "beyond it, coordinates of 4 bytes are coarser than scans"};
inline constexpr Limit kBoardSquares{"Squares of a calibration board in a row", 100, "squares",
                                     "a photograph cannot resolve more"};
inline constexpr Limit kRigCameras{"Number of a camera", 1000, "",
                                   "a rig has a few; more is a damaged file"};
inline constexpr Limit kRigStops{"Number of a turntable position", 100'000, "",
                                 "finer than any turntable turns"};
inline constexpr Limit kRigPositions{"Turntable positions of a rig", 400, "positions",
                                     "finer than a degree, photographs show nothing new"};
inline constexpr Limit kRigRatio{"Longer side of a rig's pictures by the shorter one", 4, "",
                                 "cameras have 1 to 2"};
inline constexpr Limit kImageSide{"Width or height of an image", 100'000, "pixels",
                                  "larger ones are damaged headers"};
inline constexpr Limit kImagePixels{
    "Pixels of an image", 400'000'000, "pixels",
    "the largest sensors have 200 million; they take 10 bytes each"};
inline constexpr Limit kImageBytes{"Image file", 2047 * kMiB, "bytes",
                                   "no camera writes more, and decoders count bytes with 31 bits"};
inline constexpr Limit kTexturePixels{"Pixels of a model's texture", std::uint64_t{1} << 26,
                                      "pixels", "the program makes no larger page"};
inline constexpr Limit kJpegScans{"Scans of a JPEG image", 100, "scans",
                                  "each is a pass over the whole image; cameras write about 10"};
inline constexpr Limit kHeifParts{"Parts of a HEIC image", 10'000, "parts",
                                  "the largest image has 6,100 tiles of 256 x 256 pixels"};
inline constexpr Limit kHeifLevels{"Images within each other in a HEIC image", 4, "levels",
                                   "an image with a channel in tiles has 3"};
inline constexpr Limit kRawPixelsPerByte{"Pixels of a RAW image for each byte of its file", 516,
                                         "pixels", "zeros of two bytes, deflated, have as many"};
inline constexpr Limit kNetworkBytes{"Network for masks (ONNX)", 1024 * kMiB, "bytes",
                                     "it is held in memory twice while it is read"};
inline constexpr Limit kNetworkRunBytes{"What layers of a network for masks give to one another",
                                        2048 * kMiB, "bytes", "the program's own takes 0.1 GB"};
inline constexpr Limit kVertices{"Vertices of a PLY file", 200'000'000, "vertices",
                                 "they take up to 8 GB of memory"};
inline constexpr Limit kFaces{"Faces of a PLY file", 200'000'000, "faces",
                              "they take 2.4 GB of memory"};
inline constexpr Limit kFaceCorners{"Corners of a face", 1000, "corners",
                                    "each becomes a triangle; scanners write 3 or 4"};
inline constexpr Limit kDecisions{"Decisions about a batch", 10'000, "decisions",
                                  "a person takes a few for each sherd"};
inline constexpr Limit kDecisionReplaces{"Decisions that one decision replaces", 1000, "decisions",
                                         "a plate does not hold more scans"};
inline constexpr Limit kMaskStrokes{"Strokes on the mask of a photograph", 1000, "strokes",
                                    "each is painted again whenever the mask is used"};
inline constexpr Limit kMaskPoints{"Points of the strokes on a mask", 100'000, "points",
                                   "half an hour of painting; a brush fills a disc at each"};
inline constexpr Limit kModelExtent_mm{"Length, width or height of a model that is drawn", 2000,
                                       "mm", "the largest storage jars; more is another unit"};
inline constexpr Limit kRasterPixels{"Pixels that a model is drawn with", 100'000'000, "pixels",
                                     "they take 1.4 GB of memory; a larger picture is coarser"};
inline constexpr Limit kManifestBytes{"Manifest of an archive or an export", 256 * kMiB, "bytes",
                                      "that of a million files is shorter"};
inline constexpr Limit kTableBytes{"Table (CSV)", 256 * kMiB, "bytes",
                                   "it is held in memory whole, and shown"};
inline constexpr Limit kTableRows{"Rows of a table", 1'000'000, "rows",
                                  "ten times the largest find database known"};
inline constexpr Limit kTableColumns{"Columns of a table", 1000, "columns",
                                     "each is compared with every other"};
inline constexpr Limit kTableFieldBytes{"Field of a table", kMiB, "bytes",
                                        "a quotation mark that is never closed ends there"};
inline constexpr Limit kValueBytes{"Text of a field in the catalogue", kMiB, "bytes",
                                   "a remark of 500 pages"};

inline constexpr Limit kTemplateBytes{"Template of a remark", 1024, "bytes",
                                      "the program's longest has 274"};
inline constexpr Limit kPlaceUses{"Uses of one value in a template", 3, "uses",
                                  "nested remarks multiply with it; the program's use each once"};
inline constexpr Limit kRemarkDepth{"Remarks within each other", 8, "levels",
                                    "an error within an error within a remark has 4"};
inline constexpr Limit kRemarkBytes{
    "Text of all remarks of a list, counting those within each other", 4 * kMiB, "bytes",
    "a kilobyte about each of 4,000 photographs"};

/// Pixels of the shorter side of a photograph from which points are made: its coarsest level has a
/// quarter of them.
inline constexpr int kLeastPhotographSide = 16;

inline constexpr Limit kAll[] = {
    kFileBytes,     kJsonBytes,       kJsonDepth,        kPlateMarkers,
    kPlateReach_mm, kPoseReach_mm,    kScanReach_mm,     kBoardSquares,
    kRigCameras,    kRigStops,        kRigPositions,     kRigRatio,
    kImageSide,     kImagePixels,     kImageBytes,       kTexturePixels,
    kJpegScans,     kHeifParts,       kHeifLevels,       kRawPixelsPerByte,
    kNetworkBytes,  kNetworkRunBytes, kVertices,         kFaces,
    kFaceCorners,   kDecisions,       kDecisionReplaces, kMaskStrokes,
    kMaskPoints,    kModelExtent_mm,  kRasterPixels,     kManifestBytes,
    kTableBytes,    kTableRows,       kTableColumns,     kTableFieldBytes,
    kValueBytes,    kTemplateBytes,   kPlaceUses,        kRemarkDepth,
    kRemarkBytes};

}  // namespace limits
}  // namespace ostraka
