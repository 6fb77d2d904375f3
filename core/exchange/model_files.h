#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "texture/texture.h"

namespace ostraka::exchange {

/// What travels inside a model's file.
struct ModelLabel {
  std::string id, number, licence, program;
  std::string scale_doubts;  ///< why its measures are in doubt, a sentence a line; empty: not
  double deviation_mm = -1, farthest_mm = -1;  ///< of a lighter model, see there; < 0: it is whole
};

/// The PLY with a comment that names sherd, number, unit and licence, and one for each doubt about
/// its scale; its data stays as it is. It names no picture: there is none beside it.
Result<std::string> labelledPly(std::string_view ply, const ModelLabel& label,
                                const std::string& where);
/// The GLB with asset.copyright and nodes[0].extras.ostraka, where doubts about its scale stand as
/// scale_doubts; its buffers stay as they are.
Result<std::string> labelledGlb(std::string_view glb, const ModelLabel& label,
                                const std::string& where);
/// An OBJ made from the PLY, with the same in comments.
Result<std::string> labelledObj(std::string_view ply, const ModelLabel& label,
                                const std::string& where);

/// The mesh as PLY on which the photographs of a model of the same sherd stand, in picture_file
/// beside it; with the same comments.
Result<std::string> labelledTexturedPly(const TriangleMesh& mesh,
                                        const texture::TexturedMesh& model, const ModelLabel& label,
                                        const std::string& picture_file);

/// An OBJ with its material, for the photographs in NAME.png beside it.
struct TexturedObj {
  std::string obj, mtl;
};
/// name: of the three files, without their endings. The label stands in the OBJ and the MTL.
Result<TexturedObj> labelledTexturedObj(const texture::TexturedMesh& model, const ModelLabel& label,
                                        const std::string& name);

}  // namespace ostraka::exchange
