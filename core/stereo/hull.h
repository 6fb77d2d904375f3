#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "stereo/frame.h"

namespace ostraka::stereo {

/// A mask that misses a sherd must not cost the sherd: so many of a side's views may show as
/// outside what the others show. One in 24, and one in any case.
int masksThatMayErr(std::size_t views);

/// The visual hull: cubes that at least 3 views see and no more see outside their masks than may
/// err (after Laurentini, IEEE PAMI 1994).
struct Hull {
  Eigen::Vector3f origin;  ///< centre of the first cube, plate frame, mm
  float edge_mm = 1;
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> inside;  ///< x fastest

  bool at(const Eigen::Vector3f& p_plate) const;
};

/// Where a pixel's ray runs through the hull, as depths along the optical axis, mm; far 0 =
/// nowhere.
struct DepthRange {
  float near = 0, far = 0;
};

/// Carves six million cubes within the bounds, or within what the masks bound where there are
/// none: around where the optical axes meet, or, where nothing is there, where they meet the floor.
/// Errors: NotEnough when nothing is left.
Result<Hull> carveHull(std::span<const Frame* const> frames, const DenseOptions& options,
                       int threads);

/// For each pixel of the frame, row by row; pixels outside the mask get an empty range, and so do
/// those whose ray meets the hull nowhere within reach (plate frame, mm).
std::vector<DepthRange> depthRanges(const Hull& hull, const Frame& frame,
                                    const Eigen::AlignedBox3f& reach);
/// Wherever the ray meets the hull.
std::vector<DepthRange> depthRanges(const Hull& hull, const Frame& frame);

}  // namespace ostraka::stereo
