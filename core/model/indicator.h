#pragma once
#include <Eigen/Core>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "model/surfels.h"

namespace ostraka::model {

constexpr float kMargin_mm = 4;  ///< from the points to the border, where chi is 0

/// Values at the nodes of a regular grid, x fastest.
struct Grid {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< of node (0, 0, 0), mm
  float cell_mm = 1;
  Eigen::Array3i size = Eigen::Array3i::Zero();  ///< nodes per axis
  std::vector<float> values;
  float level = 0;  ///< subtracted from the values

  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x;
  }
  Eigen::Vector3f node(int x, int y, int z) const {
    return origin + cell_mm * Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y),
                                              static_cast<float>(z));
  }
  /// Trilinear; the border's value outside.
  float interpolated(const Eigen::Vector3f& p) const;
};

/// About 1 inside, 0 outside, from the surfels' normals and areas: the solution of Poisson's
/// equation lap(chi) = -div(sum of area * normal) with chi = 0 on the border, by conjugate
/// gradients from coarse to fine. It closes what was not seen, with the smoothest surface. Kazhdan,
/// Bolitho, Hoppe: Poisson Surface Reconstruction, SGP 2006. The level of the surface itself is
/// subtracted: positive inside. Errors: Cancelled, NotEnough (box over 2^28 nodes).
Result<Grid> indicator(const Surfels& surfels, float cell_mm, int threads, std::stop_token stop);

/// As above, after taking surfels out that bound no body: on the surface of a body the rest of the
/// surface gives a half (a sheet gives nothing at itself), on a fin that stereo has drawn past an
/// edge nothing, on a sheet within the body one. Surfels that go are counted in `dropped`.
Result<Grid> trustedIndicator(Surfels& surfels, float cell_mm, int threads, std::stop_token stop);

}  // namespace ostraka::model
