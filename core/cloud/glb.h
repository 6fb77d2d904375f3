#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka {

/// What travels with a model (asset.copyright and nodes[0].extras.ostraka); empty texts are left
/// out.
struct GlbExtras {
  std::string id, number, copyright;
  double filled_percent = -1;  ///< < 0: left out
};

/// glTF 2.0 binary: metres, +Y up, baked into the positions ((x, y, z) mm -> (x, z, -y) / 1000),
/// normals, COLOR_0 linear 16 bit RGBA, _SEEN as float 0 or 1, 16 or 32 bit indices. One mesh, one
/// node. Errors: UnusableInput for a mesh without triangles or with a wrong index.
Result<std::string> formatGlb(const TriangleMesh& mesh, const GlbExtras& extras);
Result<void> writeGlb(const std::filesystem::path& path, const TriangleMesh& mesh,
                      const GlbExtras& extras);

}  // namespace ostraka
