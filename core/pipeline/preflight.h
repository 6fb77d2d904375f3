#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "pipeline/process_batch.h"

namespace ostraka::pipeline {

/// What a run will take, about.
struct Needs {
  double megapixels = 0;  ///< of a photograph as masks and stereo will see it
  double memory_mb = 0;   ///< at the run's peak (docs/experiments.md)
  double core_s = 0;      ///< seconds of one core (tests/bench/RESULTS.md), without COLMAP's
};

/// What a run finds and will take, before its first stage.
struct Preflight : Needs {
  std::vector<Message> lines;     ///< what there is, whole sentences
  std::vector<Message> warnings;  ///< what is short, what follows and what to do
};

/// What photographs are averaged down to when nothing else is asked for, millions of pixels: 5, or
/// what 4 GB of memory hold where a side has more than 24, but not less than 1.
double usualMegapixels(int photographs_of_a_side);
/// What masks and stereo work on, at most.
double workingMegapixels(const ProcessOptions& options, const batch::Batch& batch);

/// The originals come first, as many at one time as threads may have (threadsForOriginals), then
/// what they are averaged down to. free_memory_mb: 0 when the system does not say.
Needs needsOf(const batch::Batch& batch, const ProcessOptions& options, double free_memory_mb);

/// Errors: Missing for a program that a later
/// stage would ask for, and those of batch::maskSource.
Result<Preflight> preflight(const batch::Batch& batch, const ProcessOptions& options,
                            double free_memory_mb);

}  // namespace ostraka::pipeline
