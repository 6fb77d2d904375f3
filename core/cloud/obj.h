#pragma once
#include <string>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka {

/// Wavefront OBJ in mm (said in a comment: the format has no unit), `v x y z r g b` with colours
/// 0..1, `vn` where the mesh has normals, faces 1-based. Errors: UnusableInput for a wrong index.
Result<std::string> formatObj(const TriangleMesh& mesh);

}  // namespace ostraka
