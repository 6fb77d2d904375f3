#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "cloud/bounds.h"

namespace ostraka::model {

/// Points sorted into cubes, for many queries of one radius. Keeps the points' order within a cube,
/// so a loop over neighbours adds up in the same order on every run.
class PointBins {
 public:
  /// edge_mm: about the radius of the queries. Enlarged where the box would hold over 2^24 cubes.
  PointBins(std::span<const Eigen::Vector3f> points, float edge_mm) : edge_(edge_mm) {
    if (points.empty()) return;
    const auto [low, high] = boundsOf(points);
    low_ = low;
    const auto cubes = [&] {
      size_ = ((high - low) / edge_).array().floor().cast<int>() + 1;
      return static_cast<double>(size_[0]) * size_[1] * size_[2];
    };
    while (cubes() > (1 << 24)) edge_ *= 1.26f;
    start_.assign(static_cast<std::size_t>(cubes()) + 1, 0);
    std::vector<std::uint32_t> cube(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      cube[i] = cubeOf(cell(points[i]));
      ++start_[cube[i] + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    index_.resize(points.size());
    sorted_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t at = next[cube[i]]++;
      index_[at] = static_cast<int>(i);
      sorted_[at] = points[i];
    }
  }

  /// Calls visit(index, squared distance) for each point within radius_mm.
  template <class Visit>
  void within(const Eigen::Vector3f& query, float radius_mm, Visit&& visit) const {
    if (index_.empty()) return;
    const Eigen::Array3i first = clamped(query.array() - radius_mm),
                         last = clamped(query.array() + radius_mm);
    const float r2 = radius_mm * radius_mm;
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y) {
        const std::uint32_t row = cubeOf({0, y, z});
        const std::uint32_t end = start_[row + static_cast<std::uint32_t>(last[0]) + 1];
        for (std::uint32_t k = start_[row + static_cast<std::uint32_t>(first[0])]; k < end; ++k) {
          const float d2 = (sorted_[k] - query).squaredNorm();
          if (d2 <= r2) visit(index_[k], d2);
        }
      }
  }

 private:
  Eigen::Array3i cell(const Eigen::Vector3f& p) const { return clamped(p.array()); }
  Eigen::Array3i clamped(const Eigen::Array3f& p) const {
    // Far queries are cut before the cast, which would overflow.
    const Eigen::Array3f at = ((p - low_.array()) / edge_).max(0.0f).min((size_ - 1).cast<float>());
    return at.cast<int>();
  }
  std::uint32_t cubeOf(const Eigen::Array3i& c) const {
    return static_cast<std::uint32_t>((c[2] * size_[1] + c[1]) * size_[0] + c[0]);
  }

  float edge_;
  Eigen::Vector3f low_ = Eigen::Vector3f::Zero();
  Eigen::Array3i size_ = Eigen::Array3i::Ones();
  std::vector<std::uint32_t> start_;
  std::vector<int> index_;
  std::vector<Eigen::Vector3f> sorted_;
};

}  // namespace ostraka::model
