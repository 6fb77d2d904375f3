#include "calibration/calibrate.h"

namespace ostraka::calibration {

Result<void> PoseOptions::check() const {
  if (!(table_repeatability_rad > 0))
    return Error{ErrorCode::UnusableInput, "table_repeatability_rad must be positive.", {}};
  if (!(max_known_rig_residual_px > 0))
    return Error{ErrorCode::UnusableInput, "max_known_rig_residual_px must be positive.", {}};
  return {};
}

}  // namespace ostraka::calibration
