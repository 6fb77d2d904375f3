#include "calibration/calibration_advice.h"

#include <cmath>
#include <map>
#include <span>

#include "base/message.h"
#include "base/text.h"
#include "calibration/held_out.h"

namespace ostraka::calibration {
namespace {

constexpr int kFewCornersInRegion = 12;  // distortion there would be extrapolated
constexpr std::size_t kFewPictures = 8;
constexpr int kFewTilted = 4;
constexpr int kFewMarkers = 6;             // of the plate in one photograph
constexpr double kMostFocalError = 0.001;  // relative standard deviation of a good calibration
constexpr double kMostResidual_px = 0.5;   // of a camera that may be relied on

Message enumerated(const std::vector<std::string>& names) {
  if (names.size() < 2) return joined(names, ", ");
  return message("%1 and %2", joined(std::span(names).first(names.size() - 1), ", "), names.back());
}

// Of one to nine phrases.
Message enumerated(const std::vector<Message>& phrases) {
  if (phrases.size() < 2) return phrases.front();
  std::string places;
  std::vector<MessageValue> values;
  for (std::size_t i = 0; i + 1 < phrases.size(); ++i) {
    places += (i == 0 ? "%" : ", %") + std::to_string(i + 1);
    values.emplace_back(phrases[i]);
  }
  return message("%1 and %2", Message(places, values), phrases.back());
}

// Stops at which a camera sees too few markers.
void adviseOnStops(const BatchPoses& poses, std::vector<Message>& missing) {
  std::map<int, std::vector<std::string>> poor;  // by camera
  for (std::size_t i = 0; i < poses.images.size(); ++i)
    if (poses.markers_per_image[i] < kFewMarkers)
      poor[poses.images[i].camera].push_back(std::string(batch::name(poses.images[i].side)) + " " +
                                             std::to_string(poses.images[i].stop + 1));
  for (const auto& [camera, stops] : poor)
    missing.push_back(
        message("Camera %1 sees fewer than six of the plate's markers at position %2; check "
                "lighting and focus there and that nothing covers the markers.",
                batch::cameraLetter(camera), enumerated(stops)));
  if (poses.rig.stops.size() < 4)
    missing.push_back(
        message("Positions photographed: %1; photograph at least four around the full turn to "
                "determine the axis.",
                poses.rig.stops.size()));
}

void adviseOnScale(const CalibrationReport& report, std::vector<Message>& missing) {
  if (report.held_out.empty())
    missing.push_back(message(
        "Fewer than eight markers were detected, so no distance could be held out of the fit: the "
        "scale is not checked."));
  for (const HeldOutDistance& d : report.held_out)
    if (const std::optional<Message> doubt = scaleDoubt(d)) missing.push_back(*doubt);
  for (const MeasuredLength& m : report.lengths) {
    const double error = m.found_mm / m.length.mm - 1;
    if (std::abs(error) > kMostScaleError)
      missing.push_back(message(
          "Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the "
          "plate's ruler and regenerate plate.json with 'ostraka plate --ruler-measured'.",
          m.length.first, m.length.second, decimal(m.length.mm, 2), decimal(m.found_mm, 2),
          decimal(100 * error, 2)));
  }
}

void judge(CalibrationReport& report) {
  for (const CameraCalibration& c : report.cameras) {
    if (c.plate_residual_px <= kMostResidual_px) continue;
    report.verdict = Verdict::NotUsable;
    report.verdict_in_words = message(
        "Not usable: camera %1 misses the plate's markers by a median of %2 px; check that it did "
        "not move between the photographs and that plate.json belongs to this plate.",
        batch::cameraLetter(c.camera), decimal(c.plate_residual_px, 2));
    return;
  }
  if (!scaleIsRight(report)) {
    report.verdict = Verdict::NotUsable;
    report.verdict_in_words = message("Not usable: the scale is wrong.");
    return;
  }
  std::vector<std::string> without_lens;
  for (const CameraCalibration& c : report.cameras)
    if (c.pictures == 0) without_lens.push_back(batch::cameraLetter(c.camera));
  bool exact = true;
  for (const CameraCalibration& c : report.cameras)
    exact = exact && c.focal_sd_px > 0 && c.focal_sd_px < kMostFocalError * c.focal_px;
  report.verdict =
      exact && without_lens.empty() && report.missing.empty() ? Verdict::Good : Verdict::Usable;
  if (report.verdict == Verdict::Good)
    report.verdict_in_words = message("Good: lenses, camera poses and scale are determined.");
  else if (!without_lens.empty())
    report.verdict_in_words = message(
        "Usable for a trial only: the lens of camera %1 comes from the plate's markers alone.",
        enumerated(without_lens));
  else if (!exact)
    report.verdict_in_words =
        message("Usable, but a focal length is uncertain by more than a thousandth.");
  else
    report.verdict_in_words = message("Usable; the steps below improve it.");
}

Message lensWords(const CameraCalibration& c) {
  const std::string camera = batch::cameraLetter(c.camera);
  const Message focal("%1 +- %2", {decimal(c.focal_px, 1), decimal(c.focal_sd_px, 1)});
  const Decimal percent = decimal(100 * c.focal_sd_px / c.focal_px, 3);
  const Decimal rms = decimal(c.lens_rms_px, 3), worst = decimal(c.worst_picture_rms_px, 2),
                tilt = decimal(c.largest_tilt_rad * 180 / M_PI, 0),
                at_plate = decimal(c.plate_residual_px, 3);
  const bool on_plate = c.plate_residual_px > 0;
  if (c.pictures > 0 && on_plate)
    return message(
        "Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with "
        "%7 px, tilted up to %8 degrees, median error at the plate's markers %9 px.",
        camera, focal, percent, c.pictures, rms, c.worst_picture, worst, tilt, at_plate);
  if (c.pictures > 0)
    return message(
        "Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with "
        "%7 px, tilted up to %8 degrees.",
        camera, focal, percent, c.pictures, rms, c.worst_picture, worst, tilt);
  if (on_plate)
    return message(
        "Camera %1: focal length %2 px (%3 %), median error at the plate's markers %4 px.", camera,
        focal, percent, at_plate);
  return message("Camera %1: focal length %2 px (%3 %).", camera, focal, percent);
}

}  // namespace

bool scaleIsRight(const CalibrationReport& report) {
  for (const HeldOutDistance& d : report.held_out)
    if (std::abs(d.error()) > kMostScaleError) return false;
  for (const MeasuredLength& m : report.lengths)
    if (std::abs(m.found_mm / m.length.mm - 1) > kMostScaleError) return false;
  return true;
}

void adviseOnBoard(const CameraCalibration& camera, std::vector<Message>& missing) {
  const std::string name = batch::cameraLetter(camera.camera);
  if (camera.pictures == 0) {
    missing.push_back(
        message("Camera %1: take 12 pictures of the board, near and far, in all corners of the "
                "picture, tilted by 20 to 45 degrees in different directions.",
                name));
    return;
  }
  if (camera.pictures == 1)
    missing.push_back(message(
        "Camera %1: only 1 picture shows the board; take at least 8, preferably 12.", name));
  else if (camera.pictures < kFewPictures)
    missing.push_back(
        message("Camera %1: only %2 pictures show the board; take at least 8, preferably 12.", name,
                camera.pictures));
  constexpr Template<0> kRegions[] = {
      translatable<0>("upper left"),  translatable<0>("upper middle"),
      translatable<0>("upper right"), translatable<0>("left middle"),
      translatable<0>("middle"),      translatable<0>("right middle"),
      translatable<0>("lower left"),  translatable<0>("lower middle"),
      translatable<0>("lower right")};
  std::vector<Message> empty;
  for (std::size_t r = 0; r < 9; ++r)
    if (camera.corners_per_region[r] < kFewCornersInRegion) empty.push_back(message(kRegions[r]));
  if (!empty.empty())
    missing.push_back(
        message("Camera %1: the board barely reaches the %2 of the picture; add pictures with the "
                "board there.",
                name, enumerated(empty)));
  if (camera.tilted_pictures == 0)
    missing.push_back(
        message("Camera %1: no picture shows the board tilted by more than 20 degrees; take at "
                "least four, tilted to different sides.",
                name));
  else if (camera.tilted_pictures == 1)
    missing.push_back(
        message("Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take at "
                "least four, tilted to different sides.",
                name));
  else if (camera.tilted_pictures < kFewTilted)
    missing.push_back(
        message("Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take "
                "at least four, tilted to different sides.",
                name, camera.tilted_pictures));
}

void adviseOnPlate(const BatchPoses& poses, CalibrationReport& report) {
  adviseOnStops(poses, report.missing);
  adviseOnScale(report, report.missing);
  judge(report);
}

std::vector<Message> inWords(const CalibrationReport& report) {
  std::vector<Message> lines;
  for (const CameraCalibration& camera : report.cameras) lines.push_back(lensWords(camera));
  if (report.reprojection_rms_px > 0)
    lines.push_back(message("Reprojection error %1 px over the plate's markers.",
                            decimal(report.reprojection_rms_px, 3)));
  for (const HeldOutDistance& d : report.held_out)
    lines.push_back(
        said(translatable<6>("Scale: markers %1 and %2, held out of the fit, are %3 mm apart "
                             "instead of %4 (%5 mm, %6 %)."),
             d));
  for (const MeasuredLength& m : report.lengths)
    lines.push_back(
        message("Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of "
                "their outer edges, are %4 mm apart in the photographs (%5 %).",
                m.length.first, m.length.second, decimal(m.length.mm, 2), decimal(m.found_mm, 2),
                decimal(100 * (m.found_mm / m.length.mm - 1), 3)));
  for (const Message& one : report.set_aside) lines.push_back(message("Set aside: %1", one));
  lines.push_back(report.verdict_in_words);
  lines.insert(lines.end(), report.missing.begin(), report.missing.end());
  return lines;
}

}  // namespace ostraka::calibration
