#pragma once
#include <span>
#include <vector>

#include "batch/batch.h"

namespace ostraka::rig {

/// Which lens took each photograph, from 0 in the order of their first photographs: photographs of
/// one size, camera model and focal length (Exif) share a lens.
std::vector<int> lensesOf(std::span<const batch::Shot> shots);

}  // namespace ostraka::rig
