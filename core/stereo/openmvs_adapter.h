#pragma once
#include <filesystem>
#include <span>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "stereo/stereo.h"

namespace ostraka::stereo {

/// As reconstruct, by OpenMVS's programs InterfaceCOLMAP and DensifyPointCloud (2.1 or newer) found
/// on the PATH. workspace: a folder of its own, emptied first; its log.txt holds the programs'
/// words. The programs are killed when a stop is asked for. Errors: Missing, those of
/// writeOutsideFolder and readOutsideCloud, Failed.
Result<PointCloud> reconstructWithOpenMvs(std::span<const View> views, const DenseOptions& options,
                                          const std::filesystem::path& workspace,
                                          Progress& progress, std::stop_token stop);

}  // namespace ostraka::stereo
