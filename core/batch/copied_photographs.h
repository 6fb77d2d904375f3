#pragma once
#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::batch {

/// Photographs are copies if their bytes are the same ("IMG_2414 copy.jpg"). Of those of one side
/// all but one are left out, with a warning that names both: a duplicate view doubles its weight
/// and adds nothing. The one with its own mask is kept, else the one with the shorter name, else
/// the first. A photograph of both sides is wrong on one of them, and nothing says on which: it is
/// left out of both, with a warning. Hand-held photographs are renumbered. Reads only files of
/// equal size. Errors: UnusableInput if more than half of a side's photographs are the other
/// side's; NotEnough if too few are left on a side.
Result<void> leaveOutCopies(Batch& batch, const ReadBatchOptions& options, Progress& progress);

}  // namespace ostraka::batch
