#pragma once
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "calibration/intrinsics.h"
#include "rig/plate_markers.h"

namespace ostraka::calibration {

/// What was found in one photograph; unreadable holds the sentence when it cannot be decoded.
struct ShotMarkers {
  std::vector<rig::SeenMarker> markers;
  Message unreadable;
};

/// Markers of every shot, one entry per batch.shots. Errors: UnusableInput (dictionary), Cancelled.
Result<std::vector<ShotMarkers>> findBatchMarkers(const batch::Batch& batch, int threads,
                                                  Progress& progress, std::stop_token stop);

/// Board corners of every calibration picture, one entry per batch.calibration; no points where
/// the board is not seen or the picture cannot be read (noted as a warning). Errors as above.
Result<std::vector<TargetView>> findBatchBoards(const batch::Batch& batch, int threads,
                                                Progress& progress, std::stop_token stop);

}  // namespace ostraka::calibration
