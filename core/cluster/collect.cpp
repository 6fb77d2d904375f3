#include "cluster/collect.h"

#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "base/message.h"
#include "base/text.h"
#include "batch/peoples_files.h"
#include "batch/photographs.h"
#include "catalogue/batches.h"
#include "cluster/place.h"
#include "cluster/tasks.h"
#include "decisions/change_peoples_file.h"
#include "files/contained_path.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "intake/compute_batch.h"
#include "intake/results_owner.h"
#include "review/review.h"
#include "stages/publish.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;
using records::BatchState;

const std::string kIncoming = "cluster/incoming/";
constexpr std::size_t kNamedOthers = 6;

// Within the project, and through no link.
Result<void> moved(const upkeep::Project& project, const fs::path& from, const fs::path& to) {
  const Result<OpenFolder> own = OpenFolder::open(project.folder());
  if (!own) return own.error();
  const auto source = ContainedPath::parse(from.lexically_relative(project.folder()).string()),
             target = ContainedPath::parse(to.lexically_relative(project.folder()).string());
  if (!source) return source.error();
  if (!target) return target.error();
  return own->move(*source, *target);
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

// What else lies in the cluster's folder is not the project's.
Result<void> leaveOthers(const std::string& batch, const fs::path& folder, Progress& progress) {
  const std::vector<std::string> others = stages::filesOfOthers(folder);
  for (const std::string& file : others) {
    std::error_code error;
    fs::remove(folder / file, error);
    if (error) return cannotWrite(folder / file, error.value());
  }
  if (!others.empty()) {
    const std::string names =
        joined(std::span(others).first(std::min(others.size(), kNamedOthers)), ", ");
    progress.note(NoteLevel::Warning,
                  about(batch, message("The folder on the cluster has files that Ostraka did not "
                                       "write (%1): %2. They were left there.",
                                       others.size(), names)));
  }
  return {};
}

fs::path replacedOf(const upkeep::Project& project, const std::string& batch) {
  return clusterFolder(project.folder()) / "replaced" / batch;
}

Result<void> removed(const fs::path& folder) {
  if (const Result<void> own = checkNoLinkInProject(folder); !own) return own;
  std::error_code error;
  fs::remove_all(folder, error);
  return error ? Result<void>(cannotWrite(folder, error.value())) : Result<void>();
}

// What people say of the batch stays with it, whichever results it has: within changePeoplesFile.
Result<void> keepPeoplesFiles(const fs::path& results, const fs::path& folder) {
  std::error_code error;
  for (const std::string name : batch::kPeoplesFiles) {
    if (!fs::exists(results / name, error)) continue;
    const Result<std::string> text = readFile(results / name);
    if (!text) return text.error();
    if (const Result<void> kept = writeFileAtomically(folder / name, *text); !kept) return kept;
  }
  return {};
}

// Of a collection that was killed or failed: what was not entered gives way again to the results
// that it replaced.
Result<void> putBack(const upkeep::Project& project, const std::string& batch) {
  std::error_code error;
  const fs::path replaced = replacedOf(project, batch), results = project.resultsFolder(batch),
                 incoming = project.folder() / (kIncoming + batch);
  if (!fs::exists(replaced, error)) return {};
  for (const fs::path& own : {replaced, results})
    if (const Result<void> good = checkNoLinkInProject(own); !good) return good;
  return decisions::changePeoplesFile(results, [&]() -> Result<void> {
    if (fs::exists(results, error)) {
      if (const Result<void> kept = keepPeoplesFiles(results, replaced); !kept) return kept;
      if (const Result<void> gone = removed(incoming); !gone) return gone;
      if (const Result<void> aside = moved(project, results, incoming); !aside) return aside;
    }
    return moved(project, replaced, results);
  });
}

// What was entered before an error stays.
Result<void> settleReplaced(const upkeep::Project& project, const records::BatchRecord& batch,
                            bool entered) {
  const Result<records::BatchRecord> now = catalogue::Batches(project.catalogue()).get(batch.row);
  if (!now) return now.error();
  entered |= now->state == BatchState::Review || now->state == BatchState::Done;
  return entered ? removed(replacedOf(project, batch.number)) : putBack(project, batch.number);
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
    if (const Result<void> gone = removed(replacedOf(project, batch)); !gone) return gone.error();
    progress.note(
        NoteLevel::Warning,
        about(batch, message("This batch was processed here or reshot in the meantime; the "
                             "cluster's results are not entered.")));
    return Entry{};
  }
  const Result<std::string> taking = batch::takingNow(project.batchFolder(batch), stop);
  if (!taking) return taking.error();
  if (*taking != task.photographs)
    return Entry{
        false,
        {},
        about(batch, message("This batch was photographed again after it was submitted; the "
                             "cluster's results are not entered. Submit it again."))};
  if (place.isRemote()) {
    if (const Result<void> whole = putBack(project, batch); !whole) return whole.error();
    // Of what people say the cluster has copies as old as the job.
    const std::vector<std::string> but(std::begin(batch::kPeoplesFiles),
                                       std::end(batch::kPeoplesFiles));
    if (const Result<void> here = place.fetch("results/" + batch, kIncoming + batch, 0, but, stop);
        !here)
      return here.error();
    const fs::path incoming = project.folder() / (kIncoming + batch);
    const auto own =
        intake::checkResultsAreOf(project.catalogue(), project.folder(), *record, incoming, stop);
    if (!own) return own.error();
    if (const Result<void> taken = takePlace(project, batch, incoming, progress); !taken)
      return taken.error();
  }
  Result<intake::BatchFigures> figures = intake::enterComputed(project, *record, progress, stop);
  if (place.isRemote())
    if (const Result<void> settled = settleReplaced(project, *record, figures.has_value());
        !settled)
      progress.note(NoteLevel::Warning, settled.error().sentence());
  if (!figures) return figures.error();
  return Entry{true, std::move(*figures), {}};
}

}  // namespace

Result<void> takePlace(const upkeep::Project& project, const std::string& batch,
                       const fs::path& folder, Progress& progress) {
  if (const Result<void> good = checkNames(folder); !good) return good;
  if (const Result<void> left = leaveOthers(batch, folder, progress); !left) return left;
  const fs::path results = project.resultsFolder(batch), replaced = replacedOf(project, batch);
  if (const Result<void> own = checkNoLinkInProject(results); !own) return own;
  std::error_code error;
  if (!fs::exists(results, error)) return moved(project, folder, results);
  std::optional<FolderLock> held;
  if (fs::exists(results / "work", error)) {
    Result<FolderLock> taken = FolderLock::take(results / "work");
    if (!taken) return taken.error();
    held.emplace(std::move(*taken));
  }
  return decisions::changePeoplesFile(results, [&]() -> Result<void> {
    if (const Result<void> kept = keepPeoplesFiles(results, folder); !kept) return kept;
    if (const Result<void> gone = removed(replaced); !gone) return gone;
    if (const Result<void> aside = moved(project, results, replaced); !aside) return aside;
    return moved(project, folder, results);
  });
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
