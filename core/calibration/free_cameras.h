#pragma once
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "calibration/calibrate.h"

namespace ostraka::calibration {

/// Poses and lenses of photographs that were taken by hand over a marker sheet (batch::Way::
/// FreeCamera): each photograph has a pose of its own and a lens that is its camera's but for
/// autofocus and stabilisation (OwnLenses); the sheet of each side may be bent (AdjustOptions::
/// bend_sd_mm). Photographs of one size, camera model and focal length (Exif) share a lens.
/// Frame: the sheet as plate.json has it, z up; with a bent sheet the plane that fits it best.
/// BatchPoses::cameras holds one entry per lens, BatchPoses::rig is empty. A photograph with fewer
/// than two markers in agreement is left out with a warning. Errors: NotEnough (no plate.json, no
/// lens, fewer than 3 posed photographs on a side that was photographed), Cancelled.
Result<BatchPoses> poseFreeCameras(const batch::Batch& batch, const PoseOptions& options,
                                   Progress& progress, std::stop_token stop);

}  // namespace ostraka::calibration
