#include "rig/view_pose.h"

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "base/rounded.h"

namespace ostraka::rig {
namespace {

// What a foreign pattern misses its place by is far more; a marker of ours by far less.
constexpr double kAgreePx = 5.0;

bool inOnePlane(const std::vector<PlacedMarker>& markers) {
  for (const PlacedMarker& marker : markers)
    for (const Eigen::Vector3d& corner : marker.corners)
      if (std::abs(corner.z() - markers[0].corners[0].z()) > 1e-6) return false;
  return true;
}

std::vector<char> agreeing(const std::vector<cv::Point3f>& points,
                           const std::vector<cv::Point2f>& pixels, double tolerance) {
  std::vector<char> agrees(points.size() / 4, 1);
  if (agrees.size() < 3) return agrees;  // two cannot outvote each other
  std::vector<cv::Point2f> flat;
  for (const cv::Point3f& p : points) flat.emplace_back(p.x, p.y);
  std::vector<unsigned char> inlier;
  if (cv::findHomography(flat, pixels, cv::RANSAC, tolerance, inlier, 2000, 0.9999).empty())
    return std::vector<char>(agrees.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!inlier[i]) agrees[i / 4] = 0;
  return agrees;
}

Eigen::Isometry3d toIsometry(const cv::Mat& turn, const cv::Mat& shift) {
  const auto at = [](const cv::Mat& values, int k) { return rounded(values.at<double>(k), 1e-7); };
  return poseFrom(
      {at(turn, 0), at(turn, 1), at(turn, 2), at(shift, 0), at(shift, 1), at(shift, 2)});
}

}  // namespace

std::vector<PlacedMarker> placed(const std::vector<SeenMarker>& seen, const batch::Plate& plate) {
  std::vector<PlacedMarker> markers;
  for (const SeenMarker& one : seen)
    for (std::size_t k = 0; k < plate.markers.size(); ++k)
      if (plate.markers[k].id == one.id) markers.push_back({one, k, plate.markers[k].corners});
  return markers;
}

std::optional<PoseFromMarkers> poseFromMarkers(const std::vector<PlacedMarker>& markers,
                                               const Intrinsics& intrinsics) {
  if (markers.size() < 2) return std::nullopt;
  // In normalised coordinates, so that lens distortion is out of the way.
  std::vector<cv::Point3f> points;
  std::vector<cv::Point2f> pixels;
  for (const PlacedMarker& marker : markers)
    for (int c = 0; c < 4; ++c) {
      const Eigen::Vector3d& p = marker.corners[c];
      const Eigen::Vector2d n = intrinsics.unproject(marker.seen.corners[c]);
      points.emplace_back(p.x(), p.y(), p.z());
      pixels.emplace_back(n.x(), n.y());
    }
  PoseFromMarkers found;
  const bool plane = inOnePlane(markers);
  found.agrees = plane ? agreeing(points, pixels, kAgreePx / intrinsics.fx)
                       : std::vector<char>(markers.size(), 1);
  std::vector<cv::Point3f> good_points;
  std::vector<cv::Point2f> good_pixels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!found.agrees[i / 4]) continue;
    good_points.push_back(points[i]);
    good_pixels.push_back(pixels[i]);
  }
  if (good_points.size() < 8) return std::nullopt;
  try {
    cv::Mat turn, shift;
    const cv::Mat camera = cv::Mat::eye(3, 3, CV_64F);
    const int method = plane ? cv::SOLVEPNP_IPPE : cv::SOLVEPNP_SQPNP;
    if (!cv::solvePnP(good_points, good_pixels, camera, cv::noArray(), turn, shift, false, method))
      return std::nullopt;
    cv::solvePnPRefineLM(good_points, good_pixels, camera, cv::noArray(), turn, shift);
    found.camera_from_plate = toIsometry(turn, shift);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  const bool in_front = found.camera_from_plate.translation().z() > 0;
  if (!in_front || !found.camera_from_plate.matrix().allFinite()) return std::nullopt;
  return found;
}

}  // namespace ostraka::rig
