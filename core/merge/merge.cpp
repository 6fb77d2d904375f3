#include "merge/merge.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text.h"
#include "catalogue/history.h"
#include "decisions/decisions.h"
#include "files/folder_lock.h"
#include "merge/merging.h"
#include "merge/staged_files.h"
#include "store/database.h"
#include "store/migrations.h"
#include "store/schema_check.h"
#include "upkeep/file_check.h"
#include "upkeep/value_check.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;
using catalogue::Catalogue;

// For reading only: B may be anybody's, and is left as it is.
Result<Catalogue> openToRead(const fs::path& folder, const Catalogue::Clock& clock) {
  if (!upkeep::Project::isProject(folder))
    return Error::unusable(
        message("Not an Ostraka project: this folder has no catalogue.sqlite; nothing was merged."),
        folder.string());
  Result<std::unique_ptr<store::Database>> database =
      store::Database::open(folder / "catalogue.sqlite", store::Database::Mode::ReadOnly);
  if (!database) return database.error();
  if (const Result<void> ours = store::checkSchema(**database); !ours) return ours.error();
  Catalogue catalogue(std::move(*database), clock);
  if (catalogue.schemaVersion() != store::migrations().back().number)
    return Error::unusable(
        message(
            "Another version of Ostraka made this project; nothing was merged. Open it once with "
            "this version, which updates it, or install the newer version."),
        folder.string());
  if (const Result<void> whole = catalogue.checkIntegrity(); !whole) return whole.error();
  if (const Result<void> inside = upkeep::checkPaths(catalogue); !inside) return inside.error();
  if (const Result<void> good = upkeep::checkValues(catalogue); !good) return good.error();
  return catalogue;
}

Result<void> checkProjects(const upkeep::Project& a, const fs::path& b) {
  std::error_code failed;
  if (fs::equivalent(a.folder(), b, failed))
    return Error::unusable(message("A project cannot be merged with itself; name another project."),
                           b.string());
  if (a.catalogue().readOnly())
    return Error{
        ErrorCode::CannotWrite,
        message("This project is read-only here, so nothing was merged; copy it to a folder "
                "that you can write to."),
        a.folder().string()};
  return {};
}

MergeReport reportOf(const Outcome& outcome) {
  MergeReport report;
  report.added = outcome.added;
  report.changed = outcome.changed;
  report.conflicts = outcome.conflicts;
  report.renumbered = outcome.batches;
  const auto fresh = [&](const char* table) {
    const auto found = outcome.new_rows.find(table);
    return found == outcome.new_rows.end() ? 0 : found->second;
  };
  report.sherds = fresh("sherd");
  report.batches = fresh("batch");
  return report;
}

// What would be copied; a file of A at its place is the same one, or is refused on entering.
Result<void> countFiles(const fs::path& a, const fs::path& b, const Outcome& outcome,
                        MergeReport& report) {
  const Result<std::vector<FileCopy>> list = filesToCopy(b, outcome);
  if (!list) return list.error();
  for (const FileCopy& file : *list) {
    std::error_code failed;
    const auto bytes = fs::file_size(b / file.from, failed);
    if (failed) {
      report.missing.push_back(file.from);
    } else if (file.replaces || !fs::exists(a / file.to, failed)) {
      ++report.files;
      report.bytes += static_cast<std::int64_t>(bytes);
    }
  }
  return {};
}

// What both projects' lists of decisions say, for the next computation of the batch.
Result<void> joinDecisions(StagedFiles& files, const fs::path& a, const fs::path& b,
                           const Outcome& outcome) {
  for (const auto& [there, here] : outcome.joint_decisions) {
    Result<decisions::Decisions> all = decisions::readDecisions(a / here);
    const Result<decisions::Decisions> theirs = decisions::readDecisions(b / there);
    if (!all) return all.error();
    if (!theirs) return theirs.error();
    std::set<std::string> known;
    for (const decisions::PairDecision& decision : *all) known.insert(decision.id);
    const std::size_t before = all->size();
    for (const decisions::PairDecision& decision : *theirs)
      if (known.insert(decision.id).second) all->push_back(decision);
    for (const std::string& id : known) {
      const auto lost = outcome.withdrawn.find(id);
      if (lost == outcome.withdrawn.end()) continue;
      decisions::PairDecision withdrawn;
      withdrawn.id = lost->second;
      withdrawn.replaces = {id};
      withdrawn.kind = decisions::DecisionKind::Withdraw;
      withdrawn.at = utcNow();
      withdrawn.by = "merge";
      all->push_back(std::move(withdrawn));
    }
    if (all->size() == before) continue;
    if (const Result<void> put =
            files.put(here + "/decisions.json", decisions::toJson(*all).dump(1) + "\n");
        !put)
      return put;
  }
  return {};
}

class Merge {
 public:
  Merge(upkeep::Project& a, fs::path b_folder, const Catalogue& b, const Settled& settled,
        const records::Provenance& provenance)
      : a_(a), b_folder_(std::move(b_folder)), b_(b), settled_(settled), provenance_(provenance) {}

  Result<MergeReport> run(MergeMode mode, Progress& progress, const std::stop_token& stop) {
    content_ = readContent(b_.database());
    Outcome outcome;
    const std::int64_t history = catalogue::History(a_.catalogue()).length();
    if (const Result<void> fits = pass(outcome, Keep::No, nullptr); !fits) return fits.error();
    MergeReport report = reportOf(outcome);
    if (mode == MergeMode::Preview || outcome.unsettled()) {
      const Result<void> counted = countFiles(a_.folder(), b_folder_, outcome, report);
      return counted ? Result<MergeReport>(std::move(report)) : counted.error();
    }
    if (!writes_) {
      report.entered = true;  // A has all of it
      return report;
    }
    if (const auto saved = a_.backUp(); !saved) return saved.error();
    Result<StagedFiles> files = StagedFiles::begin(a_.catalogue(), a_.folder());
    if (!files) return files.error();
    const Result<void> done = enter(outcome, history, *files, progress, stop);
    if (!done) {
      files->drop();
      return done.error();
    }
    if (const Result<void> placed = files->finish(a_.catalogue()); !placed) return placed.error();
    report.entered = true;
    report.files = files->files();
    report.bytes = files->bytes();
    report.missing = files->missing();
    return report;
  }

 private:
  enum class Keep { No, Yes };

  Result<void> enter(const Outcome& outcome, std::int64_t history, StagedFiles& files,
                     Progress& progress, const std::stop_token& stop) {
    const Result<std::vector<FileCopy>> list = filesToCopy(b_folder_, outcome);
    if (!list) return list.error();
    // Nobody who wants to write waits for files to be copied.
    if (const Result<void> copied = files.copy(b_folder_, *list, progress, stop); !copied)
      return copied;
    a_.catalogue().database().setWaiting({});
    Outcome entered;
    return pass(entered, Keep::Yes, [&]() -> Result<void> {
      if (catalogue_before_ != history || entered.copies != outcome.copies ||
          entered.files_of != outcome.files_of || entered.unsettled())
        return Error{ErrorCode::Failed,
                     message("The project changed while files were copied, so nothing was merged; "
                             "run the same command again."),
                     a_.folder().string()};
      if (const Result<void> joined = joinDecisions(files, a_.folder(), b_folder_, entered);
          !joined)
        return joined;
      return files.note(a_.catalogue());
    });
  }

  // Once, in one transaction, which is taken back unless it is kept.
  Result<void> pass(Outcome& outcome, Keep keep, const std::function<Result<void>()>& afterwards) {
    const Result<void> done = a_.catalogue().together([&]() -> Result<void> {
      store::Database& database = a_.catalogue().database();
      const auto written = [&] {
        std::int64_t rows = 0;
        store::Statement changes = database.sql("SELECT total_changes()");
        if (changes.next()) changes >> rows;
        return rows;
      };
      catalogue_before_ = catalogue::History(a_.catalogue()).length();
      const std::int64_t before = written();
      outcome = Merging({a_.catalogue(), a_.folder(), b_, content_}, settled_, provenance_).run();
      writes_ = written() != before;
      if (keep == Keep::No) return Error::cancelled();
      return afterwards();
    });
    const bool taken_back = keep == Keep::No && !done && done.error().code == ErrorCode::Cancelled;
    return taken_back ? Result<void>() : done;
  }

  upkeep::Project& a_;
  fs::path b_folder_;
  const Catalogue& b_;
  const Settled& settled_;
  const records::Provenance& provenance_;
  Content content_;
  std::int64_t catalogue_before_ = 0;  ///< rows of A's history when the last pass began
  bool writes_ = false;                ///< the last pass changed something
};

}  // namespace

bool MergeReport::unsettled() const {
  return std::any_of(conflicts.begin(), conflicts.end(),
                     [](const Conflict& conflict) { return !conflict.settled; });
}

Result<MergeReport> mergeInto(upkeep::Project& a, const fs::path& b, MergeMode mode,
                              const Settled& settled, const records::Provenance& provenance,
                              Progress& progress, std::stop_token stop) {
  if (const Result<void> good = checkProjects(a, b); !good) return good.error();
  const Result<Catalogue> theirs = openToRead(b, [&a] { return a.catalogue().now(); });
  if (!theirs) return theirs.error();
  const Result<FolderLock> alone = FolderLock::waitFor(
      a.folder(),
      message("Another import into this project is running; this one waits until it has finished."),
      progress, stop);
  if (!alone) return alone.error();
  if (mode == MergeMode::Enter)  // what a merge that was killed left
    if (const Result<StagedFiles> left = StagedFiles::begin(a.catalogue(), a.folder()); !left)
      return left.error();
  MergeReport report;
  const Result<void> done = theirs->inSnapshot([&]() -> Result<void> {
    Result<MergeReport> merged =
        Merge(a, b, *theirs, settled, provenance).run(mode, progress, stop);
    if (!merged) return merged.error();
    report = std::move(*merged);
    return {};
  });
  if (!done) return done.error();
  return report;
}

}  // namespace ostraka::merge
