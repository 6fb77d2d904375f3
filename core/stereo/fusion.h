#pragma once
#include <span>
#include <vector>

#include "stereo/patch_match.h"
#include "stereo/tiles.h"

namespace ostraka::stereo {

struct FusionOptions {
  int min_agreeing_views = 2;
  int threads = 1;
  const Tile* tile = nullptr;  ///< only what it owns is counted; absent: all
};

/// How the views of one point differ in slant, the tangent of the angle between the surface's
/// normal and the view, and in where along the normal they see the surface: weighted sums.
struct SlantSums {
  float mean = 0;        ///< tangent
  float covariance = 0;  ///< of tangent and place, mm
  float variance = 0;    ///< of the tangent
};

/// A point of the object's surface with what the views say about it.
struct SurfacePoint {
  Eigen::Vector3f position;  ///< plate frame, mm
  Eigen::Vector3f normal;
  float footprint_mm = 0;  ///< a pixel's width there
  float confidence = 0;    ///< 0..1
  int view = 0;            ///< the one that sees it most squarely
  int agreeing = 0;
  SlantSums slant = {};
};

/// The radius of neighbourhoods over which points tell something together: as wanted, but at most
/// 32 pixels' widths. Their number grows with its square, and so many tell as much as more would.
float neighbourhood_mm(const std::vector<SurfacePoint>& points, float wanted_mm);

/// Points where at least so many views agree, each from the view that sees it most squarely, moved
/// along the normal to the weighted mean of all that agree. In order of views and their pixels.
/// agreement: how many pixels were matched, and for how many so many views agree.
std::vector<SurfacePoint> fusePlanes(std::span<const Frame* const> frames,
                                     std::span<const PlaneMap> maps, const FusionOptions& options,
                                     Agreement& agreement);

}  // namespace ostraka::stereo
