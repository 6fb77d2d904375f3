#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka {

/// Wavefront OBJ in mm (said in a comment: the format has no unit), `v x y z r g b` with colours
/// 0..1, `vn` where the mesh has normals, faces 1-based. Errors: UnusableInput for a wrong index.
Result<std::string> formatObj(const TriangleMesh& mesh);
/// With a picture in place of the colours, which readers would multiply it with. uv: per vertex,
/// 0..1 from the picture's top left corner; material_file: what formatMtl made, beside the OBJ.
Result<std::string> formatObj(const TriangleMesh& mesh, const std::vector<Eigen::Vector2f>& uv,
                              const std::string& material_file);
/// The material of such an OBJ: matt, in the colours of a picture beside it.
std::string formatMtl(const std::string& picture_file);

}  // namespace ostraka
