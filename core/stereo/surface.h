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

struct SlantOptions {
  float reach_mm = 2.5F;  ///< of the neighbourhoods that share one factor; see neighbourhood_mm
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

/// Moves points to where they would lie if every view saw them squarely. The more slantingly a view
/// looks, the more a rough surface stands out towards it, as bumps hide the hollows behind them:
/// broken edges by about 0.02 mm times the tangent of the angle, smooth faces not at all. The
/// factor is found, neighbourhood by neighbourhood, from views of different slant that see the same
/// points.
std::vector<SurfacePoint> withoutSlant(std::vector<SurfacePoint> points,
                                       const SlantOptions& options);

}  // namespace ostraka::stereo
