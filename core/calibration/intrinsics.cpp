#include "calibration/intrinsics.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "base/median.h"
#include "base/message.h"
#include "base/rounded.h"

namespace ostraka::calibration {
namespace {

constexpr std::size_t kMinCorners = 6;
constexpr std::size_t kMinViews = 3;
constexpr double kMinTiltRad = 0.15;  // 9 degrees; calibrations need 20 and more
constexpr double kGoodViewPx = 0.2;   // good optics and flat boards leave 0.03 to 0.2 px

struct Solution {
  cv::Mat matrix, distortion, sd_intrinsics, rms_per_view;
  std::vector<cv::Mat> rotations, translations;
  double rms_px = 0;
};

void round(cv::Mat& values, double step) {
  values.forEach<double>([step](double& value, const int*) { value = rounded(value, step); });
}

// Pixels to a ten-thousandth, terms of the distortion to a hundredth of a millionth.
void round(Solution& s) {
  round(s.matrix, 1e-4);
  round(s.distortion, 1e-8);
  round(s.sd_intrinsics, 1e-8);
  round(s.rms_per_view, 1e-6);
  for (cv::Mat& rotation : s.rotations) round(rotation, 1e-7);
  for (cv::Mat& translation : s.translations) round(translation, 1e-7);
  s.rms_px = rounded(s.rms_px, 1e-6);
}

Result<Solution> solve(std::span<const TargetView* const> views, cv::Size size, int flags) {
  std::vector<std::vector<cv::Point3f>> points;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const TargetView* view : views) {
    auto& p = points.emplace_back();
    auto& q = pixels.emplace_back();
    for (const Eigen::Vector3d& x : view->points) p.emplace_back(x.x(), x.y(), x.z());
    for (const Eigen::Vector2d& x : view->pixels) q.emplace_back(x.x(), x.y());
  }
  Solution s;
  try {
    // Square pixels: an own aspect would only soak up errors. The start has aspect 1.
    s.matrix = cv::initCameraMatrix2D(points, pixels, size, 1.0);
    cv::Mat ignored;
    s.rms_px = cv::calibrateCamera(
        points, pixels, size, s.matrix, s.distortion, s.rotations, s.translations, s.sd_intrinsics,
        ignored, s.rms_per_view, flags | cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_ASPECT_RATIO,
        cv::TermCriteria(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 100, 1e-10));
  } catch (const cv::Exception&) {
    return Error::failed(message("No camera model fits the calibration pictures."));
  }
  if (!std::isfinite(s.rms_px) || !cv::checkRange(s.matrix) || !cv::checkRange(s.distortion))
    return Error::failed(message("No camera model fits the calibration pictures."));
  round(s);
  return s;
}

// Standard deviations in OpenCV's order fx fy cx cy k1 k2 p1 p2 k3.
double sdOf(const Solution& s, int term) {
  return s.sd_intrinsics.at<double>(term);
}

// A distortion term that is smaller than twice its standard deviation is noise: it is kept at zero.
int flagsForUndetermined(const Solution& s) {
  int flags = 0;
  const auto weak = [&](int k) {
    return std::abs(s.distortion.at<double>(k)) < 2 * sdOf(s, 4 + k);
  };
  if (weak(4)) flags |= cv::CALIB_FIX_K3;
  if (weak(2) && weak(3)) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  return flags;
}

IntrinsicsReport reportOf(const Solution& s, std::span<const TargetView* const> views,
                          cv::Size size) {
  IntrinsicsReport report;
  rig::Intrinsics& i = report.intrinsics;
  i.width = size.width;
  i.height = size.height;
  i.fx = s.matrix.at<double>(0, 0);
  i.fy = s.matrix.at<double>(1, 1);
  i.cx = s.matrix.at<double>(0, 2);
  i.cy = s.matrix.at<double>(1, 2);
  for (int k = 0; k < 5; ++k) i.distortion[k] = s.distortion.at<double>(k);
  for (int k = 0; k < 9; ++k) report.sd[k] = sdOf(s, k);
  report.sd[0] = report.sd[1] = std::max(report.sd[0], report.sd[1]);
  report.rms_px = s.rms_px;
  for (std::size_t v = 0; v < views.size(); ++v) {
    report.files.push_back(views[v]->file);
    report.rms_per_view_px.push_back(s.rms_per_view.at<double>(static_cast<int>(v)));
    const cv::Vec3d turn(s.rotations[v].reshape(1, 3)), shift(s.translations[v].reshape(1, 3));
    report.camera_from_target.push_back(
        rig::poseFrom({turn[0], turn[1], turn[2], shift[0], shift[1], shift[2]}));
  }
  const auto& rms = report.rms_per_view_px;
  report.worst_view =
      static_cast<std::size_t>(std::max_element(rms.begin(), rms.end()) - rms.begin());
  return report;
}

// Largest angle between the optical axis and a target's normal, radians.
double largestTilt(const IntrinsicsReport& report) {
  double largest = 0;
  for (const Eigen::Isometry3d& pose : report.camera_from_target)
    largest = std::max(largest, std::acos(std::min(1.0, std::abs(pose.linear()(2, 2)))));
  return largest;
}

void judge(IntrinsicsReport& report) {
  const double focal = report.intrinsics.fx, sd = report.sd[0];
  // Without tilt any focal length explains the views with another distance, and the standard
  // deviation, which holds near the solution only, can look small by chance.
  report.focal_determined = sd < 0.01 * focal && largestTilt(report) > kMinTiltRad;
  if (!report.focal_determined) {
    report.advice.push_back(message(
        "The focal length is not determined: %1 px with a standard deviation of %2 px; take "
        "more pictures, closer and with the board tilted by 20 to 45 degrees in different "
        "directions.",
        decimal(focal, 0), decimal(sd, 0)));
  } else if (largestTilt(report) < 0.25) {
    report.advice.push_back(
        message("No picture shows the board tilted by more than 15 degrees; tilt it more to "
                "separate focal length from distance."));
  }
  if (report.rms_px > 0.3)
    report.advice.push_back(
        message("The corners scatter by %1 px, more than the 0.3 px of sharp pictures of a flat "
                "board; check focus, lighting and the board's flatness.",
                decimal(report.rms_px, 2)));
  const double worst = report.rms_per_view_px[report.worst_view];
  if (worst > kGoodViewPx && worst > 1.5 * medianOf(std::vector(report.rms_per_view_px)))
    report.advice.push_back(
        message("The worst picture is %1 with %2 px; retake it or leave it out.",
                report.files[report.worst_view], decimal(worst, 2)));
}

}  // namespace

Result<IntrinsicsReport> calibrateIntrinsics(std::span<const TargetView> views, int width,
                                             int height) {
  std::vector<const TargetView*> usable;
  std::vector<Message> set_aside;
  for (const TargetView& view : views) {
    if (view.points.size() >= kMinCorners)
      usable.push_back(&view);
    else
      set_aside.push_back(
          message("%1: the board was not detected; the picture is set aside.", view.file));
  }
  if (usable.size() < kMinViews)
    return Error::notEnough(
        message("Calibration pictures that show the board: %1; at least 3 are needed. "
                "Take more pictures of it.",
                usable.size()));
  const cv::Size size(width, height);
  Result<Solution> full = solve(usable, size, 0);
  if (full) {
    const int flags = flagsForUndetermined(*full);
    if (flags != 0) full = solve(usable, size, flags);
  }
  if (!full) return full.error();
  IntrinsicsReport report = reportOf(*full, usable, size);
  report.set_aside = std::move(set_aside);
  judge(report);
  return report;
}

Result<IntrinsicsReport> intrinsicsFromPlate(std::span<const TargetView> views, int width,
                                             int height) {
  std::vector<const TargetView*> usable;
  for (const TargetView& view : views)
    if (view.points.size() >= kMinCorners) usable.push_back(&view);
  if (usable.empty())
    return Error::notEnough(message("No photograph of this camera shows the plate's markers."));
  const cv::Size size(width, height);
  constexpr int kFlags = cv::CALIB_FIX_PRINCIPAL_POINT | cv::CALIB_ZERO_TANGENT_DIST |
                         cv::CALIB_FIX_K2 | cv::CALIB_FIX_K3;
  const Result<Solution> solution = solve(usable, size, kFlags);
  if (!solution) return solution.error();
  IntrinsicsReport report = reportOf(*solution, usable, size);
  judge(report);
  return report;
}

}  // namespace ostraka::calibration
