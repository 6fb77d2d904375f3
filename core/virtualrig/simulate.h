#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "rendering/hand_held.h"
#include "rendering/plate_surface.h"
#include "rig/rig.h"

/// A rig for everybody: vessels are made, broken, laid on a plate and photographed, with the truth.
namespace ostraka::virtualrig {

/// What goes wrong on purpose, to train people and to test the program.
enum class Fault {
  Blur,      ///< one camera is out of focus at three stops of the front, by 2.2 pixels at least
  Missing,   ///< three photographs are not there
  Moved,     ///< a sherd was pushed by 4 mm and 6 degrees in mid-turn of the front
  Covered,   ///< a cloth lies on a third of the markers in the front
  Shadow,    ///< a hand's shadow falls on the plate in three photographs
  Truncated  ///< the files of two photographs end in the middle
};
/// How scans without photographs err.
enum class ScanNoise {
  Scanner,  ///< as a good scanner, or stereo on well-lit clay: 0.05 mm
  Stereo    ///< faces as above, broken edges as stereo leaves them: fat, wavy, full of gaps
};

struct SimulateOptions {
  std::uint64_t seed = 1;
  int sherds = 8;
  /// Things of any shape in place of broken sherds, PLY files as sherdOfMesh reads them; then
  /// `sherds` is not used. Their clay and paint are drawn like the sherds'.
  std::vector<std::filesystem::path> meshes;
  int width = 1600;  ///< pixels; the height is 3/4 of it and the lens scales along
  std::filesystem::path output;
  rendering::PlateColor plate = rendering::PlateColor::Dark;
  bool plain = false;  ///< neither slip nor paint, fine temper only
  /// Share of the sherds with shiny slip or burnish; black, grey and white clays and slips are
  /// drawn among the others. Absent: usual clays, all matte; by hand 0.3.
  std::optional<double> gloss;
  /// Depth of field of a lens at this f-number: on a rig an APS-C camera's, by hand the camera's
  /// own. Absent: a rig is sharp everywhere, and the camera in a hand has its usual one; 0: sharp.
  std::optional<double> fstop;
  bool scramble = false;    ///< the sherds change places at the flip
  int near_duplicates = 0;  ///< groups of two with nearly the same outline; their breaks differ
  int touching = 0;         ///< pairs that lie against each other on both sides
  int stops = 8;
  bool scans_only = false;  ///< noisy scans of both sides instead of photographs
  ScanNoise scan_noise = ScanNoise::Scanner;
  int threads = 0;  ///< 0: all processors; the files do not depend on it
  std::optional<Fault> fault;
  /// Mean radii of the sherds' outlines, largest first, one per sherd; empty: spread as in a bag.
  std::vector<double> radii_mm;
  /// The cameras and stops of a calibrated rig in place of those drawn by chance; `stops` is not
  /// used then, and there are no pictures of the board, since its lenses are known.
  std::optional<rig::Rig> rig;
  /// By hand over a printed sheet in place of a rig; the light and the sherds stand still.
  std::optional<rendering::HandHeldOptions> hand_held;

  /// Names the field that cannot be; nothing else fails before the first file is written.
  Result<void> check() const;
};

/// Writes a batch folder with truth/, as ../shared/batches/README.md tells, or with scans_only one
/// as ../shared/scans. Millimetres, OpenCV cameras, the plate's frame of that side. With
/// Fault::Moved the poses in truth/ are those before the push, the masks as shot. Errors:
/// UnusableInput (an option, files in the folder, more sherds than fit), CannotWrite, Cancelled.
/// The folder is there whole or not at all, whenever the program ends (base/new_folder.h).
Result<void> simulateBatch(const SimulateOptions& options, Progress& progress,
                           std::stop_token stop);

/// Only what belongs to the rig and not to the sherds: plate.json, board.json, the board's
/// photographs and the empty plate, the same bytes as simulateBatch writes. Errors as above.
Result<void> simulateCalibration(const SimulateOptions& options, Progress& progress,
                                 std::stop_token stop);

}  // namespace ostraka::virtualrig
