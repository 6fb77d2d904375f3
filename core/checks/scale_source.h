#pragma once
#include "base/message.h"
#include "batch/batch.h"

namespace ostraka::checks {

/// What makes the scale of a batch's results, in one sentence: what the markers measure and who
/// says so, or which other length. has_scale: Poses::has_scale.
Message scaleSource(const batch::Batch& batch, bool has_scale);

}  // namespace ostraka::checks
