#pragma once
#include <Eigen/Core>
#include <compare>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::decisions {

enum class MaskPaint { Sherd, Plate };

/// One stroke of a person's brush over the mask of one photograph.
struct MaskStroke {
  batch::Side side = batch::Side::Front;
  int camera = 0, stop = 0;
  MaskPaint paint = MaskPaint::Sherd;
  double radius_px = 0;
  std::vector<Eigen::Vector2d> path_px;  ///< one point or more, in the photograph's own pixels
  std::string photograph;                ///< SHA-256 of its file
  std::string by, at;                    ///< initials; UTC, 2026-07-14T09:30:12Z
  bool operator==(const MaskStroke&) const = default;
};

/// OUT/mask_strokes.json, in the order painted; none when there is no such file. What the program
/// computes never changes it. Errors: UnusableInput names the file; also of more strokes or points
/// on a photograph than limits.h allows, which are not written, either.
Result<std::vector<MaskStroke>> readMaskStrokes(const std::filesystem::path& output);
/// The same from the file's text; `where` names the file in errors.
Result<std::vector<MaskStroke>> parseMaskStrokes(std::string_view text, const std::string& where);
/// All of them; an empty list takes the masks back to those of the program.
Result<void> writeMaskStrokes(const std::filesystem::path& output,
                              const std::vector<MaskStroke>& strokes);

/// The strokes are others than those that the results of OUT follow. False without results.
bool masksWantComputing(const std::filesystem::path& output);

nlohmann::ordered_json toJson(const std::vector<MaskStroke>& strokes);
/// All of mask_strokes.json, as parseMaskStrokes reads it.
std::string textOf(const std::vector<MaskStroke>& strokes);

/// Those on the photograph of a side, camera and stop, in the order painted. Where it was taken
/// again (its file has another hash) sherds may lie elsewhere: those before hold no more.
struct StrokesOn {
  std::vector<MaskStroke> holding;
  bool taken_again = false;  ///< there are others, of a photograph before
};
StrokesOn strokesOn(const std::vector<MaskStroke>& strokes, batch::Side side, int camera, int stop,
                    const std::string& photograph_sha256);
/// Of the file's bytes; empty when it cannot be read.
std::string photographHash(const std::filesystem::path& photograph);

/// The photograph that a stroke is on. One that was taken again is another one.
struct PaintedPhotograph {
  batch::Side side = batch::Side::Front;
  int stop = 0, camera = 0;
  std::string sha256;
  auto operator<=>(const PaintedPhotograph&) const = default;
  std::string name() const;  ///< as its file is called: front/cam1_pos00
};
PaintedPhotograph paintedOn(const MaskStroke& stroke);
std::map<PaintedPhotograph, std::vector<MaskStroke>> byPhotograph(
    const std::vector<MaskStroke>& strokes);
/// The list is the other one, perhaps with more strokes behind it.
bool goesOn(const std::vector<MaskStroke>& list, const std::vector<MaskStroke>& other);
std::string hashOf(const std::vector<MaskStroke>& strokes);

/// Before a batch's number, the key of the project's setting that tells which strokes its file has,
/// so that they are missed when they are gone.
inline constexpr const char* kKnownStrokes = "mask_strokes.";
/// Of each photograph how many, and their hash.
std::string knownText(const std::vector<MaskStroke>& strokes);
/// The strokes that such a text tells of are the first of their photographs. A text that cannot be
/// read tells of none.
bool haveKnown(const std::vector<MaskStroke>& strokes, const std::string& known);
/// Of each photograph those with which both lists begin.
std::vector<MaskStroke> commonStart(const std::vector<MaskStroke>& a,
                                    const std::vector<MaskStroke>& b);

/// Before a photograph's name, the field of the history of a batch that tells which lists of its
/// strokes, by their hashes, were left for which.
inline constexpr const char* kStrokesField = "strokes/";

/// mask: 0..255 as in mask/masks.h, of the photograph's size.
void paintStroke(cv::Mat1b& mask, const MaskStroke& stroke);

/// A photograph whose mask a run left, where it lies now (photographNow).
struct MaskedPhotograph {
  batch::Side side = batch::Side::Front;
  int camera = 0, stop = 0;
  std::filesystem::path photograph, mask;  ///< mask: the program's own, without strokes
};
/// In the order of sides, stops and cameras. Errors: UnusableInput when there are no whole masks.
Result<std::vector<MaskedPhotograph>> maskedPhotographs(const std::filesystem::path& output);

/// The folder under OUT/work with the masks that count: edited_front when people painted on it and
/// a run has followed, else masks_front.
std::string maskFolder(const std::filesystem::path& output, batch::Side side);

/// Whether there are masks to edit: a batch of scans never has any, another one once they are
/// found.
bool hasMasks(const std::filesystem::path& output);

}  // namespace ostraka::decisions
