#pragma once
#include <span>
#include <vector>

#include "stereo/fusion.h"

namespace ostraka::stereo {

struct SurfaceOptions {
  float spacing_px = 0.85F;  ///< edge of the cubes that keep one point each, in pixels' widths
  float radius_px = 2.6F;    ///< of the fitted neighbourhoods: the scale of the relief that is kept
  int threads = 1;
};

/// Leaves out the points that more masks exclude than may err.
std::vector<SurfacePoint> insideMasks(std::span<const Frame* const> frames,
                                      const std::vector<SurfacePoint>& points,
                                      const SurfaceOptions& options);

/// One point per cube, each moved onto the quadric through its neighbours of like orientation and
/// with that quadric's normal (moving least squares, Alexa et al., IEEE TVCG 2003).
std::vector<SurfacePoint> smoothed(const std::vector<SurfacePoint>& points,
                                   const SurfaceOptions& options);

}  // namespace ostraka::stereo
