#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::exchange {

/// What travels inside a model's file.
struct ModelLabel {
  std::string id, number, licence, program;
};

/// The PLY with a comment that names sherd, number, unit and licence; its data stays as it is.
Result<std::string> labelledPly(std::string_view ply, const ModelLabel& label,
                                const std::string& where);
/// The GLB with asset.copyright and nodes[0].extras.ostraka; its buffers stay as they are.
Result<std::string> labelledGlb(std::string_view glb, const ModelLabel& label,
                                const std::string& where);
/// An OBJ made from the PLY, with the same in comments.
Result<std::string> labelledObj(std::string_view ply, const ModelLabel& label,
                                const std::string& where);

}  // namespace ostraka::exchange
