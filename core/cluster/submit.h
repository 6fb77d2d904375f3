#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cluster/job_script.h"
#include "cluster/task_status.h"
#include "pipeline/preflight.h"
#include "upkeep/project.h"

namespace ostraka::cluster {

struct SubmitOptions {
  std::string host;  ///< as Place::of; empty: as before, or the project's own folder
  Ask ask;           ///< memory_mb, minutes: 0: by what `process` states of the batches
  int most = 0;      ///< batches, oldest first; 0: all that wait
};

struct Submitted {
  std::vector<std::string> batches, arrays;  ///< arrays: Slurm's numbers
  int already = 0;                           ///< waiting, running or done on the cluster before
  int memory_mb = 0, minutes = 0;            ///< the most that was asked for
  std::vector<Message> warnings;             ///< of batches that were left out, a sentence each
};

/// Hands every batch that waits in the project to the cluster, unless it has it already: job
/// arrays of one batch a task. A failed one is submitted again, with twice the memory or time where
/// that was short. Errors: those of Place; CannotWrite where the cluster's disk has no room for the
/// results, and when another such command is at work; Failed with what sbatch said: nothing of that
/// array is submitted then.
Result<Submitted> submit(upkeep::Project& project, const SubmitOptions& options, Progress& progress,
                         std::stop_token stop);

/// What became of the batches that were submitted, oldest first.
Result<std::vector<TaskStatus>> status(const std::filesystem::path& project, std::stop_token stop);

/// What a batch asks for: by what `process` states, with room for other processors and busy disks,
/// and by what became of it before; `before` may be nullptr.
void raiseTo(Ask& ask, const pipeline::Needs& needs, const TaskStatus* before);

}  // namespace ostraka::cluster
