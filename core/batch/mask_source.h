#pragma once
#include <string>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::batch {

enum class MaskSource { Plate, Given, Network, Views };

/// Where the masks come from: as `masks` ("auto", "given", or a network's path) asks; "auto" means
/// the plate, or without one the masks that came along, or without these the photographs by hand
/// themselves. Errors: UnusableInput for a rig's photographs without plate and masks, since the
/// room that stands still around a turning plate misleads COLMAP.
Result<MaskSource> maskSource(const std::string& masks, const Batch& batch);

}  // namespace ostraka::batch
