#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::capture {

/// What is wrong with a photograph; each has its own sentence in words().
enum class ShotProblem {
  Unreadable,    ///< cut off or no picture: never kept
  WrongStop,     ///< the markers show another angle than the stop's: never kept
  OtherSize,     ///< not the size of this camera's other photographs: never kept
  Unplaced,      ///< too few markers to tell the stop, where others of the camera do: never kept
  Repeated,      ///< the very bytes of an earlier photograph: never kept
  FewMarkers,    ///< too few markers of the plate are seen
  Blurred,       ///< less sharp than this camera's other photographs
  TooDark,       ///< sherds under 5 % in a channel
  TooBright,     ///< sherds burnt out
  CutOff,        ///< a sherd touches the frame of the photograph
  OtherSettings  ///< exposure, focus or another setting is not the rig's, or the first shot's
};
Message words(ShotProblem problem);

/// A sherd as seen in one picture.
struct SeenSherd {
  std::vector<Eigen::Vector2f> outline_px;  ///< closed, in pixels of the picture looked at
  Eigen::Vector2d centre_mm{0, 0};          ///< on the plate, when its markers are seen
  bool cut_off = false;
};

/// A marker of the plate: seen, or where it should be seen.
struct PlateMark {
  int id = 0;
  std::array<Eigen::Vector2f, 4> corners_px;  ///< in pixels of the picture looked at
  bool seen = false;
};

/// What one picture (a preview or a photograph) shows of the plate.
struct PlateInspection {
  int width = 0, height = 0;  ///< pixels of the picture
  int markers_seen = 0, markers_on_plate = 0;
  /// Those that are seen and, once the plate's place is known, those within the frame that are not.
  std::vector<PlateMark> marks;
  std::vector<SeenSherd> sherds;  ///< in the order of comesBefore(), as the results have them
  /// Indices into sherds: so close that one hides the other's foot. Twice the same: one outline
  /// that looks like two sherds.
  std::vector<std::pair<int, int>> too_close;
  double sharpness = 0;  ///< width in pixels of the markers' edges: small is sharp; 0 = unknown
  double dark_share = 0, bright_share = 0;  ///< of the sherds' pixels: under 5 %, over 98 %
  /// Where the plate stands in the picture: pixel = H * (x, y, 1) on the plate, mm.
  std::optional<Eigen::Matrix3d> pixel_from_plate;
};

/// For the plate's place: one marker's corners alone tilt the plane.
inline constexpr int kLeastMarkers = 4;

struct InspectionOptions {
  int work_width_px = 1600;  ///< larger pictures are made smaller, but for the sharpness
  /// Of the plate seen between two outlines; a wall of 10 mm hides as much from 60 degrees above.
  /// 0: nobody asks, which takes half the time.
  double too_close_mm = 5.0;
  double touching_mm = 3.0;         ///< over all stops: nearer sherds count as touching
  double smallest_sherd_mm = 12.0;  ///< smaller spots are crumbs
};

/// Looks at an encoded picture (JPEG, PNG, TIFF). Errors: UnusableInput, not decodable or cut off.
Result<PlateInspection> inspectPlate(std::string_view picture, const batch::Plate& plate,
                                     const InspectionOptions& options);

/// How many of a plate's markers a picture must show before anybody shoots: half of them, so that a
/// hand or a sherd before some does no harm, and never fewer than the plate's place takes.
int markersNeeded(int on_plate);

/// By how many degrees the plate turned, counter-clockwise from above, between two pictures of one
/// camera that stands still; -180..180. No calibration is needed: the plate turns in its own plane.
/// Nothing when either shows too few markers.
std::optional<double> turnBetween_deg(const PlateInspection& before, const PlateInspection& after);

/// The verdict on one photograph.
struct ShotCheck {
  std::vector<ShotProblem> problems;
  int markers_seen = 0, markers_on_plate = 0;
  int sherds = 0;
  double sharpness = 0;                  ///< as PlateInspection
  std::optional<double> angle_seen_deg;  ///< absolute, as the stop's angle
  bool good() const { return problems.empty(); }
  bool has(ShotProblem problem) const;
  bool keepable() const;  ///< no problem that forbids it
  bool again() const;     ///< a problem that another photograph may not have
  /// What each problem is, in words.
  std::vector<Message> sentences() const;
  /// Blurred, or markers hidden that this camera has seen before.
  bool may_pass = false;
  /// Of OtherSettings: "exposure is 1/60, the rig says 1/8".
  std::vector<Message> other_settings;
};

/// What one camera's photographs of a side have shown so far.
struct CameraReference {
  std::optional<PlateInspection> inspection;  ///< of a kept photograph with enough markers
  double angle_deg = 0;                       ///< of that stop
  double sharpness = 0;                       ///< of the sharpest so far
  int markers_seen = 0;                       ///< most so far
};

/// angle_deg: of the stop at which it was taken.
ShotCheck checkOf(const PlateInspection& inspection, double angle_deg,
                  const CameraReference& reference);
/// A kept photograph joins what the next ones are compared with.
void learn(CameraReference& reference, const PlateInspection& inspection, double angle_deg);

/// Before the flip and before clearing, from the photographs of a side.
struct SideCheck {
  int sherds = 0;                       ///< on the plate; each of two that touch counts
  int touching = 0;                     ///< pairs that touch or nearly do
  int doubtful = 0;                     ///< pieces counted as one that may be two
  bool counted = false;                 ///< false: no photograph showed enough of the plate
  std::vector<Eigen::Vector3d> places;  ///< of the pieces: x, y on the plate, mm, and area, mm2
  std::vector<Message> sentences;       ///< what a person should know before going on
};

/// Counts over all stops of the camera that looks down most steeply: shadows stay with the room,
/// sherds turn with the plate. photographs: the side's files by camera, in the order of the stops.
/// About 0.1 s a photograph of that camera. Unreadable files are left out.
SideCheck checkSide(const std::vector<std::vector<std::filesystem::path>>& photographs,
                    const batch::Plate& plate, const InspectionOptions& options,
                    std::stop_token stop);

}  // namespace ostraka::capture
