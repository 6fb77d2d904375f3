#pragma once
#include <filesystem>
#include <span>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "stereo/stereo.h"

namespace ostraka::stereo {

/// As reconstruct, by the program colmap found on the PATH (patch_match_stereo, which needs a build
/// with CUDA, and stereo_fusion). workspace: a folder of its own, emptied first; its log.txt holds
/// the program's words. The programs are killed when a stop is asked for. Errors: Missing (no
/// colmap, or one without CUDA), those of writeOutsideFolder and readOutsideCloud, Failed.
Result<PointCloud> reconstructWithColmap(std::span<const View> views, const DenseOptions& options,
                                         const std::filesystem::path& workspace, Progress& progress,
                                         std::stop_token stop);

}  // namespace ostraka::stereo
