#include "calibration/calibration_advice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

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

std::string enumerated(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

std::string cameraName(int camera) {
  return "Camera " + batch::cameraLetter(camera);
}

std::string percent(double part, double whole) {
  return fixed(100 * part / whole, 3) + " %";
}

// Stops at which a camera sees too few markers.
void adviseOnStops(const BatchPoses& poses, std::vector<std::string>& missing) {
  std::map<int, std::vector<std::string>> poor;  // by camera
  for (std::size_t i = 0; i < poses.images.size(); ++i)
    if (poses.markers_per_image[i] < kFewMarkers)
      poor[poses.images[i].camera].push_back(std::string(batch::name(poses.images[i].side)) + " " +
                                             std::to_string(poses.images[i].stop + 1));
  for (const auto& [camera, stops] : poor)
    missing.push_back(cameraName(camera) +
                      " sees fewer than six of the plate's markers at position " +
                      enumerated(stops) +
                      "; check lighting and focus there and that nothing covers the markers.");
  if (poses.rig.stops.size() < 4)
    missing.push_back("Only " + std::to_string(poses.rig.stops.size()) +
                      " positions were photographed; photograph at least four around the full turn "
                      "to determine the axis.");
}

void adviseOnScale(const CalibrationReport& report, std::vector<std::string>& missing) {
  if (report.held_out.empty())
    missing.push_back(
        "Fewer than eight markers were detected, so no distance could be held out of the fit: the "
        "scale is not checked.");
  for (const HeldOutDistance& d : report.held_out)
    if (const std::optional<std::string> doubt = scaleDoubt(d)) missing.push_back(*doubt);
  for (const MeasuredLength& m : report.lengths) {
    const double error = m.found_mm / m.length.mm - 1;
    if (std::abs(error) > kMostScaleError)
      missing.push_back("Markers " + std::to_string(m.length.first) + " and " +
                        std::to_string(m.length.second) + ": you measured " +
                        fixed(m.length.mm, 2) + " mm, plate.json says " + fixed(m.found_mm, 2) +
                        " mm (" + fixed(100 * error, 2) +
                        " %); measure the plate's ruler and regenerate plate.json with 'ostraka "
                        "plate --ruler-measured'.");
  }
}

void judge(CalibrationReport& report) {
  for (const CameraCalibration& c : report.cameras) {
    if (c.plate_residual_px <= kMostResidual_px) continue;
    report.verdict = Verdict::NotUsable;
    report.verdict_in_words = "Not usable: " + cameraName(c.camera) +
                              " misses the plate's markers by a median of " +
                              fixed(c.plate_residual_px, 2) +
                              " px; check that it did not move between the photographs and that "
                              "plate.json belongs to this plate.";
    return;
  }
  if (!scaleIsRight(report)) {
    report.verdict = Verdict::NotUsable;
    report.verdict_in_words = "Not usable: the scale is wrong.";
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
    report.verdict_in_words = "Good: lenses, camera poses and scale are determined.";
  else if (!without_lens.empty())
    report.verdict_in_words = "Usable for a trial only: the lens of camera " +
                              enumerated(without_lens) + " comes from the plate's markers alone.";
  else if (!exact)
    report.verdict_in_words = "Usable, but a focal length is uncertain by more than a thousandth.";
  else
    report.verdict_in_words = "Usable; the steps below improve it.";
}

std::string onlyPictures(int count) {
  if (count == 0) return "no picture shows";
  return "only " + std::to_string(count) + (count == 1 ? " picture shows" : " pictures show");
}

std::string lensWords(const CameraCalibration& c) {
  std::string text = cameraName(c.camera) + ": focal length " + fixed(c.focal_px, 1) + " +- " +
                     fixed(c.focal_sd_px, 1) + " px (" + percent(c.focal_sd_px, c.focal_px) + ")";
  if (c.pictures > 0)
    text += ", " + std::to_string(c.pictures) + " pictures of the board with " +
            fixed(c.lens_rms_px, 3) + " px, worst " + c.worst_picture + " with " +
            fixed(c.worst_picture_rms_px, 2) + " px, tilted up to " +
            fixed(c.largest_tilt_rad * 180 / M_PI, 0) + " degrees";
  if (c.plate_residual_px > 0)
    text += ", median error at the plate's markers " + fixed(c.plate_residual_px, 3) + " px";
  return text + ".";
}

}  // namespace

bool scaleIsRight(const CalibrationReport& report) {
  for (const HeldOutDistance& d : report.held_out)
    if (std::abs(d.error()) > kMostScaleError) return false;
  for (const MeasuredLength& m : report.lengths)
    if (std::abs(m.found_mm / m.length.mm - 1) > kMostScaleError) return false;
  return true;
}

void adviseOnBoard(const CameraCalibration& camera, std::vector<std::string>& missing) {
  const std::string name = cameraName(camera.camera);
  if (camera.pictures == 0) {
    missing.push_back(name +
                      ": take 12 pictures of the board, near and far, in all corners of the "
                      "picture, tilted by 20 to 45 degrees in different directions.");
    return;
  }
  if (camera.pictures < kFewPictures)
    missing.push_back(name + ": " + onlyPictures(camera.pictures) +
                      " the board; take at least 8, preferably 12.");
  constexpr const char* kRegions[] = {"upper left",  "upper middle", "upper right",
                                      "left middle", "middle",       "right middle",
                                      "lower left",  "lower middle", "lower right"};
  std::vector<std::string> empty;
  for (std::size_t r = 0; r < 9; ++r)
    if (camera.corners_per_region[r] < kFewCornersInRegion) empty.emplace_back(kRegions[r]);
  if (!empty.empty())
    missing.push_back(name + ": the board barely reaches the " + enumerated(empty) +
                      " of the picture; add pictures with the board there.");
  if (camera.tilted_pictures < kFewTilted)
    missing.push_back(
        name + ": " + onlyPictures(camera.tilted_pictures) +
        " the board tilted by more than 20 degrees; take at least four, tilted to different "
        "sides.");
}

void adviseOnPlate(const BatchPoses& poses, CalibrationReport& report) {
  adviseOnStops(poses, report.missing);
  adviseOnScale(report, report.missing);
  judge(report);
}

std::vector<std::string> inWords(const CalibrationReport& report) {
  std::vector<std::string> lines;
  for (const CameraCalibration& camera : report.cameras) lines.push_back(lensWords(camera));
  if (report.reprojection_rms_px > 0)
    lines.push_back("Reprojection error " + fixed(report.reprojection_rms_px, 3) +
                    " px over the plate's markers.");
  for (const HeldOutDistance& d : report.held_out) lines.push_back("Scale: " + sentence(d) + ".");
  for (const MeasuredLength& m : report.lengths)
    lines.push_back("Scale: markers " + std::to_string(m.length.first) + " and " +
                    std::to_string(m.length.second) + ", measured by hand as " +
                    fixed(m.length.mm, 2) + " mm between the midpoints of their outer edges, are " +
                    fixed(m.found_mm, 2) + " mm apart in the photographs (" +
                    fixed(100 * (m.found_mm / m.length.mm - 1), 3) + " %).");
  for (const std::string& one : report.set_aside) lines.push_back("Set aside: " + one);
  lines.push_back(report.verdict_in_words);
  lines.insert(lines.end(), report.missing.begin(), report.missing.end());
  return lines;
}

}  // namespace ostraka::calibration
