#include "cluster/task_status.h"

#include <algorithm>
#include <optional>
#include <set>

#include "cluster/job_script.h"
#include "files/contained_path.h"
#include "files/open_folder.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;

constexpr int kNoteMost_mb = 1, kLogMost_mb = 8;
constexpr std::size_t kMostBytes = std::size_t{8} << 20, kLongestWords = 500;
constexpr int kTerminated = 128 + 15;  // Slurm ended it before the script heard of that
constexpr int kKilled = 128 + 9;       // as a shell gives it: by the kernel, where memory is short

TaskStatus failedWith(const Task& task, Cause cause, Message words) {
  return {task, TaskState::Failed, cause, std::move(words)};
}

TaskStatus failedFor(const Task& task, Cause cause) {
  switch (cause) {
    case Cause::Memory:
      return failedWith(task, cause,
                        message("Out of memory (%1 MB requested); the next submission requests "
                                "twice as much.",
                                task.memory_mb));
    case Cause::Time:
      return failedWith(
          task, cause,
          message("Out of time (minutes requested: %1); the next submission requests twice as many "
                  "and resumes after the last complete stage.",
                  task.minutes));
    case Cause::Node:
      return failedWith(
          task, cause,
          message("The node failed, or the job was killed; the next submission resumes after the "
                  "last complete stage."));
    case Cause::Disk:
      return failedWith(
          task, cause,
          message("The cluster's disk is full, or your quota is used up; free some space, then "
                  "submit again."));
    default:
      return failedWith(
          task, Cause::Lost,
          message(
              "The cluster does not know this job, and the job wrote nothing into the project's "
              "folder; check that the cluster's nodes see that folder, then submit again."));
  }
}

// Without accounting, and where it is not the kernel that watches over memory, only this tells.
bool tellsOfMemory(std::string_view log) {
  for (std::size_t at = 0; (at = log.find("slurmstepd", at)) != std::string_view::npos; ++at) {
    const std::string_view line = log.substr(at, log.substr(at).find('\n'));
    for (const char* word : {"memory limit", "oom-kill", "oom_kill", "Out Of Memory"})
      if (line.find(word) != std::string_view::npos) return true;
  }
  return false;
}

// The program's last sentence, without its name.
std::string lastSentence(std::string_view log) {
  constexpr std::string_view kName = "ostraka: ";
  std::string_view last;
  for (std::size_t at = 0; at < log.size();) {
    const std::size_t end = std::min(log.find('\n', at), log.size());
    const std::string_view line = log.substr(at, end - at);
    if (line.starts_with(kName)) last = line.substr(kName.size());
    at = end + 1;
  }
  return std::string(last.substr(0, kLongestWords));
}

TaskStatus judgeEnd(const Task& task, const StateNote& note, std::string_view log) {
  if (note.whole) return {task, TaskState::Done, Cause::None, {}};
  if (note.time_up) return failedFor(task, Cause::Time);
  if (note.exit_status == kKilled || tellsOfMemory(log)) return failedFor(task, Cause::Memory);
  if (!note.room) return failedFor(task, Cause::Disk);
  if (note.exit_status == kTerminated) return failedFor(task, Cause::Node);
  const std::string said = lastSentence(log);
  return failedWith(task, Cause::Program,
                    said.empty() ? message("The program ended with status %1; its output is in %2.",
                                           note.exit_status, logOf(task.job, task.number))
                                 : Message(said));
}

// A file of the cluster's, which may be anything: no link is followed.
std::string textOf(const fs::path& project, const std::string& path) {
  Result<OpenFile> file = OpenFile::within(project, path);
  if (!file) return {};
  Result<std::string> text = file->readAll(kMostBytes);
  return text ? std::move(*text) : std::string();
}

Result<Queue> askSlurm(const Place& place, const Tasks& tasks, const std::stop_token& stop) {
  std::set<std::string> names;
  for (const Task& task : tasks.tasks)
    if (!task.collected) names.insert(task.job);
  Queue queue;
  if (names.empty()) return queue;
  const std::vector<std::string> jobs(names.begin(), names.end());
  const Result<std::string> now = place.run(queueQuestion(jobs), stop);
  if (!now) return now.error();
  readQueue(*now, queue);
  // Slurm forgets what ended some minutes ago; many clusters keep no account of it either.
  const bool all = std::all_of(tasks.tasks.begin(), tasks.tasks.end(), [&](const Task& task) {
    return task.collected || queue.contains({task.job, task.number});
  });
  if (!all)
    if (const Result<std::string> before = place.run(accountingQuestion(jobs), stop))
      readAccounting(*before, queue);
  return queue;
}

}  // namespace

TaskStatus judge(const Task& task, const QueueTask* queue, const StateNote* note,
                 std::string_view log) {
  if (task.collected) return {task, TaskState::Collected, Cause::None, {}};
  if (note != nullptr && note->ended && note->whole) return judgeEnd(task, *note, log);
  // A requeued task waits or runs again, whatever its first run left.
  if (queue != nullptr && queue->state == QueueState::Running)
    return {task, TaskState::Running, Cause::None, {}};
  if (queue != nullptr && queue->state == QueueState::Waiting) {
    Message words;
    if (queue->reason == "PartitionTimeLimit")
      words = message(
          "The partition ends jobs earlier than the %1 minutes requested; cancel the job, "
          "then submit again with another --partition or fewer --minutes.",
          task.minutes);
    else if (!queue->reason.empty())
      words = message("Slurm's reason: %1.", queue->reason);
    return {task, TaskState::Waiting, Cause::None, words};
  }
  if (note != nullptr && note->ended) return judgeEnd(task, *note, log);
  const QueueState end = queue == nullptr ? QueueState::Ended : queue->state;
  if (end == QueueState::TimeLimit) return failedFor(task, Cause::Time);
  if (end == QueueState::NoMemory || tellsOfMemory(log)) return failedFor(task, Cause::Memory);
  if (end == QueueState::NodeFailed || end == QueueState::Cancelled || note != nullptr)
    return failedFor(task, Cause::Node);
  return failedFor(task, Cause::Lost);
}

Result<std::vector<TaskStatus>> statusOf(const fs::path& project, const Place& place,
                                         const Tasks& tasks, const std::stop_token& stop) {
  const Result<Queue> queue = askSlurm(place, tasks, stop);
  if (!queue) return queue.error();
  // After the queue: what has ended by then has written its note.
  if (tasks.anyUncollected()) {
    for (const auto& [path, most_mb] :
         {std::pair("cluster/state", kNoteMost_mb), std::pair("cluster/log", kLogMost_mb)})
      if (const Result<void> here = place.fetch(path, path, most_mb, {}, stop); !here)
        return here.error();
  }
  std::vector<TaskStatus> all;
  for (const Task& task : tasks.tasks) {
    const auto known = queue->find({task.job, task.number});
    std::optional<StateNote> note =
        task.collected ? std::nullopt
                       : readStateNote(textOf(project, "cluster/state/" + task.batch));
    if (note && note->job != task.job) note.reset();
    const std::string log = task.collected ? "" : textOf(project, logOf(task.job, task.number));
    all.push_back(judge(task, known == queue->end() ? nullptr : &known->second,
                        note ? &*note : nullptr, log));
  }
  return all;
}

}  // namespace ostraka::cluster
