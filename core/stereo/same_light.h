#pragma once
#include <span>
#include <vector>

#include "stereo/fusion.h"

namespace ostraka::stereo {

struct SameLightOptions {
  /// Of the neighbourhoods over which the correction is averaged; see neighbourhood_mm.
  float reach_mm = 3.0F;
  int threads = 1;
};

/// Moves points of a surface to where photographs of the same light see it. On a turntable the
/// light stands still while the object turns, so the shading of each bump moves over the surface,
/// and what seems to move lies too deep or too high (0.02 mm on plain clay, and broken edges of the
/// two sides of a sherd then want 0.1 mm between them). Frames of one light, those of one stop, see
/// the same shading: along each point's normal their windows are compared anew, pair by pair, and
/// the mean over the neighbourhood of like orientation is taken from the point. Points stay where
/// they are when no two frames have their light in common, or when all have.
std::vector<SurfacePoint> settledInSameLight(std::span<const Frame* const> frames,
                                             std::span<const PlaneMap> maps,
                                             std::vector<SurfacePoint> points,
                                             const SameLightOptions& options);

}  // namespace ostraka::stereo
