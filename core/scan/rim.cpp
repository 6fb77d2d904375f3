#include "scan/rim.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "cloud/nearest.h"

namespace ostraka::scan {
namespace {

/// Occupied cells of a cloud seen along up, and each cell's distance to the outside.
class Footprint {
 public:
  Footprint(const std::vector<Eigen::Vector2d>& points, double cell_mm) : cell_mm_(cell_mm) {
    low_ = points[0];
    Eigen::Vector2d high = points[0];
    for (const Eigen::Vector2d& p : points) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
    low_.array() -= 2.5 * cell_mm;
    columns_ = static_cast<int>((high.x() - low_.x()) / cell_mm) + 4;
    rows_ = static_cast<int>((high.y() - low_.y()) / cell_mm) + 4;
    const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    std::vector<std::uint8_t> filled(cells, 0);
    for (const Eigen::Vector2d& p : points) filled[cellOf(p)] = 1;
    distance_.assign(cells, 1e9);
    markOutside(filled);
    sweep();
  }

  /// Distance to the outside in cells' units times the cell: 3-4 chamfer, 6 % accurate. mm.
  double distance(const Eigen::Vector2d& p) const { return distance_[cellOf(p)]; }

 private:
  std::size_t cellOf(const Eigen::Vector2d& p) const {
    const int c = static_cast<int>((p.x() - low_.x()) / cell_mm_);
    const int r = static_cast<int>((p.y() - low_.y()) / cell_mm_);
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(c);
  }

  /// Empty cells reached from the corner: holes inside the scan are no outside.
  void markOutside(const std::vector<std::uint8_t>& filled) {
    std::vector<std::size_t> stack{0};
    distance_[0] = 0;
    while (!stack.empty()) {
      const std::size_t cell = stack.back();
      stack.pop_back();
      const int r = static_cast<int>(cell) / columns_, c = static_cast<int>(cell) % columns_;
      const auto visit = [&](int row, int column) {
        if (row < 0 || column < 0 || row >= rows_ || column >= columns_) return;
        const std::size_t next =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column);
        if (filled[next] || distance_[next] == 0) return;
        distance_[next] = 0;
        stack.push_back(next);
      };
      visit(r - 1, c), visit(r + 1, c), visit(r, c - 1), visit(r, c + 1);
    }
  }

  void sweep() {
    const auto relax = [&](int r, int c, int dr, int dc, double step) {
      const int row = r + dr, column = c + dc;
      if (row < 0 || column < 0 || row >= rows_ || column >= columns_) return;
      const auto index = [&](int y, int x) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(x);
      };
      double& here = distance_[index(r, c)];
      here = std::min(here, distance_[index(row, column)] + step * cell_mm_);
    };
    constexpr double kSide = 0.95509, kCorner = 1.36930;  // Borgefors 1986, optimal 3x3 chamfer
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c) {
        relax(r, c, -1, -1, kCorner), relax(r, c, -1, 0, kSide);
        relax(r, c, -1, 1, kCorner), relax(r, c, 0, -1, kSide);
      }
    }
    for (int r = rows_ - 1; r >= 0; --r) {
      for (int c = columns_ - 1; c >= 0; --c) {
        relax(r, c, 1, 1, kCorner), relax(r, c, 1, 0, kSide);
        relax(r, c, 1, -1, kCorner), relax(r, c, 0, 1, kSide);
      }
    }
  }

  double cell_mm_;
  Eigen::Vector2d low_;
  int columns_ = 0, rows_ = 0;
  std::vector<double> distance_;
};

}  // namespace

Result<void> RimOptions::check() const {
  const auto bad = [](const char* what) { return Error{ErrorCode::UnusableInput, what, {}}; };
  if (!(steep_rad > 0 && steep_rad < 1.57)) return bad("steep_rad must lie between 0 and 1.57.");
  if (!(edge_mm >= 0)) return bad("edge_mm must not be negative.");
  if (!(reach_mm >= edge_mm)) return bad("reach_mm must not be less than edge_mm.");
  return {};
}

Eigen::Vector3d estimateUp(const PointCloud& cloud) {
  if (cloud.size() < 3) return Eigen::Vector3d::UnitZ();
  // About 60 cubes along the longest side: even weights, whatever the density of the points.
  Eigen::Vector3f low = cloud.points[0], high = cloud.points[0];
  for (const Eigen::Vector3f& p : cloud.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
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

std::vector<std::uint8_t> findRim(const PointCloud& cloud, const RimOptions& options) {
  std::vector<std::uint8_t> rim(cloud.size(), 0);
  if (cloud.size() < 20 || !cloud.hasNormals()) return rim;
  const Eigen::Vector3d up = options.up.norm() > 0.5 ? options.up.normalized() : estimateUp(cloud);
  const Eigen::Vector3d x = up.unitOrthogonal(), y = up.cross(x);
  std::vector<Eigen::Vector2d> flat(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    flat[i] = {x.dot(p), y.dot(p)};
  }
  const double spacing = std::max(1e-3, medianSpacing(cloud));
  const Footprint footprint(flat, std::max(0.3, 1.5 * spacing));
  const KdTree tree(cloud.points);
  const double steepest = std::cos(options.steep_rad);
  std::vector<Neighbour> near;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double inside = footprint.distance(flat[i]);
    if (inside > options.reach_mm) continue;
    if (inside <= options.edge_mm) {
      rim[i] = 1;
      continue;
    }
    tree.nearest(cloud.points[i], 9, near);  // normals of stereo are 25 degrees off: 9 make 8
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const Neighbour& n : near)
      normal += cloud.normals[static_cast<std::size_t>(n.index)].cast<double>();
    rim[i] = normal.dot(up) < steepest * normal.norm();
  }
  return rim;
}

}  // namespace ostraka::scan
