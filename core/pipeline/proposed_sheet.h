#pragma once
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "pipeline/process_batch.h"

namespace ostraka::pipeline {

/// Photographs by hand without plate.json: the sheet under the sherds is found in those of the
/// front, its size from ProcessOptions::marker_mm; a warning says so. Leaves a batch alone that has
/// a plate, was taken on a rig, or of whose markers nobody said how large they are. Errors:
/// UnusableInput (marker_mm), NotEnough, Cancelled.
Result<void> proposeMissingSheet(batch::Batch& batch, const ProcessOptions& options,
                                 Progress& progress, std::stop_token stop);

/// Whether the plate is such a proposal; process writes it to OUT/plate.json.
bool isProposed(const batch::Batch& batch);

}  // namespace ostraka::pipeline
