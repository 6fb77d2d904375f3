#include "texture/view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "texture/flat.h"

namespace ostraka::texture {
namespace {

constexpr int kBorder = 12;         // pixels around the sherd, so that filters have what they need
constexpr double kBeyond_mm = 2.5;  // a tip may lie between two points
constexpr double kPointEdge_mm = 1.5;
constexpr double kNearer_mm = 1;     // than this sherd: what is nearer hides it
constexpr double kMostSlant = 4;     // cells: more would reach through a thin wall
constexpr double kMostCells = 1200;  // of a depth map's longer edge

}  // namespace

std::optional<View> cutOut(const cv::Mat3b& photograph, const cv::Mat1b& mask,
                           const rig::PosedImage& image, const Eigen::Isometry3d& mesh_from_plate,
                           const std::vector<Eigen::Vector3f>& points) {
  View view;
  view.intrinsics = rig::reduced(image.intrinsics, photograph.cols, photograph.rows);
  view.camera_from_mesh = image.camera_from_plate * mesh_from_plate.inverse();
  if (mask.empty() || photograph.empty()) return std::nullopt;
  for (const double x : {0.0, photograph.cols - 1.0})
    for (const double y : {0.0, photograph.rows - 1.0})
      view.reach = std::max(view.reach, 1.05 * view.intrinsics.unproject({x, y}).norm());
  view.reach = std::min(view.reach, view.intrinsics.distortion.reach());
  Eigen::Vector2d low = Eigen::Vector2d::Constant(INFINITY), high = -low;
  double nearest_mm = INFINITY;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = view.camera_from_mesh * point.cast<double>();
    if (!view.isInSight(p)) continue;
    const Eigen::Vector2d pixel = view.intrinsics.project(p);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
    nearest_mm = std::min(nearest_mm, p.z());
  }
  if (!(high.x() >= low.x())) return std::nullopt;
  const double border = kBorder + kBeyond_mm * view.intrinsics.fx / nearest_mm;
  const auto limited = [](double value, int most) {
    return static_cast<int>(std::clamp<double>(value, 0, most));
  };
  const int x0 = limited(std::floor(low.x() - border), photograph.cols);
  const int y0 = limited(std::floor(low.y() - border), photograph.rows);
  const int x1 = limited(std::ceil(high.x() + border), photograph.cols);
  const int y1 = limited(std::ceil(high.y() + border), photograph.rows);
  if (x1 <= x0 || y1 <= y0) return std::nullopt;
  view.corner = {x0, y0};
  view.picture = photograph(cv::Rect(x0, y0, x1 - x0, y1 - y0)).clone();
  // Of the mask only this part is brought to the photograph's size.
  const double sx = static_cast<double>(mask.cols) / photograph.cols;
  const double sy = static_cast<double>(mask.rows) / photograph.rows;
  view.mask.create(view.picture.size());
  for (int y = 0; y < view.mask.rows; ++y)
    for (int x = 0; x < view.mask.cols; ++x)
      view.mask(y, x) = mask(std::min(static_cast<int>((y0 + y + 0.5) * sy), mask.rows - 1),
                             std::min(static_cast<int>((x0 + x + 0.5) * sx), mask.cols - 1));
  view.mask_step = 1 / std::min(sx, sy);
  double most = 0;
  cv::minMaxLoc(view.mask, nullptr, &most);
  return most >= 128 ? std::optional(std::move(view)) : std::nullopt;
}

void hideOthers(View& view, const std::vector<Eigen::Vector3d>& own,
                const std::vector<Eigen::Vector3d>& others) {
  if (others.empty() || own.empty()) return;
  // Cells of a point's edge, where this sherd lies.
  double far_mm = 0;
  for (const Eigen::Vector3d& p : own) far_mm = std::max(far_mm, p.z());
  const double cell = std::max(1.0, kPointEdge_mm * view.intrinsics.fx / std::max(far_mm, 1e-3));
  const auto depthsOf = [&](const std::vector<Eigen::Vector3d>& points) {
    cv::Mat1f depth(static_cast<int>(view.mask.rows / cell) + 1,
                    static_cast<int>(view.mask.cols / cell) + 1, INFINITY);
    for (const Eigen::Vector3d& p : points) {
      if (!view.isInSight(p)) continue;
      const Eigen::Vector2d at = (view.intrinsics.project(p) - view.corner.cast<double>()) / cell;
      if (!(at.x() >= 0 && at.y() >= 0 && at.x() < depth.cols && at.y() < depth.rows)) continue;
      float& nearest = depth(static_cast<int>(at.y()), static_cast<int>(at.x()));
      nearest = std::min(nearest, static_cast<float>(p.z()));
    }
    cv::Mat1f around;
    cv::erode(depth, around, cv::Mat());
    return around;
  };
  const cv::Mat1f own_depth = depthsOf(own), others_depth = depthsOf(others);
  for (int y = 0; y < view.mask.rows; ++y)
    for (int x = 0; x < view.mask.cols; ++x) {
      const int row = static_cast<int>(y / cell), column = static_cast<int>(x / cell);
      if (others_depth(row, column) + kNearer_mm < own_depth(row, column)) view.mask(y, x) = 0;
    }
}

double finestPixel_mm(const TriangleMesh& mesh, const std::vector<View>& views) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : mesh.vertices) middle += p.cast<double>();
  middle /= std::max<double>(1, static_cast<double>(mesh.vertices.size()));
  double finest = 0;
  for (const View& view : views) {
    const double pixel = (view.camera_from_mesh * middle).z() / view.intrinsics.fx;
    if (pixel > 0 && (finest == 0 || pixel < finest)) finest = pixel;
  }
  return finest;
}

DepthMap::DepthMap(const TriangleMesh& mesh, const View& view) {
  const int longest = std::max(view.picture.cols, view.picture.rows);
  stride_ = std::max(1, static_cast<int>(std::ceil(longest / kMostCells)));
  cv::Mat1f depth((view.picture.rows - 1) / stride_ + 1, (view.picture.cols - 1) / stride_ + 1,
                  INFINITY);
  std::vector<Eigen::Vector3d> places;
  std::vector<double> depths;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    const Eigen::Vector3d p = view.camera_from_mesh * vertex.cast<double>();
    if (!view.isInSight(p)) {
      places.emplace_back(0, 0, -1);
      continue;
    }
    const Eigen::Vector2d pixel = view.intrinsics.project(p) - view.corner.cast<double>();
    places.emplace_back(pixel.x() / stride_, pixel.y() / stride_, p.z());
    depths.push_back(p.z());
  }
  pixel_mm_ = depths.empty() ? 0 : stride_ * medianOf(depths) / view.intrinsics.fx;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
    if (std::min({a.z(), b.z(), c.z()}) <= 0) continue;
    forEachInside({a.head<2>(), b.head<2>(), c.head<2>()}, depth.cols, depth.rows, 1e-6,
                  [&](int x, int y, const Eigen::Vector3d& w) {
                    const auto z = static_cast<float>(w[0] * a.z() + w[1] * b.z() + w[2] * c.z());
                    depth(y, x) = std::min(depth(y, x), z);
                  });
  }
  cv::erode(depth, nearest_, cv::Mat());
}

bool DepthMap::sees(const Eigen::Vector2d& pixel, double depth_mm, double cosine) const {
  const int x = static_cast<int>(std::lround(pixel.x() / stride_));
  const int y = static_cast<int>(std::lround(pixel.y() / stride_));
  if (x < 0 || y < 0 || x >= nearest_.cols || y >= nearest_.rows) return false;
  // Within the cells around, a surface that slants away from the camera comes so much nearer.
  const double slant = std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(cosine, 0.1);
  return depth_mm <= nearest_(y, x) + pixel_mm_ * (1.5 + std::min(2.5 * slant, kMostSlant));
}

}  // namespace ostraka::texture
