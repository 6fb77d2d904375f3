#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.h"

namespace ostraka::evaluate {

/// Grey levels, row by row. A found mask is sherd from 128 upwards (soft edges keep their level);
/// a true one holds labels, 0 = none.
struct MaskImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> levels;
  std::uint8_t at(int x, int y) const { return levels[std::size_t(y) * width + x]; }
};

/// 8-bit, one channel. Errors: unreadable, not 8-bit grey.
Result<MaskImage> readMask(const std::filesystem::path& file);

/// Sums over photographs; add() of two is that of both.
struct MaskFigures {
  std::size_t both = 0, either = 0;  ///< pixels
  std::vector<float> edge_px;  ///< signed, one per found edge point; found too large: positive
  void add(const MaskFigures& other);
  double intersectionOverUnion() const;  ///< 1 when both are empty
  double edgeBias_px() const;            ///< median of edge_px; 0 without edges
  double edgeMean_px() const;            ///< mean of |edge_px|
  double edgeWithin95_px() const;        ///< 95th percentile of |edge_px|
};

/// Edge points lie between two neighbouring pixels (4-neighbourhood) on different sides of the
/// threshold, for a soft mask at the interpolated crossing. The distance of a found edge point is
/// that to the true outline (segments between the true edge points of one 2x2 cell). Edge points
/// farther than 20 px from it, as of whole crumbs, count as 20.
/// Errors: sizes that differ.
Result<MaskFigures> evaluateMask(const MaskImage& found, const MaskImage& truth);

}  // namespace ostraka::evaluate
