#pragma once
#include <stop_token>
#include <vector>

#include "base/result.h"
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
  /// How squarely it is seen: cosine between ray and normal in the third best view, 0 where there
  /// are fewer. Mean of the whole surface, from the better side, and of the broken edge, from the
  /// worse one: models need both.
  double square = 0;
  double outside = 0;  ///< of points and views: the point lies outside of the picture
};
/// Each sherd lies at the plate's middle and half-way to the ring in turn; means of both. Errors:
/// Cancelled.
Result<std::vector<SherdCoverage>> coverage(const std::vector<vessels::VirtualSherd>& sherds,
                                            const VirtualRig& rig, const CoverageOptions& options,
                                            const std::stop_token& stop);

/// One camera carried about the plate's middle, still looking at the same places.
struct CameraMove {
  int camera = 0;        ///< index
  double raise_rad = 0;  ///< negative: lower
  double gain = 0;       ///< of square and 0.3 break_seen, mean over the sherds
};
/// Every camera raised and lowered by 10 and 20 degrees, alone, as far as it stays between 10 and
/// 85 degrees above the plate and opens no wider step between the cameras' elevations than 26
/// degrees or what is there; of each camera the move by which sherds are seen most squarely and
/// their breaks from both sides, when that gains at least 0.01, best first. Where there is a wider
/// step than 26 degrees the move that closes it comes before them, and sherds are seen most
/// squarely after. Rays tell what may be worth a try, not what models become: that takes
/// photographs. Errors: Cancelled.
Result<std::vector<CameraMove>> promisingMoves(const std::vector<vessels::VirtualSherd>& sherds,
                                               const VirtualRig& rig,
                                               const CoverageOptions& options,
                                               std::stop_token stop);
/// camera_from_room of a camera that was carried so, mm.
Eigen::Isometry3d raised(const Eigen::Isometry3d& camera_from_room, double raise_rad);

/// Height of a camera above the plate's plane as an angle, radians.
double elevation(const VirtualRig& rig, int camera);
/// Length of a pixel at the plate's middle, mm.
double pixelSize(const VirtualRig& rig, int camera);

}  // namespace ostraka::virtualrig
