#pragma once
#include <filesystem>
#include <stop_token>
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
  Memory,   ///< the next submission requests twice as much
  Time,     ///< likewise; it resumes after the last complete stage
  Node,     ///< the node, or somebody, ended the job
  Disk,     ///< full, or a quota
  Program,  ///< Ostraka reported why
  Lost      ///< the cluster does not know it
};

struct TaskStatus {
  Task task;
  TaskState state = TaskState::Waiting;
  Cause cause = Cause::None;
  Message words;  ///< one sentence; may be empty
};

/// What is known about one task. queue: nullptr if Slurm does not know it (any more); note: that of
/// this job, nullptr if it wrote none; log: its output.
TaskStatus judge(const Task& task, const QueueTask* queue, const StateNote* note,
                 std::string_view log);

/// Of all tasks, in the order of the list. Errors: those of Place::run if Slurm does not answer;
/// nothing is then concluded.
Result<std::vector<TaskStatus>> statusOf(const std::filesystem::path& project, const Place& place,
                                         const Tasks& tasks, const std::stop_token& stop);

}  // namespace ostraka::cluster
