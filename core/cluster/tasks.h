#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace ostraka::cluster {

/// A batch that was submitted to the cluster: the n-th task of an array.
struct Task {
  std::string batch;  ///< B0031
  std::string job;    ///< the array's name
  int number = 1;
  int memory_mb = 0, minutes = 0;  ///< requested
  std::string photographs;         ///< batch::takingNow of those that were submitted
  bool collected = false;          ///< its results were entered or are no longer wanted
  bool operator==(const Task&) const = default;
};

/// PROJECT/cluster/tasks.json: the newest task of each batch. It is written before a job is
/// submitted, so that every job on the cluster is known.
struct Tasks {
  /// user@login:/folder; empty: the cluster sees the project's folder. A project may come from a
  /// stranger, so that reach() contacts this host only if the person named the same one.
  std::string host;
  std::vector<Task> tasks;

  Task* of(const std::string& batch);
  bool anyUncollected() const;
};
std::filesystem::path clusterFolder(const std::filesystem::path& project);
/// Empty where there is none. Every command on the cluster begins with it. Error: UnusableInput,
/// also for a link in that folder (upkeep::checkNoLinkInCluster).
Result<Tasks> readTasks(const std::filesystem::path& project);
Result<void> writeTasks(const std::filesystem::path& project, const Tasks& tasks);

}  // namespace ostraka::cluster
