#include "cloud/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "base/median.h"
#include "cloud/nearest.h"

namespace ostraka {
namespace {

void apply(const Eigen::Isometry3d& target_from_source, std::vector<Eigen::Vector3f>& points,
           std::vector<Eigen::Vector3f>& normals) {
  const Eigen::Matrix3d rotation = target_from_source.rotation();
  for (Eigen::Vector3f& p : points) p = (target_from_source * p.cast<double>()).cast<float>();
  for (Eigen::Vector3f& n : normals) n = (rotation * n.cast<double>()).cast<float>();
}

}  // namespace

PointCloud transformed(const PointCloud& cloud, const Eigen::Isometry3d& target_from_source) {
  PointCloud moved = cloud;
  apply(target_from_source, moved.points, moved.normals);
  return moved;
}

TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Isometry3d& target_from_source) {
  TriangleMesh moved = mesh;
  apply(target_from_source, moved.vertices, moved.normals);
  return moved;
}

PointCloud subset(const PointCloud& cloud, const std::vector<int>& indices) {
  PointCloud part;
  const auto pick = [&](const auto& from, auto& to) {
    if (from.size() != cloud.points.size()) return;
    to.reserve(indices.size());
    for (const int i : indices) to.push_back(from[static_cast<std::size_t>(i)]);
  };
  pick(cloud.points, part.points);
  pick(cloud.normals, part.normals);
  pick(cloud.colors, part.colors);
  pick(cloud.quality, part.quality);
  return part;
}

PointCloud oriented(PointCloud cloud) {
  if (!cloud.hasNormals()) return cloud;
  constexpr float kShortest = 1e-12f, kRounded = 1e-4f;  // the latter stays as it is
  std::vector<int> directed;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float length = cloud.normals[i].stableNorm();
    if (!(length > kShortest) || !std::isfinite(length)) continue;
    if (std::abs(length - 1) > kRounded) cloud.normals[i] /= length;
    directed.push_back(static_cast<int>(i));
  }
  if (directed.empty()) cloud.normals.clear();
  return directed.empty() || directed.size() == cloud.size() ? cloud : subset(cloud, directed);
}

PointCloud withoutRepeats(PointCloud cloud) {
  std::vector<int> order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  const auto point = [&](int i) { return cloud.points[static_cast<std::size_t>(i)]; };
  std::ranges::sort(order, {}, [&](int i) {
    const Eigen::Vector3f p = point(i);
    return std::tuple(p.x(), p.y(), p.z(), i);
  });
  const bool has_normals = cloud.hasNormals();
  std::vector<int> kept;
  for (const int i : order) {
    if (kept.empty() || point(i) != point(kept.back()))
      kept.push_back(i);
    else if (has_normals)
      cloud.normals[static_cast<std::size_t>(kept.back())] +=
          cloud.normals[static_cast<std::size_t>(i)];
  }
  if (kept.size() == cloud.size()) return cloud;
  std::ranges::sort(kept);
  return subset(cloud, kept);
}

PointCloud thinned(const PointCloud& cloud, double edge_mm) {
  struct Cube {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0, best = -1;
    double best_distance = 0;
  };
  std::unordered_map<Eigen::Vector3i, int, CellHash> number;
  std::vector<Cube> cubes;  // in order of first appearance
  std::vector<int> cube_of(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    const Eigen::Vector3i key = (p / edge_mm).array().floor().cast<int>();
    const auto [at, is_new] = number.try_emplace(key, static_cast<int>(cubes.size()));
    if (is_new) cubes.emplace_back();
    Cube& cube = cubes[static_cast<std::size_t>(at->second)];
    cube.sum += p;
    ++cube.count;
    cube_of[i] = at->second;
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Cube& cube = cubes[static_cast<std::size_t>(cube_of[i])];
    const double d = (cloud.points[i].cast<double>() - cube.sum / cube.count).squaredNorm();
    if (cube.best < 0 || d < cube.best_distance)
      cube.best = static_cast<int>(i), cube.best_distance = d;
  }
  std::vector<int> kept;
  kept.reserve(cubes.size());
  for (const Cube& cube : cubes) kept.push_back(cube.best);
  return subset(cloud, kept);
}

double medianSpacing(const PointCloud& cloud) {
  if (cloud.size() < 2) return 0;
  const KdTree tree(cloud.points);
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / 2000);
  std::vector<float> distances;
  std::vector<Neighbour> found;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    tree.nearest(cloud.points[i], 2, found);
    distances.push_back(found.back().squared_distance);
  }
  return std::sqrt(static_cast<double>(medianOf(distances)));
}

}  // namespace ostraka
