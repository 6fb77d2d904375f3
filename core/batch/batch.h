#pragma once
#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace ostraka::batch {

enum class Side { Front, Back };
const char* name(Side side);  ///< "front" or "back"
/// 0 is A (the lowest), 1 is B; beyond Z the number. Files count from 0, people read letters.
std::string cameraLetter(int camera);
/// The serial numbers of the virtual rig's cameras begin so: what they photographed is invented.
inline constexpr const char* kVirtualSerial = "VIRTUAL-";

/// What stands still while a side is photographed.
enum class Way {
  Rig,         ///< the cameras: the marker plate turns below them, with the sherds on it
  FreeCamera,  ///< the sherds: one camera takes each photograph from another place
};

/// One photograph; (side, camera, stop) is unique in a batch. Way::FreeCamera: `camera` counts the
/// photographs of the side in the order of their names, `stop` is 0, since the light stands still
/// over the sherds as it does at one stop of a rig.
struct Shot {
  Side side = Side::Front;
  int camera = 0;
  int stop = 0;
  std::filesystem::path file;       ///< the photograph, absolute; opened for reading only
  std::filesystem::path mask_file;  ///< a mask that came with it; empty when none did
  int width = 0, height = 0;        ///< pixels, from the file's header
};

struct Marker {
  int id = 0;
  std::array<Eigen::Vector3d, 4> corners;  ///< plate frame, mm, OpenCV's order
};

struct Plate {
  std::string dictionary;  ///< OpenCV's name, as DICT_4X4_100
  double diameter_mm = 0;  ///< not in plate.json: of the circle through the farthest marker corner
  bool round = false;      ///< plate.json states a diameter and no sheet: nothing lies beyond it
  /// A printed sheet in place of a round plate: the paper's extent about the origin, mm ("sheet" of
  /// plate.json, or asSheet).
  std::optional<Eigen::AlignedBox2d> sheet;
  std::vector<Marker> markers;
  /// The side of its markers where a person typed it; else it is as the file, or a guess, has it.
  std::optional<double> typed_marker_mm;
};

struct Board {
  std::string dictionary;
  int squares_x = 0, squares_y = 0;
  double square_mm = 0, marker_mm = 0;
};

/// A stretch whose length is known, its two ends marked by hand on photographs of one side; each
/// end on two photographs at least.
struct KnownLength {
  struct Mark {
    std::string file;       ///< the photograph's name, without a folder
    Eigen::Vector2d pixel;  ///< integer = pixel centre
  };
  Side side = Side::Front;
  double length_mm = 0;
  std::array<std::vector<Mark>, 2> ends;
};

struct CalibrationShot {
  int camera = 0;
  std::filesystem::path file;
};

/// A batch folder as in ../shared/batches/README.md, or the paper's layout (top_images, ...).
struct Batch {
  std::filesystem::path folder;
  Way way = Way::Rig;
  std::vector<Shot> shots;                    ///< sorted by side, camera, stop
  std::vector<CalibrationShot> calibration;   ///< of the ChArUco board; may be empty
  std::vector<CalibrationShot> empty_plates;  ///< the bare plate at stop 0; may be empty
  std::optional<Plate> plate;                 ///< absent in the paper's layout
  std::filesystem::path plate_file;           ///< which says so; empty where there is no plate
  std::optional<Board> board;
  std::vector<KnownLength> known_lengths;  ///< of scale.json; with a plate they check it
};

struct ReadBatchOptions {
  int min_views_per_side = 3;  ///< fewer usable photographs of a side cannot be reconstructed
  /// Way::FreeCamera: photographs of a side beyond this are thinned out. A full turn in steps of 5
  /// degrees, as finely as views differ to stereo; each more costs time and memory.
  int max_free_views = 72;
  /// Way::FreeCamera: smaller photographs are thumbnails; the largest usual ones, of 640 x 480
  /// pixels, have 0.31 megapixels.
  double least_free_megapixels = 0.35;
  std::optional<std::filesystem::path> sheet;  ///< read in place of plate.json in the folder
};

/// Reads the folder's structure and the images' headers; never looks into truth/. A shot that
/// cannot be used is left out with a warning; a missing side or too few views is an error. Whether
/// most names are those of a rig's cameras and positions decides Batch::way; a batch of free
/// cameras may have a front alone.
Result<Batch> readBatch(const std::filesystem::path& folder, const ReadBatchOptions& options,
                        Progress& progress);

/// Pixels of the largest photograph.
double largestPixels(const Batch& batch);
/// Memory that such a photograph takes while it is decoded and its markers are detected, MB.
double originalMb(const Batch& batch);
/// How many of `threads` (0: all processors) may decode one at a time, so that together they take
/// half of the free memory (free_mb; 0: not known), at least 1: fine patterns take twice as much.
int threadsForOriginals(const Batch& batch, int threads, double free_mb);

Result<Plate> readPlate(const std::filesystem::path& file);
/// The same for hand-held photographs, which always show a sheet, even if plate.json describes a
/// plate: without
/// "sheet" the paper is taken around the markers, with as much margin as there is between them, and
/// the frame moved into its middle, since files of others count from a corner. A round plate is as
/// wide as it says, about its own origin.
Plate asSheet(Plate plate);
/// Of a marker's black square, mm: the mean of its four edges.
double sideOf(const Marker& marker);
/// Of all its markers; nothing where they are of several sizes, or none.
std::optional<double> markerSide(const Plate& plate);
/// As large as a person typed a marker's side. plate: markerSide() is known.
Plate withMarkerSide(Plate plate, double side_mm);
Result<Board> readBoard(const std::filesystem::path& file);
/// {"unit":"mm","lengths":[{"side":"front","length":50,"ends":[[{"file","pixel"},...],[...]]}]}
Result<std::vector<KnownLength>> readKnownLengths(const std::filesystem::path& file);

}  // namespace ostraka::batch
