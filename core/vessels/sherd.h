#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "vessels/clay.h"
#include "vessels/vessel.h"

namespace ostraka::vessels {

enum class SherdPart { Wall, Rim, Base };
const char* name(SherdPart part);

/// Which piece of a vessel breaks out, and how. The same outline_seed with another relief_seed
/// gives a near-duplicate: the same outline half-way through the wall, but other break faces.
struct BreakPlan {
  SherdPart part = SherdPart::Wall;
  double s_mm = 100;        ///< place of the piece's centre on the vessel, arc length from the base
  double radius_mm = 30;    ///< mean distance of the outline from its centre
  double edge_mm = 0.5;     ///< wanted length of the mesh's edges; grows above 60 000 faces
  double relief_mm = 0.25;  ///< roughness of the break faces, amplitude of the coarsest octave
  double tilt_rad = 0.4;    ///< most that a break face leans from the wall's normal, either way
  std::uint64_t outline_seed = 1;
  std::uint64_t relief_seed = 1;
  bool mirrored = false;  ///< the outline is mirrored
};

/// A closed, oriented, manifold mesh with what the clay's look needs at each vertex.
struct VirtualSherd {
  TriangleMesh mesh;              ///< model frame: origin in the centre of mass, z outward
  std::vector<ClayPlace> places;  ///< per vertex
  Clay clay;
  std::string kind;  ///< as "jar rim"
  double volume_mm3 = 0;
  double width_mm = 0;  ///< largest extent across the wall
  double wall_min_mm = 0, wall_mean_mm = 0, wall_max_mm = 0;
  int lookalike_group = -1;  ///< -1: no near-duplicate
};

/// Breaks the piece out. The outline is a star-shaped polygon with fractal edges; the break runs
/// obliquely through the wall with rough relief; edges are worn. O(faces).
VirtualSherd breakOut(const Vessel& vessel, const BreakPlan& plan);

/// Volume enclosed by a closed mesh, mm^3, and its centre of mass.
double enclosedVolume(const TriangleMesh& mesh, Eigen::Vector3d* centre_of_mass = nullptr);

}  // namespace ostraka::vessels
