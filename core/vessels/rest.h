#pragma once
#include <Eigen/Geometry>

#include "cloud/point_cloud.h"

namespace ostraka::vessels {

/// Lays a body down as it would come to rest: let go with `up_model` upwards, it tilts over its
/// contact points until its centre of mass (the model frame's origin) stands over the triangle of
/// three of them. Returns plate_from_model with the lowest vertex on z = 0 and the centre of mass
/// on the axis. Each tilt lowers the centre of mass, so it ends.
Eigen::Isometry3d restPose(const TriangleMesh& mesh, const Eigen::Vector3d& up_model);

}  // namespace ostraka::vessels
