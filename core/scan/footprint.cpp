#include "scan/footprint.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>

#include "cloud/bounds.h"

namespace ostraka::scan {

double areaFromAbove_mm2(const PointCloud& piece) {
  std::set<std::pair<int, int>> squares;
  for (const Eigen::Vector3f& p : piece.points)
    squares.insert({static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))});
  return static_cast<double>(squares.size());
}

Footprint::Footprint(std::span<const Eigen::Vector2d> points, double cell_mm) : cell_mm_(cell_mm) {
  const auto [low, high] = boundsOf(points);
  low_ = low.array() - 2.5 * cell_mm;
  columns_ = static_cast<int>((high.x() - low_.x()) / cell_mm) + 4;
  rows_ = static_cast<int>((high.y() - low_.y()) / cell_mm) + 4;
  cv::Mat1b cells(rows_, columns_, uchar{0});
  for (const Eigen::Vector2d& p : points) cells.data[cellOf(p)] = 1;
  // Empty cells reached from the corner: holes inside are no outside.
  constexpr uchar kOutside = 2;
  cv::floodFill(cells, {0, 0}, kOutside);
  for (const uchar cell : cells) depth_.push_back(cell == kOutside ? 0 : 1e9);
  sweep();
}

std::size_t Footprint::cellOf(const Eigen::Vector2d& p) const {
  const int c = std::clamp(static_cast<int>((p.x() - low_.x()) / cell_mm_), 0, columns_ - 1);
  const int r = std::clamp(static_cast<int>((p.y() - low_.y()) / cell_mm_), 0, rows_ - 1);
  return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(c);
}

void Footprint::sweep() {
  const auto index = [&](int r, int c) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(c);
  };
  const auto relax = [&](int r, int c, int dr, int dc, double step) {
    if (r + dr < 0 || c + dc < 0 || r + dr >= rows_ || c + dc >= columns_) return;
    double& here = depth_[index(r, c)];
    here = std::min(here, depth_[index(r + dr, c + dc)] + step * cell_mm_);
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

}  // namespace ostraka::scan
