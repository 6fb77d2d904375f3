#include "merge/merge.h"

#include <algorithm>

#include "catalogue/history.h"
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

// What would be copied; a file of A at its place is the same one, or is refused on entering.
Result<void> countFiles(const fs::path& a, const fs::path& b, const Outcome& outcome,
                        MergeReport& report) {
  const Result<std::vector<FileCopy>> list = filesToCopy(a, b, outcome);
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
  for (const auto& [to, text] : outcome.peoples_files) {
    if (!text) continue;
    ++report.files;
    report.bytes += static_cast<std::int64_t>(text->size());
  }
  return {};
}

// What a merge has made, as a restored project is checked. A was whole when it was backed up.
Result<void> checkMerged(const Catalogue& catalogue) {
  const Result<void> whole = catalogue.checkIntegrity();
  if (!whole && whole.error().code == ErrorCode::Damaged)
    return Error{ErrorCode::Failed,
                 message("The merged catalogue would be inconsistent, so nothing was merged; "
                         "report this with a copy of both projects."),
                 catalogue.database().file().string()};
  return whole ? upkeep::checkValues(catalogue) : whole;
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
    MergeReport report = outcome;
    if (const Result<void> counted = countFiles(a_.folder(), b_folder_, outcome, report); !counted)
      return counted.error();
    if (mode == MergeMode::Preview || outcome.unsettled()) return report;
    if (!writes_ && report.files == 0) {
      report.entered = true;  // A has all that B has
      return report;
    }
    if (const auto saved = a_.backUp(); !saved) return saved.error();
    StagedFiles files(a_.folder());
    const Result<void> done = enter(outcome, history, files, progress, stop);
    if (!done) {
      files.drop();
      return done.error();
    }
    Result<std::vector<std::string>> kept =
        upkeep::placeStaged(a_.catalogue(), a_.folder(), progress, {});
    if (!kept) return kept.error();
    if (files.files() == 0) files.drop();
    report.entered = true;
    report.files = files.files();
    report.bytes = files.bytes();
    report.missing = files.missing();
    report.kept = std::move(*kept);
    return report;
  }

 private:
  enum class Keep { No, Yes };

  Result<void> enter(const Outcome& outcome, std::int64_t history, StagedFiles& files,
                     Progress& progress, const std::stop_token& stop) {
    const Result<std::vector<FileCopy>> list = filesToCopy(a_.folder(), b_folder_, outcome);
    if (!list) return list.error();
    // Nobody who wants to write waits for files to be copied.
    if (const Result<void> copied = files.copy(b_folder_, *list, progress, stop); !copied)
      return copied;
    for (const auto& [to, text] : outcome.peoples_files)
      if (const Result<void> expected = files.expect(to, stop); !expected) return expected;
    a_.catalogue().database().setWaiting({});
    Outcome entered;
    return pass(entered, Keep::Yes, [&]() -> Result<void> {
      if (catalogue_before_ != history || entered.copies != outcome.copies ||
          entered.incomplete != outcome.incomplete || entered.files_of != outcome.files_of ||
          entered.unsettled())
        return Error{ErrorCode::Failed,
                     message("The project changed while files were copied, so nothing was merged; "
                             "run the same command again."),
                     a_.folder().string()};
      for (const auto& [to, text] : entered.peoples_files)
        if (text)
          if (const Result<void> put = files.put(to, *text); !put) return put;
      return files.note(a_.catalogue(), entered);
    });
  }

  // Once, in one transaction, which is taken back unless it is kept.
  Result<void> pass(Outcome& outcome, Keep keep, const std::function<Result<void>()>& afterwards) {
    const Result<void> done = a_.catalogue().together([&]() -> Result<void> {
      store::Database& database = a_.catalogue().database();
      const auto written = [&] {
        return database.sql("SELECT total_changes()").one<std::int64_t>();
      };
      catalogue_before_ = catalogue::History(a_.catalogue()).length();
      const std::int64_t before = written();
      outcome =
          Merging({a_.catalogue(), a_.folder(), b_, b_folder_, content_}, settled_, provenance_)
              .run();
      writes_ = written() != before;
      if (keep == Keep::No) return Error::cancelled();
      const Result<void> good = checkMerged(a_.catalogue());
      return good ? afterwards() : good;
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
  MergeReport report;
  std::vector<std::string> kept = a.keptFiles();
  if (mode == MergeMode::Enter) {  // what was killed since A was opened
    const auto left = upkeep::placeStaged(a.catalogue(), a.folder(), progress, stop);
    if (!left) return left.error();
    kept.insert(kept.end(), left->begin(), left->end());
    if (const Result<void> none = upkeep::checkNoneWaits(a.catalogue(), a.folder()); !none)
      return none.error();
  }
  const Result<void> done = theirs->inSnapshot([&]() -> Result<void> {
    Result<MergeReport> merged =
        Merge(a, b, *theirs, settled, provenance).run(mode, progress, stop);
    if (!merged) return merged.error();
    report = std::move(*merged);
    return {};
  });
  if (!done) return done.error();
  report.kept.insert(report.kept.end(), kept.begin(), kept.end());
  return report;
}

}  // namespace ostraka::merge
