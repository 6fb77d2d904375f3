#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"

namespace ostraka::checks {

/// A camera that misses the plate's markers from where the known rig has it: somebody bumped it.
struct MovedCamera {
  int camera = 0;
  double residual_px = 0;  ///< median over its markers, with the rig as it was
  double moved_mm = 0, turned_rad = 0;
};

/// Of the batch computed into `output`. None where the rig fits, or where no rig was known.
/// Errors: those of reading OUT/work/rig/stage.json.
Result<std::vector<MovedCamera>> movedCameras(const std::filesystem::path& output);

/// The cameras' places as this batch's photographs have them become the laboratory's RIG.json.
/// Lenses stay as they were calibrated, and so does what the file says of devices. The calibration
/// before stays beside it; its path is returned. Errors: Missing (the batch has no rig),
/// UnusableInput (RIG.json is of other cameras), CannotWrite.
Result<std::filesystem::path> calibrateFrom(const std::filesystem::path& output,
                                            const std::filesystem::path& rig_file);

}  // namespace ostraka::checks
