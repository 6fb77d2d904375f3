#pragma once
#include <filesystem>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "pipeline/process_batch.h"

namespace ostraka::pipeline {

/// Photographs by hand without plate.json: the sheet under the sherds is sought in those of the
/// front, its size from ProcessOptions::marker_mm; a warning says so. Without marker_mm the size is
/// a guess (hasGuessedSize), and no sheet is found where there are no markers. Leaves a batch alone
/// that has a plate, was taken on a rig, or whose size scale.json or a board tells
/// (checks/no_scale.h). Errors: UnusableInput (marker_mm, also one that is not what a plate.json
/// says), NotEnough, Cancelled.
Result<void> proposeMissingSheet(batch::Batch& batch, const ProcessOptions& options,
                                 Progress& progress, std::stop_token stop);

/// A batch by hand gets this size: its plate.json is written anew with it, or for the first time by
/// what its photographs show, and returned. Errors: UnusableInput (a rig's batch, markers of
/// several sizes), those of proposeMissingSheet; the folder is as it was then.
Result<batch::Plate> setMarkerSide(const std::filesystem::path& folder, double marker_mm,
                                   Progress& progress, std::stop_token stop);

/// Whether the plate is such a proposal; process writes it to OUT/plate.json if its size is known.
bool isProposed(const batch::Batch& batch);
/// Whether nobody said how large the proposed sheet's markers are: the result has no scale.
bool hasGuessedSize(const batch::Batch& batch, const ProcessOptions& options);

}  // namespace ostraka::pipeline
