#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::capture {

/// What is wrong with a photograph; each has its own sentence in words().
enum class ShotProblem {
  Unreadable,  ///< cut off or no picture: never kept
  WrongStop,   ///< the markers show another angle than the stop's: never kept
  OtherSize,   ///< not the size of this camera's other photographs: never kept
  FewMarkers,  ///< too few markers of the plate are seen
  Blurred,     ///< less sharp than this camera's other photographs
  TooDark,     ///< sherds under 5 % in a channel
  TooBright,   ///< sherds burnt out
  CutOff       ///< a sherd touches the frame of the photograph
};
std::string words(ShotProblem problem);
bool mustNotBeKept(ShotProblem problem);

/// A sherd as seen in one picture.
struct SeenSherd {
  std::vector<Eigen::Vector2f> outline_px;  ///< closed, in pixels of the picture looked at
  Eigen::Vector2d centre_mm{0, 0};          ///< on the plate, when its markers are seen
  bool cut_off = false;
};

/// What one picture (a preview or a photograph) shows of the plate.
struct PlateLook {
  int width = 0, height = 0;  ///< pixels of the picture
  int markers_seen = 0, markers_on_plate = 0;
  std::vector<SeenSherd> sherds;               ///< from left to right
  std::vector<std::pair<int, int>> too_close;  ///< indices into sherds: they touch or nearly do
  double sharpness = 0;  ///< width in pixels of the markers' edges: small is sharp; 0 = unknown
  double dark_share = 0, bright_share = 0;  ///< of the sherds' pixels: under 5 %, over 98 %
  /// Where the plate stands in the picture: pixel = H * (x, y, 1) on the plate, mm.
  std::optional<Eigen::Matrix3d> pixel_from_plate;
};

struct LookOptions {
  int work_width_px = 1000;         ///< pictures are looked at in this size: 0.2 s a photograph
  double too_close_mm = 3.0;        ///< nearer sherds count as touching
  double smallest_sherd_mm = 12.0;  ///< smaller spots are crumbs
  Result<void> check() const;
};

/// Looks at an encoded picture (JPEG, PNG, TIFF). Errors: UnusableInput, not decodable or cut off.
Result<PlateLook> lookAtPlate(std::string_view picture, const batch::Plate& plate,
                              const LookOptions& options);

/// By how many degrees the plate turned, counter-clockwise from above, between two pictures of one
/// camera that stands still; -180..180. No calibration is needed: the plate turns in its own plane.
/// Nothing when either shows too few markers.
std::optional<double> turnBetween_deg(const PlateLook& before, const PlateLook& after);

/// The verdict on one photograph.
struct ShotCheck {
  std::vector<ShotProblem> problems;
  int markers_seen = 0, markers_on_plate = 0;
  int sherds = 0;
  double sharpness = 0;
  std::optional<double> angle_seen_deg;  ///< absolute, as the stop's angle
  bool good() const { return problems.empty(); }
  bool keepable() const;
};

/// Before the flip and before clearing, from all photographs of a side.
struct SideCheck {
  int sherds = 0;                              ///< on the plate, the cameras together
  std::vector<std::pair<int, int>> too_close;  ///< numbers from 1, by the highest camera's look
  std::vector<std::string> sentences;          ///< what a person should know before going on
};

}  // namespace ostraka::capture
