#pragma once
#include <Eigen/Geometry>

#include "cloud/point_cloud.h"
#include "vessels/noise.h"

namespace ostraka::rendering {

enum class PropKind { ScaleBar, Label, ColorCard, Pencil };
inline constexpr int kPropKinds = 4;

/// A thing that lies beside the sherds and is none.
struct Prop {
  PropKind kind = PropKind::ScaleBar;
  Eigen::Isometry3d plate_from_prop = Eigen::Isometry3d::Identity();
  TriangleMesh mesh;  ///< plate frame, mm; corners of each face for itself, so that edges are sharp
  Eigen::Vector3f body = Eigen::Vector3f::Zero();  ///< mean albedo
  std::uint32_t seed = 0;

  /// Linear albedo at a point of its surface, plate frame.
  Eigen::Vector3f albedo(const Eigen::Vector3f& p_plate) const;
};

/// Width, depth and height, mm; the origin is in the middle of what it lies on.
Eigen::Vector3d propSize(PropKind kind);
Prop makeProp(PropKind kind, const Eigen::Isometry3d& plate_from_prop, vessels::Random& random);

}  // namespace ostraka::rendering
