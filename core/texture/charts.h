#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::texture {

/// What of a sherd a triangle belongs to. The front lay up in the front's photographs.
enum class Part : std::uint8_t { Front, Back, Fracture };

struct SherdParts {
  std::vector<Part> of_face;                        ///< by triangle
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();  ///< out of the front, unit length
};
/// A triangle is of the front or the back up to 55 degrees from the sherd's own axis. mesh: closed,
/// outward; vertices may be there once for each chart.
SherdParts partsOf(const TriangleMesh& mesh);

/// A piece of a surface laid flat without an overlap.
struct Chart {
  std::vector<int> faces;                               ///< of the mesh
  std::vector<std::array<Eigen::Vector2f, 3>> corners;  ///< of each face, mm; from (0, 0) on
  Eigen::Vector2f size = Eigen::Vector2f::Zero();       ///< mm
};

/// A sherd's surface as charts that a person can read: the front face and the back face as one
/// looks at them along the sherd's own axis, and the fracture unrolled along the outline, in rows
/// no longer than the faces. What these three cannot hold (walls of a hole, a handle's underside)
/// is seen along its own normal in charts of its own. Each face with an area is in one chart. mesh:
/// closed, outward, mm. texel_mm: size at which an overlap shows.
std::vector<Chart> chartsOf(const TriangleMesh& mesh, double texel_mm);

}  // namespace ostraka::texture
