#pragma once
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "intake/batch_figures.h"
#include "upkeep/project.h"

namespace ostraka::intake {

struct ComputeOptions {
  std::filesystem::path project;
  std::string number;             ///< B0031
  std::string dense = "builtin";  ///< builtin, colmap or openmvs
  int threads = 0;                ///< 0: all
  bool draft = false;             ///< a quick look at coarser photographs; final models come later
  std::function<void(double core_s)> estimated = {};  ///< as of pipeline::ProcessOptions
};

/// A batch of the project from photographs (or scans) to rows of the catalogue, going on from the
/// last whole stage; at the end the catalogue is backed up. Opens the project by itself: callable
/// in any thread. The batch's state becomes Computed, then Review or Done; on an error it stays.
/// Errors: also those of checkNotShared, before anything is computed.
Result<BatchFigures> computeBatch(const ComputeOptions& options, Progress& progress,
                                  std::stop_token stop);

/// The second half of it, for whole results of another computer, which lie in the batch's results
/// folder: the review is prepared, the results entered, the catalogue backed up. `begun` is the
/// batch as it was when that computation began. Doing it twice changes nothing. Errors: also
/// Missing for results that are not whole; Cancelled when the batch is photographed again since.
Result<BatchFigures> enterComputed(upkeep::Project& project, const records::BatchRecord& begun,
                                   Progress& progress, std::stop_token stop);

/// What computes a batch; computeBatch, but for tests.
using ComputeWork =
    std::function<Result<BatchFigures>(const ComputeOptions&, Progress&, std::stop_token)>;

/// Bytes that a batch and its results will take, by those on the disk; of one that is photographed
/// and not computed yet by its photographs.
double bytesPerBatch(const std::filesystem::path& project);
/// How many more batches fit; -1 when the disk does not say.
int roomForBatches(const std::filesystem::path& project);

}  // namespace ostraka::intake
