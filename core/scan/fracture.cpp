#include "scan/fracture.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "cloud/bounds.h"
#include "cloud/nearest.h"
#include "scan/footprint.h"

namespace ostraka::scan {
namespace {

// 46 degrees: break faces run at 60-90, vessel walls below 40 as a rule.
constexpr double kSteep_rad = 0.80;
constexpr double kFractureEdge_mm = 1.0;  // always fracture: this close to the outline
// Steep points further inside belong to the vessel's shape; walls are 3-10 mm thick, and an oblique
// break is as wide as the wall is thick.
constexpr double kFractureReach_mm = 12.0;

}  // namespace

Eigen::Vector3d estimateUp(const PointCloud& cloud) {
  if (cloud.size() < 3) return Eigen::Vector3d::UnitZ();
  // About 60 cubes along the longest side: even weights, whatever the density of the points.
  const auto [low, high] = boundsOf(cloud.points);
  const double edge = std::max(1e-6, static_cast<double>((high - low).maxCoeff()) / 60);
  const PointCloud even = thinned(cloud, edge);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), facing = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : even.points) mean += p.cast<double>();
  mean /= static_cast<double>(even.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& p : even.points) {
    const Eigen::Vector3d d = p.cast<double>() - mean;
    spread += d * d.transpose();
  }
  for (const Eigen::Vector3f& n : even.normals) facing += n.cast<double>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  Eigen::Vector3d up = axes.eigenvectors().col(0);
  if (facing.norm() > 0) {
    facing.normalize();
    // A deep or tall piece may be thinnest sideways; what is seen faces the viewer all the same.
    if (std::abs(up.dot(facing)) < 0.5) {
      Eigen::Index most = 0;
      (axes.eigenvectors().transpose() * facing).cwiseAbs().maxCoeff(&most);
      up = axes.eigenvectors().col(most);
    }
    if (up.dot(facing) < 0) up = -up;
  }
  return up.normalized();
}

std::vector<std::uint8_t> findFracture(const PointCloud& cloud, const Eigen::Vector3d& up) {
  std::vector<std::uint8_t> fracture(cloud.size(), 0);
  if (cloud.size() < 20 || !cloud.hasNormals()) return fracture;
  const Eigen::Vector3d x = up.unitOrthogonal(), y = up.cross(x);
  std::vector<Eigen::Vector2d> flat(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    flat[i] = {x.dot(p), y.dot(p)};
  }
  const double spacing = std::max(1e-3, medianSpacing(cloud));
  const Footprint footprint(flat, std::max(0.3, 1.5 * spacing));
  const KdTree tree(cloud.points);
  const double steepest = std::cos(kSteep_rad);
  std::vector<Neighbour> near;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double inside = footprint.depth(flat[i]);
    if (inside > kFractureReach_mm) continue;
    if (inside <= kFractureEdge_mm) {
      fracture[i] = 1;
      continue;
    }
    tree.nearest(cloud.points[i], 9, near);  // normals of stereo are 25 degrees off: 9 make 8
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const Neighbour& n : near)
      normal += cloud.normals[static_cast<std::size_t>(n.index)].cast<double>();
    fracture[i] = normal.dot(up) < steepest * normal.norm();
  }
  return fracture;
}

}  // namespace ostraka::scan
