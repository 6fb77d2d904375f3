#include "scan/boundary.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "cloud/nearest.h"

namespace ostraka::scan {
namespace {

// What a photograph shows of a scan: pixels, and depths that are 0 where a point is outside of the
// photograph or turned away.
struct Shown {
  std::vector<cv::Point> pixels;
  std::vector<float> depths;
  cv::Rect window;  // around all that is shown
  double mean_depth = 0;
};

Shown shownIn(const SilhouetteView& view, const PointCloud& cloud, int margin_px) {
  Shown shown;
  shown.pixels.resize(cloud.size());
  shown.depths.resize(cloud.size(), 0);
  const Eigen::Vector3d centre = view.camera.centre();
  const cv::Rect picture({0, 0}, view.mask.size());
  cv::Point low(picture.br()), high(0, 0);
  int count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    const Eigen::Vector3d q = view.camera.camera_from_plate * p;
    if (q.z() <= 0 || cloud.normals[i].cast<double>().dot(centre - p) <= 0) continue;
    const Eigen::Vector2d at = view.camera.intrinsics.project(q);
    const cv::Point pixel(cvRound(at.x()), cvRound(at.y()));
    if (!picture.contains(pixel)) continue;
    shown.pixels[i] = pixel;
    shown.depths[i] = static_cast<float>(q.z());
    shown.mean_depth += q.z();
    ++count;
    low = {std::min(low.x, pixel.x), std::min(low.y, pixel.y)};
    high = {std::max(high.x, pixel.x), std::max(high.y, pixel.y)};
  }
  if (count == 0) return shown;
  shown.mean_depth /= count;
  const cv::Point margin(margin_px, margin_px);
  shown.window = cv::Rect(low - margin, high + margin + cv::Point(1, 1)) & picture;
  return shown;
}

// Distance of each pixel to the border of the mask, px.
cv::Mat1f distanceToBorder(const cv::Mat1b& mask) {
  const cv::Mat1b inside = mask >= 128;
  cv::Mat1b within, border;
  cv::erode(inside, within, cv::Mat());
  border = inside - within;
  cv::Mat1f distance(mask.size(), std::numeric_limits<float>::max());
  if (cv::countNonZero(border) > 0)
    cv::distanceTransform(255 - border, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance;
}

// Takes out what this photograph shows farther inside.
void withdrawInside(const SilhouetteView& view, const PointCloud& cloud, double spacing_mm,
                    const BoundaryOptions& options, std::vector<std::uint8_t>& near_border) {
  const Shown shown = shownIn(view, cloud, static_cast<int>(std::ceil(options.border_px)) + 2);
  if (shown.window.empty()) return;
  const cv::Mat1f distance = distanceToBorder(view.mask(shown.window));
  // Cells wide enough that the nearest surface leaves none of them empty.
  const int cell = std::max(
      1,
      static_cast<int>(std::ceil(1.5 * spacing_mm * view.camera.intrinsics.fx / shown.mean_depth)));
  cv::Mat1f nearest(shown.window.height / cell + 1, shown.window.width / cell + 1,
                    std::numeric_limits<float>::max());
  const auto nearestAt = [&](const cv::Point& p) -> float& { return nearest(p / cell); };
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (shown.depths[i] <= 0) continue;
    float& depth = nearestAt(shown.pixels[i] - shown.window.tl());
    depth = std::min(depth, shown.depths[i]);
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (shown.depths[i] <= 0) continue;
    const cv::Point p = shown.pixels[i] - shown.window.tl();
    if (shown.depths[i] > nearestAt(p) + options.hidden_mm) continue;
    if (distance(p) > options.border_px) near_border[i] = 0;
  }
}

// The largest angle between neighbours that follow each other around a point, seen along the normal
// of the plane that fits them best.
double largestGap(const PointCloud& cloud, int point, const std::vector<Neighbour>& neighbours) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const Neighbour& n : neighbours) mean += cloud.points[static_cast<std::size_t>(n.index)];
  mean /= static_cast<float>(neighbours.size());
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  for (const Neighbour& n : neighbours) {
    const Eigen::Vector3f off = cloud.points[static_cast<std::size_t>(n.index)] - mean;
    scatter += off * off.transpose();
  }
  const Eigen::Matrix3f axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(scatter).eigenvectors();
  std::vector<double> angles;
  for (const Neighbour& n : neighbours) {
    const Eigen::Vector3f off = cloud.points[static_cast<std::size_t>(n.index)] -
                                cloud.points[static_cast<std::size_t>(point)];
    const double x = axes.col(1).dot(off), y = axes.col(2).dot(off);
    if (n.index != point && (x != 0 || y != 0)) angles.push_back(std::atan2(y, x));
  }
  if (angles.empty()) return 0;
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * M_PI - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
  return gap;
}

}  // namespace

std::vector<std::uint8_t> findBoundary(const PointCloud& cloud,
                                       std::span<const SilhouetteView> views,
                                       const BoundaryOptions& options) {
  std::vector<std::uint8_t> boundary(cloud.size(), 1);
  const double spacing_mm = medianSpacing(cloud);
  for (const SilhouetteView& view : views)
    if (!view.mask.empty()) withdrawInside(view, cloud, spacing_mm, options, boundary);
  if (std::find(boundary.begin(), boundary.end(), 1) == boundary.end())
    boundary.assign(cloud.size(), 1);
  const KdTree tree(cloud.points);
  std::vector<Neighbour> neighbours;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (boundary[i] == 0) continue;
    tree.nearest(cloud.points[i], options.neighbours + 1, neighbours);  // itself among them
    if (largestGap(cloud, static_cast<int>(i), neighbours) <= options.gap_rad) boundary[i] = 0;
  }
  return boundary;
}

}  // namespace ostraka::scan
