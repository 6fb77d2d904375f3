#pragma once
#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::batch {

/// Of photographs of one side with the same bytes ("IMG_2414 copy.jpg") all but one are left out,
/// with a warning that names both: a view that counts twice weighs twice and says nothing new. That
/// with a mask of its own is kept, else that with the shorter name, else the first. Photographs by
/// hand are counted anew. Error: NotEnough when too few are left on a side.
Result<void> leaveOutCopies(Batch& batch, const ReadBatchOptions& options, Progress& progress);

}  // namespace ostraka::batch
