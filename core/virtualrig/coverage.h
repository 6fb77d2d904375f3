#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "virtualrig/setup.h"

/// What a rig sees of sherds, by casting rays: no photographs, so it takes seconds.
namespace ostraka::virtualrig {

struct CoverageOptions {
  int points_per_sherd = 1500;
  int least_views = 3;           ///< of one side that must see a point: stereo with a witness
  double most_slant_rad = 1.22;  ///< 70 degrees between ray and normal; beyond, pixels smear
  int threads = 0;
};

/// Shares of one sherd's surface, both sides together.
struct SherdCoverage {
  double seen = 0;        ///< of the whole surface, by enough views of one side
  double break_seen = 0;  ///< of the broken edge, from both sides: only that ties them together
  double outside = 0;     ///< of points and views: the point lies outside of the picture
};
/// Each sherd lies at the plate's middle and half-way to the ring in turn; means of both.
std::vector<SherdCoverage> coverage(const std::vector<VirtualSherd>& sherds, const VirtualRig& rig,
                                    const CoverageOptions& options);

/// What would make the rig see more.
struct CameraAdvice {
  int camera = 0;        ///< index
  double raise_rad = 0;  ///< about the plate's middle; negative: lower
  double gain = 0;       ///< more of the broken edge seen, share
};
/// Every camera raised and lowered by 10 and 20 degrees, alone, as far as it stays between 10 and
/// 85 degrees above the plate and opens no wider step between the cameras' elevations than 26
/// degrees or what is there; the best of these when it shows at least one per cent more of the
/// breaks, else raise_rad = 0. Errors: Cancelled.
Result<CameraAdvice> bestMove(const std::vector<VirtualSherd>& sherds, const VirtualRig& rig,
                              const CoverageOptions& options, std::stop_token stop);

/// Height of a camera above the plate's plane as an angle, radians.
double elevation(const VirtualRig& rig, int camera);
/// Length of a pixel at the plate's middle, mm.
double pixelSize(const VirtualRig& rig, int camera);

}  // namespace ostraka::virtualrig
