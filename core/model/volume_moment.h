#pragma once
#include <Eigen/Core>

#include "cloud/point_cloud.h"

namespace ostraka::model {

/// Volume and centre of mass of the body that a closed mesh bounds, of even density; the mesh's
/// frame, mm. The first vertex for a mesh without volume.
struct VolumeMoment {
  double volume_mm3 = 0;  ///< positive for outward faces
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};
VolumeMoment volumeMoment(const TriangleMesh& mesh);

}  // namespace ostraka::model
