#pragma once
#include "cloud/point_cloud.h"
#include "registration/strip.h"
#include "simulated_sherd.h"

namespace ostraka::baselines {

/// The fracture strips of a simulated sherd, as registerSides hands them to these methods.
struct FracturePair {
  registration::SimulatedSherd sherd = registration::simulatedSherd({});
  PointCloud front = fractureOf(sherd.front), back = fractureOf(sherd.back);

  static PointCloud fractureOf(const scan::Scan& scan) {
    const auto strip = registration::prepareStrip(scan, {});
    return {strip->fine.points, strip->fine.normals, {}, {}};
  }
  double error_mm(const Eigen::Isometry3d& front_from_back) const {
    return registration::rms_mm(front_from_back, sherd.truth, sherd.back);
  }
};

/// The first ones, as of a scan that hardly shows its fracture.
inline PointCloud firstPoints(const PointCloud& cloud, std::size_t count) {
  return {{cloud.points.begin(), cloud.points.begin() + static_cast<std::ptrdiff_t>(count)},
          {cloud.normals.begin(), cloud.normals.begin() + static_cast<std::ptrdiff_t>(count)},
          {},
          {}};
}

}  // namespace ostraka::baselines
