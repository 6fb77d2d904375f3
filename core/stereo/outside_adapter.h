#pragma once
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "files/folder_lock.h"
#include "stereo/stereo.h"

namespace ostraka::stereo {

/// What COLMAP's and OpenMVS's adapters share: the folder that is handed to the programs, and the
/// reading of what they leave. Layout, with <k> = "0000", "0001", ... in the order of the views:
///   images/<k>.png   without the lens's distortion: wholeOf(view), with its own size and K
///   sparse/*.txt     COLMAP's model: PINHOLE cameras (pixel centre + 0.5), poses, and points on
///                    the visual hull with the views that see them, from which the programs choose
///                    neighbours and depths
///   masks/           as MaskStyle says; 0 = outside
enum class MaskStyle {
  Colmap,  ///< masks/<k>.png.png, and the photographs are black outside
  OpenMvs  ///< masks/<k>.mask.png
};

/// The <k> of a view.
std::string viewName(std::size_t view);

/// Fills `folder`, which is emptied first and held as long as the lock is. Errors: NotEnough (fewer
/// than 3 views, no common object), UnusableInput (sizes), CannotWrite, Cancelled.
Result<FolderLock> writeOutsideFolder(std::span<const View> views, const DenseOptions& options,
                                      const std::filesystem::path& folder, MaskStyle style,
                                      std::stop_token stop);

/// The cloud that a program left, without what lies below the floor, beyond the bounds, or outside
/// more than one view's mask or inside too few (as the built-in stereo cuts). Whether the program
/// did its work is judged by this file alone. Errors: NotEnough (no file, or no point remains;
/// `log` is named), Failed (no normals).
Result<PointCloud> readOutsideCloud(const std::filesystem::path& file, const std::string& program,
                                    const std::filesystem::path& log, std::span<const View> views,
                                    const DenseOptions& options);

/// A program on the PATH. Errors: Missing, in one sentence for the person who chose it.
Result<std::filesystem::path> outsideProgram(const std::string& name, const std::string& option);

}  // namespace ostraka::stereo
