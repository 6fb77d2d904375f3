#include "hull/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "base/parallel.h"

namespace ostraka::hull {
namespace {

constexpr int kFloorLayers = 3;  // a sherd touches the plate somewhere; a hull is a voxel too wide

// Views far apart first: most empty voxels are empty to the first two or three views asked.
std::vector<std::size_t> scatteredOrder(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.382 * count));
  while (std::gcd(stride, count) != 1) ++stride;
  for (std::size_t i = 0; i < count; ++i) order[i] = i * stride % count;
  return order;
}

struct FastCamera {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  const rig::Intrinsics* intrinsics;
  double reach;
};

// Beyond its reach a lens model may fold what lies beside the picture back into it.
bool inSight(const Eigen::Vector3d& p_camera, double reach) {
  return p_camera.z() > 0 && p_camera.head<2>().norm() <= reach * p_camera.z();
}

// Leaves 1 where a thing stands, 0 elsewhere.
void dropFloating(const HullSpace& space, std::vector<unsigned char>& voxels) {
  const Eigen::Vector3i n = space.count;
  const auto index = [&](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * n.y() + y) * n.x() + x;
  };
  const int gap = 1 + kMostGapLayers;
  constexpr unsigned char kStands = 2;
  std::vector<Eigen::Vector3i> open;
  const auto reach = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= n.x() || y >= n.y() || z >= n.z()) return;
    unsigned char& voxel = voxels[index(x, y, z)];
    if (voxel == 0 || voxel == kStands) return;
    voxel = kStands;
    open.emplace_back(x, y, z);
  };
  for (unsigned char& voxel : voxels) voxel = voxel != 0 ? 1 : 0;
  for (int z = 0; z < std::min(kFloorLayers, n.z()); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x) reach(x, y, z);
  while (!open.empty()) {
    const Eigen::Vector3i at = open.back();
    open.pop_back();
    for (int z = at.z() - gap; z <= at.z() + gap; ++z)
      for (int y = at.y() - 1; y <= at.y() + 1; ++y)
        for (int x = at.x() - 1; x <= at.x() + 1; ++x) reach(x, y, z);
  }
  for (unsigned char& voxel : voxels) voxel = voxel == kStands ? 1 : 0;
}

}  // namespace

std::vector<unsigned char> carveHull(const HullSpace& space, std::span<const HullView> views,
                                     const HullOptions& options, std::stop_token stop) {
  const std::vector<std::size_t> order = scatteredOrder(views.size());
  std::vector<FastCamera> cameras;
  for (const std::size_t v : order)
    cameras.push_back({views[v].image->camera_from_plate.linear(),
                       views[v].image->camera_from_plate.translation(), &views[v].image->intrinsics,
                       views[v].image->intrinsics.distortion.reach()});
  const Eigen::Vector3i n = space.count;
  std::vector<unsigned char> voxels(static_cast<std::size_t>(n.x()) * n.y() * n.z(), 0);
  const auto decide = [&](const Eigen::Vector3d& p) {
    double clear = 0, inside = 0;
    int seen = 0;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      const Eigen::Vector3d q = cameras[k].rotation * p + cameras[k].translation;
      if (!inSight(q, cameras[k].reach)) continue;
      const Eigen::Vector2d pixel = cameras[k].intrinsics->project(q);
      const HullView& view = views[order[k]];
      const int x = static_cast<int>(std::floor((pixel.x() + 0.5) / options.reduction));
      const int y = static_cast<int>(std::floor((pixel.y() + 0.5) / options.reduction));
      if (x < 0 || y < 0 || x >= view.clear.cols || y >= view.clear.rows) continue;
      ++seen;
      clear += view.clear(y, x);
      inside += view.inside(y, x);
      if (clear >= options.carving_views) return false;
    }
    return seen >= 2 && inside >= options.inside_share * seen;
  };
  parallelFor(static_cast<std::size_t>(n.y()), options.threads, [&](std::size_t row) {
    if (stop.stop_requested()) return;
    const int y = static_cast<int>(row);
    for (int x = 0; x < n.x(); ++x) {
      const Eigen::Vector3d foot = space.low + space.pitch * Eigen::Vector3d(x, y, 0);
      if (space.radius > 0 && foot.head<2>().norm() > space.radius) continue;
      for (int z = 0; z < n.z(); ++z) {
        const std::size_t index = (static_cast<std::size_t>(z) * n.y() + y) * n.x() + x;
        voxels[index] = decide(foot + Eigen::Vector3d(0, 0, z * space.pitch)) ? 1 : 0;
      }
    }
  });
  return voxels;
}

Silhouette silhouetteOfHull(const HullSpace& space, const std::vector<unsigned char>& voxels,
                            const HullView& view, const HullOptions& options) {
  cv::Mat1b mask(view.clear.size(), uchar{0});
  cv::Mat1f near(view.clear.size(), std::numeric_limits<float>::max()), far(near.size(), 0.F),
      height(near.size(), 0.F);
  const rig::PosedImage& image = *view.image;
  const double reach = image.intrinsics.distortion.reach();
  const Eigen::Vector3i n = space.count;
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x) {
        const unsigned char value = voxels[(static_cast<std::size_t>(z) * n.y() + y) * n.x() + x];
        if (value == 0) continue;
        const Eigen::Vector3d q =
            image.camera_from_plate * (space.low + space.pitch * Eigen::Vector3d(x, y, z));
        if (!inSight(q, reach)) continue;
        const Eigen::Vector2d pixel = image.intrinsics.project(q);
        const double half = 0.87 * space.pitch * image.intrinsics.fx / q.z();
        const auto cell = [&](double v) {
          return static_cast<int>(std::floor((v + 0.5) / options.reduction));
        };
        const auto away = static_cast<float>(q.z());
        const int left = std::max(0, cell(pixel.x() - half)),
                  right = std::min(mask.cols - 1, cell(pixel.x() + half));
        const int bottom = std::min(mask.rows - 1, cell(pixel.y() + half));
        for (int v = std::max(0, cell(pixel.y() - half)); v <= bottom; ++v)
          for (int u = left; u <= right; ++u) {
            far(v, u) = std::max(far(v, u), away);
            if (away >= near(v, u)) continue;
            near(v, u) = away;
            mask(v, u) = value;
            height(v, u) = static_cast<float>((z + 0.5) * space.pitch);
          }
      }
  cv::Mat1f depth(mask.size(), 0.F);
  for (int v = 0; v < mask.rows; ++v)
    for (int u = 0; u < mask.cols; ++u)
      if (mask(v, u) != 0) depth(v, u) = far(v, u) - near(v, u);
  return {mask, depth, height};
}

void keepTouching(const cv::Mat1b& floor, cv::Mat1b& group) {
  cv::Mat labels;
  const int count = cv::connectedComponents(group != 0, labels, 8, CV_32S);
  std::vector<char> touches(static_cast<std::size_t>(count), 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (floor(y, x) != 0) touches[labels.at<int>(y, x)] = 1;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (touches[labels.at<int>(y, x)] == 0) group(y, x) = 0;
}

int dropSmallGroups(const HullSpace& space, std::vector<unsigned char>& voxels, double min_area) {
  dropFloating(space, voxels);
  const Eigen::Vector3i n = space.count;
  cv::Mat1b footprint(n.y(), n.x(), uchar{0});
  const auto index = [&](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * n.y() + y) * n.x() + x;
  };
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x)
        if (voxels[index(x, y, z)] != 0) footprint(y, x) = 255;
  cv::Mat labels, stats, centres;
  const int groups = cv::connectedComponentsWithStats(footprint, labels, stats, centres, 8, CV_32S);
  int left = 0;
  std::vector<unsigned char> number(static_cast<std::size_t>(groups), 0);
  for (int g = 1; g < groups; ++g)
    if (stats.at<int>(g, cv::CC_STAT_AREA) * space.pitch * space.pitch >= min_area)
      number[g] = static_cast<unsigned char>(left++ % kMostGroups + 1);
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x)
        if (voxels[index(x, y, z)] != 0) voxels[index(x, y, z)] = number[labels.at<int>(y, x)];
  return left;
}

void dropGroupsAtSides(const HullSpace& space, std::vector<unsigned char>& voxels) {
  const Eigen::Vector3i n = space.count;
  std::array<bool, kMostGroups + 1> there{}, at_side{};
  std::size_t i = 0;
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x, ++i) {
        there[voxels[i]] = true;
        if (x == 0 || y == 0 || x == n.x() - 1 || y == n.y() - 1) at_side[voxels[i]] = true;
      }
  bool any_inside = false;
  for (std::size_t g = 1; g < there.size(); ++g) any_inside |= there[g] && !at_side[g];
  if (!any_inside) return;
  for (unsigned char& voxel : voxels)
    if (at_side[voxel]) voxel = 0;
}

bool bareAt(const HullSpace& space, const std::vector<unsigned char>& voxels,
            const Eigen::Vector2d& p) {
  const int column = static_cast<int>(std::lround((p.x() - space.low.x()) / space.pitch));
  const int row = static_cast<int>(std::lround((p.y() - space.low.y()) / space.pitch));
  if (column < 0 || row < 0 || column >= space.count.x() || row >= space.count.y()) return false;
  return voxels[static_cast<std::size_t>(row) * space.count.x() + column] == 0;
}

}  // namespace ostraka::hull
