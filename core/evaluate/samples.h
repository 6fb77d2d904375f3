#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::evaluate {

/// Points on a mesh, each with the outward unit normal of its triangle.
struct SurfaceSamples {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
};

/// Uniform by area, one per spacing_mm^2, at least 2000 and at most most_samples: one sample in
/// each of n equal slices of the area summed over the triangles. The mesh must have triangles.
SurfaceSamples areaSamples(const TriangleMesh& mesh, double spacing_mm, std::uint64_t seed,
                           std::size_t most_samples = 400'000);

}  // namespace ostraka::evaluate
