#pragma once
#include <optional>
#include <vector>

#include "batch/batch.h"
#include "rig/camera.h"
#include "rig/intrinsics.h"

namespace ostraka::rig {

/// The size of poses without one, as COLMAP leaves them.
struct KnownScale {
  double mm_per_unit = 0;
  double relative_spread = 0;  ///< half the middle 68 % of the single ratios, over the median
  int lengths = 0;             ///< ratios it rests on
};

/// Where a point lies that is seen in several photographs: the least squares point of its rays, in
/// the poses' unit. Nothing with fewer than two rays, or with rays within 3 degrees of each other.
struct SeenIn {
  const PosedImage* image = nullptr;
  Eigen::Vector2d pixel;
};
std::optional<Eigen::Vector3d> triangulate(const std::vector<SeenIn>& rays);

/// From stretches that a person marked; marks on photographs without a pose do not count.
std::optional<KnownScale> scaleFromLengths(const std::vector<PosedImage>& images,
                                           const std::vector<batch::KnownLength>& lengths);

/// From a board that lies on the plate: the median ratio of true and found distances between all
/// its corners. views: what was seen of it, one per image. Nothing with fewer than 6 corners.
std::optional<KnownScale> scaleFromBoard(const std::vector<PosedImage>& images,
                                         const std::vector<TargetView>& views);

}  // namespace ostraka::rig
