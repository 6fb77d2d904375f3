#include "pairing/alpha_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "base/message.h"
#include "cloud/bounds.h"

namespace ostraka::pairing {
namespace {

/// Points in square cells; a cell's points are contiguous in `order`.
class PlanarGrid {
 public:
  PlanarGrid(std::span<const Eigen::Vector2d> points, double cell_mm)
      : points_(points), cell_mm_(cell_mm) {
    const auto [low, high] = boundsOf(points);
    low_ = low;
    columns_ = static_cast<int>((high.x() - low_.x()) / cell_mm) + 1;
    rows_ = static_cast<int>((high.y() - low_.y()) / cell_mm) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Eigen::Vector2d& p : points) ++first_[cellOf(p) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    order_.resize(points.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      order_[static_cast<std::size_t>(next[cellOf(points[i])]++)] = static_cast<int>(i);
    }
  }

  std::size_t cells() const { return first_.size() - 1; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t cellOf(const Eigen::Vector2d& p) const {
    const int c = std::clamp(static_cast<int>((p.x() - low_.x()) / cell_mm_), 0, columns_ - 1);
    const int r = std::clamp(static_cast<int>((p.y() - low_.y()) / cell_mm_), 0, rows_ - 1);
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(c);
  }
  std::span<const int> inCell(std::size_t cell) const {
    return {order_.data() + first_[cell],
            static_cast<std::size_t>(first_[cell + 1] - first_[cell])};
  }

  /// Calls visit(cell) for the block of cells within `reach` cells around the given one.
  template <class Visit>
  void around(std::size_t cell, int reach, Visit visit) const {
    const int r0 = static_cast<int>(cell) / columns_, c0 = static_cast<int>(cell) % columns_;
    for (int r = std::max(0, r0 - reach); r <= std::min(rows_ - 1, r0 + reach); ++r) {
      for (int c = std::max(0, c0 - reach); c <= std::min(columns_ - 1, c0 + reach); ++c) {
        visit(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(c));
      }
    }
  }

 private:
  std::span<const Eigen::Vector2d> points_;
  double cell_mm_;
  Eigen::Vector2d low_;
  int columns_ = 0, rows_ = 0;
  std::vector<int> first_, order_;
};

/// Per cell whether it belongs to the group of touching occupied cells that holds most points; of
/// equals to the first, row by row.
std::vector<std::uint8_t> largestGroup(const PlanarGrid& grid) {
  cv::Mat1b occupied(grid.rows(), grid.columns());
  for (std::size_t i = 0; i < grid.cells(); ++i) occupied.data[i] = grid.inCell(i).empty() ? 0 : 1;
  cv::Mat1i group;
  std::vector<std::size_t> points(cv::connectedComponents(occupied, group, 8, CV_32S));
  for (std::size_t i = 0; i < grid.cells(); ++i)
    points[group(static_cast<int>(i))] += grid.inCell(i).size();
  int best = 0;  // the empty cells
  for (const int one : group)
    if (points[one] > points[best]) best = one;
  std::vector<std::uint8_t> chosen;
  for (const int one : group) chosen.push_back(one == best);
  return chosen;
}

struct Roll {
  int next = -1;
  Eigen::Vector2d centre;
};

/// Turns the disc counter-clockwise about the point it touches until it meets the next point.
Roll rollOn(const PlanarGrid& grid, const std::vector<std::uint8_t>& chosen,
            std::span<const Eigen::Vector2d> points, int at, const Eigen::Vector2d& centre,
            double alpha) {
  const Eigen::Vector2d p = points[static_cast<std::size_t>(at)];
  const Eigen::Vector2d arm = centre - p;
  Roll best;
  double best_turn = 1e9;
  grid.around(grid.cellOf(p), 2, [&](std::size_t cell) {
    if (!chosen[cell]) return;
    for (const int i : grid.inCell(cell)) {
      const Eigen::Vector2d step = points[static_cast<std::size_t>(i)] - p;
      const double d = step.norm();
      if (i == at || d < 1e-9 || d > 2 * alpha) continue;
      // On the way around, the disc lies to the right of the step from one point to the next.
      const Eigen::Vector2d right(step.y() / d, -step.x() / d);
      const Eigen::Vector2d reached = step / 2 + right * std::sqrt(alpha * alpha - d * d / 4);
      double turn = std::atan2(arm.x() * reached.y() - arm.y() * reached.x(), arm.dot(reached));
      if (turn < 1e-9) turn += 2 * std::numbers::pi;
      if (turn < best_turn) best_turn = turn, best = {i, p + reached};
    }
  });
  return best;
}

}  // namespace

Result<std::vector<int>> alphaOutline(std::span<const Eigen::Vector2d> points, double alpha_mm) {
  const Error open{ErrorCode::NotEnough, message("The scan's outline is not closed."), {}};
  if (points.size() < 3) return open;
  const PlanarGrid grid(points, alpha_mm);
  const std::vector<std::uint8_t> chosen = largestGroup(grid);
  int start = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!chosen[grid.cellOf(points[i])]) continue;
    if (start < 0 || points[i].y() < points[static_cast<std::size_t>(start)].y()) {
      start = static_cast<int>(i);
    }
  }
  std::vector<int> outline{start};
  Eigen::Vector2d centre = points[static_cast<std::size_t>(start)] - Eigen::Vector2d(0, alpha_mm);
  const std::size_t limit = 4 * points.size();
  while (outline.size() < limit) {
    const Roll roll = rollOn(grid, chosen, points, outline.back(), centre, alpha_mm);
    if (roll.next < 0) return open;
    // Closed when the first step is taken a second time; the start itself may be a neck.
    if (outline.size() > 1 && outline.back() == start && roll.next == outline[1]) {
      outline.pop_back();
      break;
    }
    outline.push_back(roll.next);
    centre = roll.centre;
  }
  if (outline.size() < 3 || outline.size() >= limit) return open;
  return outline;
}

}  // namespace ostraka::pairing
