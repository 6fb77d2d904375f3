#pragma once
#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::batch {

/// Of photographs of one side with the same bytes ("IMG_2414 copy.jpg") all but one are left out,
/// with a warning that names both: a duplicate view doubles its weight and adds nothing. The one
/// with its own mask is kept, else the one with the shorter name, else the first. Hand-held
/// photographs are renumbered. Error: NotEnough if too few are left on a side.
Result<void> leaveOutCopies(Batch& batch, const ReadBatchOptions& options, Progress& progress);

}  // namespace ostraka::batch
