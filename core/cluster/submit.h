#pragma once
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cluster/access.h"
#include "cluster/job_script.h"
#include "cluster/task_status.h"
#include "pipeline/preflight.h"
#include "upkeep/project.h"

namespace ostraka::cluster {

struct SubmitOptions {
  Access access;
  Ask ask;       ///< memory_mb, minutes: 0: from the needs that `process` states
  int most = 0;  ///< batches, oldest first; 0: all that wait
};

struct Submitted {
  std::vector<std::string> batches, arrays;  ///< arrays: Slurm's numbers
  int already = 0;                           ///< waiting, running or done on the cluster before
  int memory_mb = 0, minutes = 0;            ///< the most that was requested
  std::vector<Message> warnings;             ///< of batches that were left out, a sentence each
};

/// Submits every waiting batch of the project to the cluster, unless it is there already: job
/// arrays with one batch per task. A failed batch is submitted again, with twice the memory or time
/// if that was too little; one that was photographed again since is submitted anew once its job has
/// ended. Errors: those of reach and of Place; CannotWrite if the cluster's disk has no space
/// for the results or another such command is running; Failed with sbatch's output: nothing of that
/// array is then submitted.
Result<Submitted> submit(upkeep::Project& project, const SubmitOptions& options, Progress& progress,
                         std::stop_token stop);

/// What became of the batches that were submitted, oldest first. Errors: those of reach, statusOf.
Result<std::vector<TaskStatus>> status(const std::filesystem::path& project, const Access& access,
                                       std::stop_token stop);

/// What a batch requests: the needs that `process` states, with a margin for other processors and
/// busy disks, and its earlier outcome; `before` may be nullptr.
void raiseTo(Ask& ask, const pipeline::Needs& needs, const TaskStatus* before);

}  // namespace ostraka::cluster
