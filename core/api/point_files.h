#pragma once
#include <filesystem>

#include "base/result.h"
#include "cloud/points_and_meshes.h"
#include "version.h"

namespace ostraka::api {

/// The points of a PLY file (ascii or binary, 1.0), in the file's own unit and frame; normals and
/// colours where the file has them. Points that are not finite are left out.
/// Errors: UnusableInput (no PLY file, or no point in it). O(size of the file).
OSTRAKA_API Result<PointCloud> readCloud(const std::filesystem::path& file);

/// Binary PLY with the comment 'unit mm', written whole or not at all. Errors: UnusableInput (lists
/// of different lengths, a triangle without its vertex, a place in a project or an archive),
/// CannotWrite.
OSTRAKA_API Result<void> writeCloud(const std::filesystem::path& file, const PointCloud& cloud);
OSTRAKA_API Result<void> writeMesh(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace ostraka::api
