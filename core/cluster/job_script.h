#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace ostraka::cluster {

/// What each task of an array asks the cluster for.
struct Ask {
  int cores = 4;
  int memory_mb = 0;
  int minutes = 0;
  std::string partition, account;  ///< empty: the cluster's own choice
  /// The command that starts Ostraka on a node, as a shell reads it:
  /// "module load ostraka; ostraka", "apptainer run ostraka.sif".
  std::string program = "ostraka";
  bool albedo = false;  ///< textures without the light of the photographs
  Result<void> check() const;
};

/// Slurm accepts arrays of up to 1000 tasks unless its administrator changed that.
constexpr int kMostTasks = 1000;
/// More than any node has, or any partition allows.
constexpr int kMostMemory_mb = 10'000'000, kMostMinutes = 100'000;

/// A script for sbatch, to be submitted in a folder that is laid out as a project: the n-th task
/// runs `process` on the n-th batch, from batches/ to results/, and says in cluster/state/BATCH
/// when it began and how it ended (queue_text.h). Nothing is written through a link. job: the
/// array's name in Slurm.
std::string jobScript(const std::string& job, const std::vector<std::string>& batches,
                      const Ask& ask);

/// Where the n-th task's output goes in that folder, the first being 1.
std::string logOf(const std::string& job, int task);
std::string scriptOf(const std::string& job);

}  // namespace ostraka::cluster
