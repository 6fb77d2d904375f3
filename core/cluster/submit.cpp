#include "cluster/submit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/text.h"
#include "batch/peoples_files.h"
#include "batch/photographs.h"
#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "cluster/place.h"
#include "cluster/tasks.h"
#include "decisions/scan_folder.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "intake/compute_batch.h"
#include "intake/computed_again.h"
#include "intake/side_photographs.h"
#include "pipeline/preflight.h"
#include "upkeep/project.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;
using records::BatchState;

// Nodes are slower than a new laptop, their disks are shared, and what is asked for too little is
// lost time; what is asked for too much only waits longer.
constexpr double kMemoryMargin = 1.3, kTimeMargin = 4;
constexpr int kLeastMemory_mb = 2000, kLeastMinutes = 30;

struct Wanted {
  std::string number, photographs;
  pipeline::Needs needs;
  const TaskStatus* before = nullptr;

  // The stages of a run that failed lie there, and are those of the same photographs.
  bool goesOn() const {
    return before != nullptr && before->state == TaskState::Failed &&
           before->task.photographs == photographs;
  }
};

const TaskStatus* statusOfBatch(const std::vector<TaskStatus>& all, const std::string& batch) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const TaskStatus& one) { return one.task.batch == batch; });
  return found == all.end() ? nullptr : &*found;
}

// Where earlier photographs are being processed another job would write into the same results; once
// that has ended the batch is submitted anew.
Result<bool> isTakenUp(const upkeep::Project& project, const TaskStatus* before,
                       std::vector<Message>& warnings, const std::stop_token& stop) {
  if (before == nullptr || before->state == TaskState::Failed ||
      before->state == TaskState::Collected)
    return false;
  const std::string& batch = before->task.batch;
  const Result<std::string> taking = batch::takingNow(project.batchFolder(batch), stop);
  if (!taking) return taking.error();
  if (*taking == before->task.photographs) return true;
  if (before->state == TaskState::Done) return false;
  warnings.push_back(about(
      batch, message("This batch was photographed again after it was submitted; its job %1 is of "
                     "no use any more. Cancel it with 'scancel', or wait until it has ended, then "
                     "submit the batch again.",
                     before->task.job)));
  return true;
}

// Oldest first.
Result<std::vector<Wanted>> wantedOf(const upkeep::Project& project,
                                     const std::vector<TaskStatus>& known,
                                     const SubmitOptions& options, Submitted& submitted,
                                     const std::stop_token& stop) {
  Result<std::vector<records::BatchRecord>> batches = catalogue::Batches(project.catalogue()).all();
  if (!batches) return batches.error();
  std::reverse(batches->begin(), batches->end());
  pipeline::ProcessOptions run;
  run.threads = options.ask.cores;
  std::vector<Wanted> wanted;
  for (const records::BatchRecord& batch : *batches) {
    if (stop.stop_requested()) return Error::cancelled();
    if (batch.state != BatchState::Queued && batch.state != BatchState::Computed) continue;
    const TaskStatus* before = statusOfBatch(known, batch.number);
    const Result<bool> taken_up = isTakenUp(project, before, submitted.warnings, stop);
    if (!taken_up) return taken_up.error();
    if (*taken_up) {
      ++submitted.already;
      continue;
    }
    if (options.most > 0 && static_cast<int>(wanted.size()) == options.most) break;
    const fs::path folder = project.batchFolder(batch.number);
    if (decisions::holdsScans(folder)) {
      submitted.warnings.push_back(about(
          batch.number, message("This batch contains imported scans and is not submitted; the "
                                "window's queue processes it.")));
      continue;
    }
    if (const auto own = intake::checkNotShared(project.catalogue(), project.folder(), batch, stop);
        !own) {
      if (!intake::isAboutShared(own.error().what)) return own.error();
      submitted.warnings.push_back(own.error().sentence());
      continue;
    }
    QuietProgress quiet;
    const Result<batch::Batch> read = batch::readPhotographs(folder, {}, {}, {}, quiet);
    if (!read) {
      submitted.warnings.push_back(read.error().sentence());
      continue;
    }
    const Result<std::string> photographs = batch::takingNow(folder, stop);
    if (!photographs) return photographs.error();
    wanted.push_back({batch.number, *photographs, pipeline::needsOf(*read, run, 0), before});
  }
  return wanted;
}

Result<void> hasRoom(const upkeep::Project& project, const Place& place, std::size_t batches,
                     const std::stop_token& stop) {
  const Result<std::string> told = place.run({"df", "-Pk", "."}, stop);
  if (!told) return told.error();
  const std::optional<double> free_mb = readFreeSpace_mb(*told);
  const double needed_mb =
      intake::bytesPerBatch(project.folder()) / 1e6 * static_cast<double>(batches);
  if (!free_mb || *free_mb >= needed_mb) return {};
  return Error{
      ErrorCode::CannotWrite,
      message("The cluster's disk has %1 GB left, but the batches to submit (%2) need about "
              "%3 GB. Nothing was submitted; free some space, or submit fewer with --most.",
              decimal(*free_mb / 1000, 1), batches, decimal(needed_mb / 1000, 1)),
      place.name()};
}

// The list knows of an array before Slurm does, so that no crash in between makes a batch run
// twice.
Result<std::string> submitArray(const upkeep::Project& project, const Place& place, Tasks& tasks,
                                std::span<const Wanted> wanted, const Ask& ask,
                                const std::stop_token& stop) {
  const std::string job = newJobName();
  std::vector<std::string> numbers;
  for (const Wanted& one : wanted) numbers.push_back(one.number);
  const fs::path script = project.folder() / scriptOf(job);
  if (const Result<void> written = writeFileAtomically(script, jobScript(job, numbers, ask));
      !written)
    return written.error();
  std::vector<std::string> sent{scriptOf(job)};
  for (const Wanted& one : wanted) {
    sent.push_back("batches/" + one.number);
    const std::string results = "results/" + one.number;
    if (one.goesOn()) {  // newer than what lies there is only what people made
      for (const std::string name : batch::kPeoplesFiles) sent.push_back(results + "/" + name);
      continue;
    }
    sent.push_back(results);
    // Of earlier photographs, and nothing that is sent takes their place.
    std::error_code failed;
    if (place.isRemote() && one.before != nullptr &&
        !fs::exists(project.folder() / results, failed))
      if (const auto gone = place.run({"rm", "-r", "-f", results}, stop); !gone)
        return gone.error();
  }
  if (const Result<void> there = place.send(sent, stop); !there) return there.error();

  const Tasks before = tasks;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Task task{.batch = numbers[i],
                    .job = job,
                    .number = static_cast<int>(i) + 1,
                    .memory_mb = ask.memory_mb,
                    .minutes = ask.minutes,
                    .photographs = wanted[i].photographs};
    if (Task* known = tasks.of(numbers[i]))
      *known = task;
    else
      tasks.tasks.push_back(task);
  }
  if (const Result<void> written = writeTasks(project.folder(), tasks); !written)
    return written.error();
  const Result<std::string> told = place.run({"sbatch", "--parsable", scriptOf(job)}, stop);
  if (told) return readJobId(*told).value_or(job);
  // Where the connection broke Slurm may have the array all the same: only what it says counts.
  const Result<std::string> queued = place.run(queueQuestion({job}), stop);
  if (!queued) return told.error();
  Queue queue;
  readQueue(*queued, queue);
  if (!queue.empty()) return job;
  tasks = before;
  if (const Result<void> written = writeTasks(project.folder(), tasks); !written)
    return written.error();
  std::error_code ignored;
  fs::remove(script, ignored);
  return told.error();
}

}  // namespace

void raiseTo(Ask& ask, const pipeline::Needs& needs, const TaskStatus* before) {
  int memory_mb =
          std::max(kLeastMemory_mb, static_cast<int>(std::ceil(kMemoryMargin * needs.memory_mb))),
      minutes = std::max(kLeastMinutes, static_cast<int>(std::ceil(kTimeMargin * needs.core_s / 60 /
                                                                   std::max(1, ask.cores))));
  if (before != nullptr && before->cause == Cause::Memory)
    memory_mb = std::max(memory_mb, 2 * before->task.memory_mb);
  if (before != nullptr && before->cause == Cause::Time)
    minutes = std::max(minutes, 2 * before->task.minutes);
  ask.memory_mb = std::min(std::max(ask.memory_mb, memory_mb), kMostMemory_mb);
  ask.minutes = std::min(std::max(ask.minutes, minutes), kMostMinutes);
}

Result<Submitted> submit(upkeep::Project& project, const SubmitOptions& options, Progress& progress,
                         std::stop_token stop) {
  if (const Result<void> good = options.ask.check(); !good) return good.error();
  const fs::path folder = clusterFolder(project.folder());
  if (const Result<void> made = makeFolder(folder); !made) return made.error();
  const Result<FolderLock> held = FolderLock::take(folder);
  if (!held) return held.error();
  Result<Tasks> tasks = readTasks(project.folder());
  if (!tasks) return tasks.error();
  const Result<Place> place = reach(project.catalogue(), project.folder(), options.access, *tasks);
  if (!place) return place.error();
  const Result<std::vector<TaskStatus>> known = statusOf(project.folder(), *place, *tasks, stop);
  if (!known) return known.error();
  const Result<bool> albedo = catalogue::Settings(project.catalogue()).texturesWithoutLight();
  if (!albedo) return albedo.error();
  Submitted submitted;
  const Result<std::vector<Wanted>> wanted = wantedOf(project, *known, options, submitted, stop);
  if (!wanted) return wanted.error();
  if (wanted->empty()) return submitted;
  const Result<std::string> owner = place->isRemote()
                                        ? ownerOf(project.catalogue(), project.folder())
                                        : Result<std::string>(std::string());
  if (!owner) return owner.error();
  if (const Result<void> ready = place->prepare(*owner, stop); !ready) return ready.error();
  if (const Result<void> room = hasRoom(project, *place, wanted->size(), stop); !room)
    return room.error();
  for (std::size_t done = 0; done < wanted->size();) {
    progress.report(static_cast<std::int64_t>(done), static_cast<std::int64_t>(wanted->size()));
    const std::size_t count = std::min<std::size_t>(kMostTasks, wanted->size() - done);
    const std::span<const Wanted> part(wanted->data() + done, count);
    Ask needed = options.ask;
    needed.memory_mb = needed.minutes = 0;
    needed.albedo = *albedo;
    for (const Wanted& one : part) raiseTo(needed, one.needs, one.before);
    if (options.ask.memory_mb > 0) needed.memory_mb = options.ask.memory_mb;
    if (options.ask.minutes > 0) needed.minutes = options.ask.minutes;
    // Before the decisions are sent: what is asked from now on is for the next computation.
    for (const Wanted& one : part)
      if (const Result<void> begun = intake::beginComputing(project.catalogue(), one.number);
          !begun)
        return begun.error();
    const Result<std::string> id = submitArray(project, *place, *tasks, part, needed, stop);
    if (!id) return id.error();
    for (const Wanted& one : part) submitted.batches.push_back(one.number);
    submitted.arrays.push_back(*id);
    submitted.memory_mb = std::max(submitted.memory_mb, needed.memory_mb);
    submitted.minutes = std::max(submitted.minutes, needed.minutes);
    done += count;
  }
  return submitted;
}

Result<std::vector<TaskStatus>> status(const fs::path& project, const Access& access,
                                       std::stop_token stop) {
  Result<Tasks> tasks = readTasks(project);
  if (!tasks) return tasks.error();
  // Where all is entered nobody need be asked.
  if (!tasks->anyUncollected()) {
    std::vector<TaskStatus> all;
    for (const Task& task : tasks->tasks) all.push_back(judge(task, nullptr, nullptr, {}));
    return all;
  }
  const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(project);
  if (!catalogue) return catalogue.error();
  const Result<Place> place = reach(*catalogue, project, access, *tasks);
  if (!place) return place.error();
  return statusOf(project, *place, *tasks, stop);
}

}  // namespace ostraka::cluster
