#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ostraka::cluster {

/// What Slurm reports about one task.
enum class QueueState {
  Waiting,
  Running,
  Ended,  ///< of its own accord, with any exit status
  TimeLimit,
  NoMemory,
  NodeFailed,
  Cancelled
};
struct QueueTask {
  QueueState state = QueueState::Waiting;
  std::string reason;  ///< Slurm's word, as "Resources" or "PartitionTimeLimit"; may be empty
};
/// By the array's name (jobScript) and the number of the task.
using Queue = std::map<std::pair<std::string, int>, QueueTask>;

/// The name of an array of ours: "ostraka-" and twelve hexadecimal digits.
bool isJobName(std::string_view text);
std::string newJobName();

/// Arguments for squeue and sacct, and what these print. Anything else in the text (a computer's
/// greeting, warnings) is ignored.
std::vector<std::string> queueQuestion(const std::vector<std::string>& jobs);
void readQueue(std::string_view text, Queue& queue);
std::vector<std::string> accountingQuestion(const std::vector<std::string>& jobs);
/// Only for tasks that are no longer in the queue.
void readAccounting(std::string_view text, Queue& queue);

/// The free space of the folder in which `df -Pk .` ran, MB.
std::optional<double> readFreeSpace_mb(std::string_view text);
/// The number that `sbatch --parsable` gave the job.
std::optional<std::string> readJobId(std::string_view text);

/// What a task of jobScript wrote into cluster/state/BATCH.
struct StateNote {
  std::string job;
  bool ended = false;
  int exit_status = 0;
  bool time_up = false;  ///< it was stopped before the time limit
  bool room = true;      ///< a few MB could still be written
  bool whole = false;    ///< the results are
};
/// None for anything else.
std::optional<StateNote> readStateNote(std::string_view text);

}  // namespace ostraka::cluster
