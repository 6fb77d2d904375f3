#pragma once
#include <Eigen/Core>
#include <vector>

namespace ostraka::texture {

/// A photograph's level at a place; weight 0: it does not show it.
struct Sample {
  Eigen::Vector3f level = Eigen::Vector3f::Zero();  ///< BGR, 0..255
  float weight = 0;
};

/// Factors per photograph (row) and channel that make photographs agree on the places that they
/// share, robust least squares of logarithms; their geometric mean over all samples is 1.
/// Photographs that share nothing with the others keep about their own levels.
/// samples[place][photograph].
Eigen::MatrixX3d gainsOf(const std::vector<std::vector<Sample>>& samples);

}  // namespace ostraka::texture
