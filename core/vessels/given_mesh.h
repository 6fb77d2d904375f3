#pragma once
#include <filesystem>

#include "base/result.h"
#include "vessels/sherd.h"

namespace ostraka::vessels {

inline constexpr double kMostEdge_mm = 1;  ///< as far as places on the plate are told apart

/// A thing of any shape, in place of a sherd: the closed mesh of a PLY file, mm, moved so that the
/// model frame's origin is its centre of mass; its axes are the file's. Edges are halved until none
/// is longer than kMostEdge_mm. It has no wall and no break: all of it is outside. If it has
/// colours, photographs show them in place of clay and paint. Errors: those of readPly;
/// UnusableInput when the mesh is not closed, is smaller than 5 mm or larger than 300 mm, or has
/// more than 500,000 triangles.
Result<VirtualSherd> sherdOfMesh(const std::filesystem::path& file);

}  // namespace ostraka::vessels
