#pragma once
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "pipeline/process_batch.h"

namespace ostraka::pipeline {

/// What a run will take, about.
struct Needs {
  double megapixels = 0;  ///< of a photograph as stereo will see it
  double memory_mb = 0;   ///< at the run's peak (docs/experiments.md)
  double core_s = 0;      ///< seconds of one core (tests/bench/RESULTS.md), without COLMAP's
};

/// What a run finds and will take, before its first stage.
struct Preflight : Needs {
  std::vector<Message> lines;     ///< what there is, whole sentences
  std::vector<Message> warnings;  ///< what is short, what follows and what to do
};

/// What photographs are averaged down to for masks, millions of pixels: as many as stereo sees, but
/// no more than 5, and no more than the memory holds of all photographs of a side, but 1 at least.
double maskMegapixels(const ProcessOptions& options, const batch::Batch& batch);
/// What is left for stereo beside all masks and as many originals.
double stereoMemory_mb(const ProcessOptions& options, const batch::Batch& batch, int originals);

/// The originals come first, as many at one time as threads may have (threadsForOriginals), then
/// what they are averaged down to. free_memory_mb: 0 when the system does not say.
Needs needsOf(const batch::Batch& batch, const ProcessOptions& options, double free_memory_mb);

/// Errors: Missing for a program that a later
/// stage would ask for, and those of batch::maskSource.
Result<Preflight> preflight(const batch::Batch& batch, const ProcessOptions& options,
                            double free_memory_mb);

}  // namespace ostraka::pipeline
