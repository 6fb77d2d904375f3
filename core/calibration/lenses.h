#pragma once
#include <span>
#include <vector>

#include "batch/batch.h"
#include "calibration/intrinsics.h"

namespace ostraka::calibration {

/// Which lens took each photograph, from 0 in the order of their first photographs: photographs of
/// one size, camera model and focal length (Exif) share a lens.
std::vector<int> lensesOf(std::span<const batch::Shot> shots);

/// The same, told apart further by what the photographs show: a zoom, or a second lens of the same
/// size, need not stand in any EXIF. views: by shot, corners of the sheet or plate. A lens is two
/// where its photographs, each by itself, fall into two groups of focal length, and a calibration
/// of each group leaves less than half of what one of all leaves.
std::vector<int> toldApart(std::vector<int> lenses, std::span<const batch::Shot> shots,
                           std::span<const TargetView> views);

}  // namespace ostraka::calibration
