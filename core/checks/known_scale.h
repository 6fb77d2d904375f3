#pragma once
#include <optional>
#include <vector>

#include "batch/batch.h"
#include "calibration/intrinsics.h"
#include "rig/camera.h"

namespace ostraka::checks {

/// The size of poses without one, as COLMAP leaves them.
struct KnownScale {
  double mm_per_unit = 0;
  double relative_spread = 0;  ///< half the middle 68 % of the single ratios, over the median
  int lengths = 0;             ///< ratios it rests on
};

/// Where a point lies that is seen in several photographs: the least squares point of its rays, in
/// the poses' unit. Nothing with fewer than two rays, or with rays within 3 degrees of each other.
struct SeenIn {
  const rig::PosedImage* image = nullptr;
  Eigen::Vector2d pixel;
};
std::optional<Eigen::Vector3d> triangulate(const std::vector<SeenIn>& rays);

/// A stretch that a person marked, as posed photographs in mm have it.
struct CheckedLength {
  batch::Side side = batch::Side::Front;
  double true_mm = 0, found_mm = 0;
  double sd_mm = 0;  ///< of found_mm: how well the marks fix it; the poses are taken for exact
  double error() const { return found_mm / true_mm - 1; }  ///< relative
  /// Off by more than three standard deviations of the marks, and by more than kMostScaleError.
  bool contradicts() const;
};

/// One per length; nothing where an end is not marked on two photographs with a pose, seen from
/// directions 3 degrees apart. How well a person marked is learnt from how far the rays of all ends
/// miss each other, 2 n - 3 degrees of freedom for n marks; it is no better than the rounding to
/// whole pixels, 1 / sqrt(12) px.
std::vector<std::optional<CheckedLength>> checkLengths(
    const std::vector<rig::PosedImage>& images, const std::vector<batch::KnownLength>& lengths);

/// From stretches that a person marked; marks on photographs without a pose do not count.
std::optional<KnownScale> scaleFromLengths(const std::vector<rig::PosedImage>& images,
                                           const std::vector<batch::KnownLength>& lengths);

/// From a board that lies on the plate: the median ratio of true and found distances between all
/// its corners. views: what was seen of it, one per image. Nothing with fewer than 6 corners.
std::optional<KnownScale> scaleFromBoard(const std::vector<rig::PosedImage>& images,
                                         const std::vector<calibration::TargetView>& views);

}  // namespace ostraka::checks
