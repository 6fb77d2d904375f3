#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "colmap/colmap_files.h"
#include "files/folder_lock.h"
#include "rig/camera.h"

namespace ostraka::colmap {

/// A program on the PATH, or nothing.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// An empty folder for other programs, held as long as the lock is. Errors: CannotWrite, also when
/// another run holds it.
Result<FolderLock> claimWorkspace(const std::filesystem::path& folder);

/// Runs a program to its end, its output appended to `log`. It is killed, with all programs that it
/// started, when a stop is asked for and when this process ends, however that happens. Errors:
/// Missing (cannot be started), Cancelled, Failed (exit status; the log is named).
Result<void> runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const std::filesystem::path& log,
                        std::stop_token stop);

struct ColmapPoseOptions {
  std::filesystem::path program;  ///< empty: colmap on the PATH
  int threads = 0;                ///< <= 0: all processors of this process
  /// Share of a side's photographs that must get a pose; below it the result is not usable.
  double min_posed_share = 0.5;
  /// By shot: which lens took it (lensesOf). Empty: one lens per camera.
  std::vector<int> lenses;
  /// COLMAP is handed copies averaged down to so many millions of pixels; 0: the files themselves,
  /// which it must be able to read. Poses are those of the photographs in either case.
  double megapixels = 0;
};

/// One side as COLMAP sees it: unit and place are free, so no measure in mm may be taken from it
/// before scaledTo gave it one.
struct ColmapPoses {
  std::vector<rig::PosedImage> images;  ///< posed shots only, in the order given
  std::vector<Eigen::Vector3d> points;  ///< sparse, in the same frame
  double reprojection_px = 0;           ///< mean over the points
  bool has_scale = false;
};

/// Poses of one side's photographs without plate or calibration: COLMAP's features, exhaustive
/// matching and mapping on the CPU, one lens per camera; masks that came with the shots are used,
/// so that the room, which does not turn, takes no part. The frame: z is the axis that the cameras
/// circle about, pointing to their side, origin on it at the height of the lowest points; with
/// shared lenses, as photographs by hand have, uprightFrame.
/// workspace: a folder that may be filled; it is emptied first. Errors: Missing (no COLMAP),
/// NotEnough (too few photographs posed), Cancelled, Failed, CannotWrite.
Result<ColmapPoses> poseWithColmap(const std::vector<batch::Shot>& shots,
                                   const std::filesystem::path& workspace,
                                   const ColmapPoseOptions& options, Progress& progress,
                                   std::stop_token stop);

/// Into another frame.
void moveTo(ColmapPoses& poses, const Eigen::Isometry3d& frame_from_world);

/// The same with lengths times `mm_per_unit`, as a known length or a board gives it.
ColmapPoses scaledTo(ColmapPoses poses, double mm_per_unit);

}  // namespace ostraka::colmap
