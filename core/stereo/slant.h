#pragma once
#include <vector>

#include "stereo/fusion.h"

namespace ostraka::stereo {

struct SlantOptions {
  float reach_mm = 2.5F;  ///< of the neighbourhoods that share one factor; see neighbourhood_mm
  int threads = 1;
};

/// Moves points to where they would lie if every view saw them squarely. The more slantingly a view
/// looks, the more a rough surface stands out towards it, as bumps hide the hollows behind them:
/// broken edges by about 0.02 mm times the tangent of the angle, smooth faces not at all. The
/// factor is found, neighbourhood by neighbourhood, from views of different slant that see the same
/// points.
std::vector<SurfacePoint> withoutSlant(std::vector<SurfacePoint> points,
                                       const SlantOptions& options);

}  // namespace ostraka::stereo
