#include "texture/view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "texture/flat.h"

namespace ostraka::texture {
namespace {

constexpr int kBorder = 12;         // pixels around the sherd, so that filters have what they need
constexpr double kMostCells = 600;  // of a depth map's longer edge

}  // namespace

std::optional<View> cutOut(const cv::Mat3b& photograph, const cv::Mat1b& mask,
                           const rig::PosedImage& image, const Eigen::Isometry3d& mesh_from_plate,
                           const std::vector<Eigen::Vector3f>& points) {
  View view;
  view.intrinsics = rig::reduced(image.intrinsics, photograph.cols, photograph.rows);
  view.camera_from_mesh = image.camera_from_plate * mesh_from_plate.inverse();
  Eigen::Vector2d low = Eigen::Vector2d::Constant(INFINITY), high = -low;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = view.camera_from_mesh * point.cast<double>();
    if (p.z() <= 0) continue;
    const Eigen::Vector2d pixel = view.intrinsics.project(p);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  if (!(high.x() >= low.x())) return std::nullopt;
  const auto limited = [](double value, int most) {
    return static_cast<int>(std::clamp<double>(value, 0, most));
  };
  const int x0 = limited(std::floor(low.x()) - kBorder, photograph.cols);
  const int y0 = limited(std::floor(low.y()) - kBorder, photograph.rows);
  const int x1 = limited(std::ceil(high.x()) + kBorder, photograph.cols);
  const int y1 = limited(std::ceil(high.y()) + kBorder, photograph.rows);
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
  return view;
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
    if (p.z() <= 0) {
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
  return depth_mm <= nearest_(y, x) + pixel_mm_ * (1.5 + 2.5 * slant);
}

}  // namespace ostraka::texture
