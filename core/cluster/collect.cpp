#include "cluster/collect.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "batch/peoples_files.h"
#include "catalogue/batches.h"
#include "cluster/place.h"
#include "cluster/tasks.h"
#include "files/contained_path.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "files/open_folder.h"
#include "intake/compute_batch.h"
#include "intake/side_photographs.h"
#include "review/review.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;
using records::BatchState;

const std::string kIncoming = "cluster/incoming/";

Result<void> moved(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) return cannotWrite(to, error.value());
  syncFolder(to.parent_path());
  return {};
}

Result<void> checkNames(const fs::path& folder) {
  const Result<OpenFolder> above = OpenFolder::open(folder.parent_path());
  if (!above) return above.error();
  const Result<ContainedPath> name = ContainedPath::parse(folder.filename().string());
  if (!name) return name.error();
  const auto entries = above->filesBelow(*name);
  if (!entries) return entries.error();
  for (const OpenFolder::Entry& entry : *entries)
    if (!entry.is_regular || !ContainedPath::parse(entry.path))
      return Error::unusable(
          message("Results from a cluster must be regular files with plain names; nothing of this "
                  "batch was entered. Submit the batch again."),
          (folder.parent_path() / entry.path).string());
  return review::computedToItsEnd(folder);
}

fs::path replacedOf(const upkeep::Project& project, const std::string& batch) {
  return clusterFolder(project.folder()) / "replaced" / batch;
}

// Killed between the two renamings, the old results stand aside and nothing is in their place.
Result<void> undoHalf(const upkeep::Project& project, const std::string& batch) {
  std::error_code error;
  const fs::path replaced = replacedOf(project, batch), results = project.resultsFolder(batch);
  if (!fs::exists(replaced, error)) return {};
  if (!fs::exists(results, error)) return moved(replaced, results);
  fs::remove_all(replaced, error);
  return error ? Result<void>(cannotWrite(replaced, error.value())) : Result<void>();
}

struct Entry {
  bool entered = false;  ///< else the batch was not to be
  intake::BatchFigures figures;
  Message why_not;  ///< if a person must act
};

Result<Entry> enter(upkeep::Project& project, const Place& place, const Task& task,
                    Progress& progress, const std::stop_token& stop) {
  const std::string& batch = task.batch;
  const Result<records::BatchRecord> record =
      catalogue::Batches(project.catalogue()).byNumber(batch);
  if (!record) return record.error();
  if (record->state != BatchState::Queued && record->state != BatchState::Computed) {
    progress.note(
        NoteLevel::Warning,
        about(batch, message("This batch was processed here or reshot in the meantime; the "
                             "cluster's results are not entered.")));
    return Entry{};
  }
  const Result<std::string> taking = intake::takingNow(project.batchFolder(batch), stop);
  if (!taking) return taking.error();
  if (*taking != task.photographs)
    return Entry{
        false,
        {},
        about(batch, message("This batch was photographed again after it was submitted; the "
                             "cluster's results are not entered. Submit it again."))};
  if (place.isRemote()) {
    if (const Result<void> whole = undoHalf(project, batch); !whole) return whole.error();
    // Of what people say the cluster has copies as old as the job.
    const std::vector<std::string> but(std::begin(batch::kPeoplesFiles),
                                       std::end(batch::kPeoplesFiles));
    if (const Result<void> here = place.fetch("results/" + batch, kIncoming + batch, 0, but, stop);
        !here)
      return here.error();
    if (const Result<void> taken =
            takePlace(project, batch, project.folder() / (kIncoming + batch));
        !taken)
      return taken.error();
  }
  Result<intake::BatchFigures> figures = intake::enterComputed(project, *record, progress, stop);
  if (!figures) return figures.error();
  return Entry{true, std::move(*figures), {}};
}

}  // namespace

Result<void> takePlace(const upkeep::Project& project, const std::string& batch,
                       const fs::path& folder) {
  if (const Result<void> good = checkNames(folder); !good) return good;
  const fs::path results = project.resultsFolder(batch), replaced = replacedOf(project, batch);
  std::error_code error;
  if (!fs::exists(results, error)) return moved(folder, results);
  std::optional<FolderLock> held;
  if (fs::exists(results / "work", error)) {
    Result<FolderLock> taken = FolderLock::take(results / "work");
    if (!taken) return taken.error();
    held.emplace(std::move(*taken));
  }
  for (const std::string name : batch::kPeoplesFiles) {
    if (!fs::exists(results / name, error)) continue;
    const Result<std::string> text = readFile(results / name);
    if (!text) return text.error();
    if (const Result<void> kept = writeFileAtomically(folder / name, *text); !kept) return kept;
  }
  if (const Result<void> made = makeFolder(replaced.parent_path()); !made) return made;
  fs::remove_all(replaced, error);
  if (error) return cannotWrite(replaced, error.value());
  if (const Result<void> aside = moved(results, replaced); !aside) return aside;
  if (const Result<void> there = moved(folder, results); !there) return there;
  fs::remove_all(replaced, error);
  return {};
}

Result<Collected> collect(upkeep::Project& project, const Access& access, Progress& progress,
                          std::stop_token stop) {
  const fs::path folder = clusterFolder(project.folder());
  Collected collected;
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return collected;
  const Result<FolderLock> held = FolderLock::take(folder);
  if (!held) return held.error();
  Result<Tasks> tasks = readTasks(project.folder());
  if (!tasks) return tasks.error();
  if (!tasks->anyUncollected()) return collected;
  const Result<Place> place = reach(project.catalogue(), project.folder(), access, *tasks);
  if (!place) return place.error();
  const Result<std::vector<TaskStatus>> all = statusOf(project.folder(), *place, *tasks, stop);
  if (!all) return all.error();
  std::int64_t done = 0;
  for (const TaskStatus& one : *all) {
    progress.report(done++, static_cast<std::int64_t>(all->size()));
    if (one.state == TaskState::Collected) continue;
    if (one.state != TaskState::Done) {
      collected.left.push_back(one);
      continue;
    }
    const Result<Entry> entry = enter(project, *place, one.task, progress, stop);
    if (!entry) {
      if (stop.stop_requested() || entry.error().code == ErrorCode::CannotWrite)
        return entry.error();
      collected.warnings.push_back(entry.error().sentence());
      collected.left.push_back(one);
      // Results that cannot be used are computed again; a line that broke is only tried again.
      if (entry.error().code == ErrorCode::Failed) continue;
      std::erase_if(tasks->tasks, [&](const Task& t) { return t.batch == one.task.batch; });
      if (const Result<void> written = writeTasks(project.folder(), *tasks); !written)
        return written.error();
      continue;
    }
    if (entry->entered) {
      collected.batches.push_back(one.task.batch);
      collected.sherds += entry->figures.sherds;
      collected.ask += entry->figures.ask;
    }
    if (!entry->why_not.empty()) collected.warnings.push_back(entry->why_not);
    tasks->of(one.task.batch)->collected = true;
    if (const Result<void> written = writeTasks(project.folder(), *tasks); !written)
      return written.error();
  }
  return collected;
}

}  // namespace ostraka::cluster
