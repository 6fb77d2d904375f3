#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "stereo/hull.h"
#include "stereo/photometric_cost.h"

namespace ostraka::stereo {

/// For each of a frame's pixels a plane through the point at this depth; normals in the camera's
/// frame, unit, towards the camera. Depth 0 = nothing found.
struct PlaneMap {
  std::vector<float> depth;  ///< mm along the optical axis
  std::vector<Eigen::Vector3f> normal;
  std::vector<float> cost;  ///< mean dissimilarity of the best sources, 0..2

  void resize(std::size_t n) {
    depth.assign(n, 0.0F);
    normal.assign(n, Eigen::Vector3f(0, 0, -1));
    cost.assign(n, 2.0F);
  }
};

struct PropagationOptions {
  CostOptions cost;
  int rounds = 3;
  int max_active_sources = 0;    ///< per pixel, chosen by the first plane; 0 = all
  float first_perturbation = 1;  ///< of depth, in multiples of the depth that moves one pixel
  std::uint64_t seed = 1;
};

/// Improves one view's planes in place by checkerboard propagation and random perturbation
/// (Galliani et al., ICCV 2015). ranges: per pixel of the frame's list. Deterministic for a seed;
/// left half done when stop is requested.
void propagate(std::span<const Frame* const> frames, int view, std::span<const Link> links,
               std::span<const DepthRange> ranges, const PropagationOptions& options,
               PlaneMap& planes, const std::stop_token& stop);

/// Random planes inside the ranges, a third of them level with the plate.
void startPlanes(const Frame& frame, std::span<const DepthRange> ranges, std::uint64_t seed,
                 PlaneMap& planes);
/// Planes of the coarser level continued to this one.
void refinePlanes(const Frame& coarse, const PlaneMap& coarse_planes, const Frame& frame,
                  PlaneMap& planes);

}  // namespace ostraka::stereo
