#pragma once
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cluster/place.h"
#include "cluster/queue_text.h"
#include "cluster/tasks.h"

namespace ostraka::cluster {

enum class TaskState { Waiting, Running, Done, Failed, Collected };
/// Why a task failed.
enum class Cause {
  None,
  Memory,   ///< the next submission asks for twice as much
  Time,     ///< likewise; it goes on from the last whole stage
  Node,     ///< the node, or somebody, ended the job
  Disk,     ///< full, or a quota
  Program,  ///< Ostraka said why
  Lost      ///< the cluster knows nothing of it
};

struct TaskStatus {
  Task task;
  TaskState state = TaskState::Waiting;
  Cause cause = Cause::None;
  std::string words;  ///< one sentence where there is something to say
};

/// What is known of one task. queue: nullptr where Slurm does not know it (any more); note: that of
/// this job, nullptr where it wrote none; log: its output.
TaskStatus judge(const Task& task, const QueueTask* queue, const StateNote* note,
                 std::string_view log);

/// Of all tasks, in the order of the list. Errors: those of Place::run, where Slurm does not
/// answer: nothing is concluded then.
Result<std::vector<TaskStatus>> statusOf(const std::filesystem::path& project, const Place& place,
                                         const Tasks& tasks, const std::stop_token& stop);

}  // namespace ostraka::cluster
