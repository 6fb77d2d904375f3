#include "capture/shot_checks.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"

namespace ostraka::capture {
namespace {

constexpr double kMostAngleError_deg = 0.5;  // off by more, the photograph is of another stop
constexpr double kMostEdgeGrowth = 1.4;  // edges wider than the sharpest photograph's are a blur
constexpr double kWideEdge_px = 0.5;     // and wider by this: edges are known to 0.1 px
constexpr double kMostDarkShare = 0.3;   // of the sherds' pixels
constexpr double kMostBrightShare = 0.02;

// The nearest angle to `near` that is `angle` but for whole turns.
double unwound(double angle, double near) {
  return angle + 360 * std::round((near - angle) / 360);
}

}  // namespace

Message words(ShotProblem problem) {
  switch (problem) {
    case ShotProblem::Unreadable:
      return message("the file is truncated or not a picture");
    case ShotProblem::WrongStop:
      return message("the markers show an angle other than this position's");
    case ShotProblem::OtherSize:
      return message("the picture's size differs from that of the camera's other pictures");
    case ShotProblem::Unplaced:
      return message(
          "too few markers are visible to identify the position: check that nothing covers them "
          "and that the picture is sharp");
    case ShotProblem::Repeated:
      return message("the camera delivered an earlier photograph again");
    case ShotProblem::FewMarkers:
      return message("too few markers of the plate are visible: check that nothing covers them");
    case ShotProblem::Blurred:
      return message(
          "the picture is blurred: check that the turntable is still and the focus is unchanged");
    case ShotProblem::TooDark:
      return message("the sherds are too dark: add light or increase the exposure time");
    case ShotProblem::TooBright:
      return message("the sherds are overexposed: reduce the exposure time");
    case ShotProblem::CutOff:
      return message("a sherd is cut off by the picture's edge: move it or the camera");
    case ShotProblem::OtherSettings:
      return message("the camera's settings have changed: restore them");
  }
  return {};
}

bool ShotCheck::has(ShotProblem problem) const {
  return std::find(problems.begin(), problems.end(), problem) != problems.end();
}

bool ShotCheck::keepable() const {
  using enum ShotProblem;
  return std::ranges::none_of(problems, [](ShotProblem problem) {
    return problem == Unreadable || problem == WrongStop || problem == Unplaced ||
           problem == OtherSize || problem == Repeated;
  });
}

bool ShotCheck::again() const {
  return !keepable() || may_pass;
}

std::vector<Message> ShotCheck::sentences() const {
  std::vector<Message> all;
  for (const ShotProblem p : problems)
    if (p != ShotProblem::OtherSettings || other_settings.empty()) all.push_back(words(p));
  for (const Message& setting : other_settings) all.push_back(message("%1: restore it", setting));
  return all;
}

ShotCheck checkOf(const PlateInspection& inspection, double angle_deg,
                  const CameraReference& reference) {
  ShotCheck check;
  check.markers_seen = inspection.markers_seen;
  check.markers_on_plate = inspection.markers_on_plate;
  check.sherds = static_cast<int>(inspection.sherds.size());
  check.sharpness = inspection.sharpness;
  const auto add = [&](bool wrong, ShotProblem problem) {
    if (wrong) check.problems.push_back(problem);
  };
  if (reference.inspection) {
    add(inspection.width != reference.inspection->width ||
            inspection.height != reference.inspection->height,
        ShotProblem::OtherSize);
    if (const auto turn = turnBetween_deg(*reference.inspection, inspection)) {
      check.angle_seen_deg = unwound(reference.angle_deg + *turn, angle_deg);
      add(std::abs(*check.angle_seen_deg - angle_deg) > kMostAngleError_deg,
          ShotProblem::WrongStop);
    } else {
      add(true, ShotProblem::Unplaced);
    }
  }
  add(inspection.markers_seen < std::max(kLeastMarkers, reference.markers_seen / 2),
      ShotProblem::FewMarkers);
  add(reference.sharpness > 0 && inspection.sharpness > 0 &&
          inspection.sharpness > kMostEdgeGrowth * reference.sharpness &&
          inspection.sharpness > reference.sharpness + kWideEdge_px,
      ShotProblem::Blurred);
  check.may_pass = check.has(ShotProblem::Blurred) ||
                   (check.has(ShotProblem::FewMarkers) && reference.markers_seen >= kLeastMarkers);
  add(inspection.dark_share > kMostDarkShare, ShotProblem::TooDark);
  add(inspection.bright_share > kMostBrightShare, ShotProblem::TooBright);
  add(std::ranges::any_of(inspection.sherds, [](const SeenSherd& s) { return s.cut_off; }),
      ShotProblem::CutOff);
  return check;
}

void learn(CameraReference& reference, const PlateInspection& inspection, double angle_deg) {
  if (!reference.inspection && inspection.pixel_from_plate) {
    reference.inspection = inspection;
    reference.angle_deg = angle_deg;
  }
  if (inspection.sharpness > 0)
    reference.sharpness = reference.sharpness > 0
                              ? std::min(reference.sharpness, inspection.sharpness)
                              : inspection.sharpness;
  reference.markers_seen = std::max(reference.markers_seen, inspection.markers_seen);
}

}  // namespace ostraka::capture
