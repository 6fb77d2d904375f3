#pragma once
#include <span>
#include <vector>

#include "stereo/frame.h"

namespace ostraka::stereo {

constexpr int kMaxSources = 16;

/// From one view's camera to another's: x_source = rotation * x_view + translation.
struct Link {
  int source = 0;
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
};

/// source: the other frame's place among all.
Link linkBetween(const Frame& view, const Frame& other, int source);

/// The views that each view is compared with, best first: those seen from the object's middle under
/// an angle near 20 degrees, spread over directions.
std::vector<std::vector<Link>> chooseSources(std::span<const Frame* const> frames,
                                             const Eigen::Vector3f& middle,
                                             const DenseOptions& options);

}  // namespace ostraka::stereo
