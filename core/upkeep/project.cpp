#include "upkeep/project.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>
#include <vector>

#include "base/message.h"
#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "files/output_place.h"
#include "records/numbering.h"
#include "store/database.h"
#include "store/file_header.h"
#include "store/migrations.h"
#include "store/network_share.h"
#include "store/partial_file.h"
#include "store/schema_check.h"
#include "upkeep/archived_project.h"
#include "upkeep/backups.h"
#include "upkeep/file_check.h"
#include "upkeep/staged_files.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "catalogue.sqlite";
constexpr std::array<const char*, 3> kFolders = {"batches", "results", "backups"};
constexpr std::string_view kOwnFolders[] = {"batches", "results",  "backups",
                                            "models",  "imported", "cluster"};

catalogue::Catalogue::Clock orSystemClock(const catalogue::Catalogue::Clock& clock) {
  if (clock) return clock;
  return [] {
    return std::int64_t{std::chrono::duration_cast<std::chrono::milliseconds>(
                            std::chrono::system_clock::now().time_since_epoch())
                            .count()};
  };
}

Error refused(Message what, const fs::path& where) {
  return Error::unusable(std::move(what), where.string());
}

Result<void> checkFolder(const fs::path& folder) {
  if (const std::string share = store::networkShareOf(fs::absolute(folder)); !share.empty())
    return refused(
        message("The folder is on a network share (%1), which can damage catalogues; use a folder "
                "on this computer's own disk and copy backups to the share.",
                share),
        folder);
  return {};
}

Result<catalogue::Catalogue> openCatalogue(const fs::path& folder,
                                           const catalogue::Catalogue::Clock& clock,
                                           const store::Waiting& waiting) {
  using Mode = store::Database::Mode;
  const fs::path file = folder / kFile;
  std::error_code code;
  if (!fs::is_regular_file(file, code)) {
    if (const Result<void> good = checkOutsideArchives(folder); !good) return good.error();
    return refused(message("Not an Ostraka project: this folder has no catalogue.sqlite."), folder);
  }
  if (const Result<void> own =
          checkNoLinkedFolder(folder, kOwnFolders, LinkedFolders::OfTheseNames);
      !own)
    return own.error();
  const bool writable = mayBeWritten(folder) && mayBeWritten(file);
  if (writable)
    if (const Result<void> good = checkOutsideArchives(folder); !good) return good.error();
  Result<std::unique_ptr<store::Database>> database =
      store::Database::open(file, writable ? Mode::ReadWrite : Mode::ReadOnly, waiting);
  if (!database) return database.error();
  // Anybody may have written it: what it says is read before any of it is run.
  if (const Result<void> ours = store::checkSchema(**database); !ours) return ours.error();
  if (writable)
    if (const Result<void> ready = (*database)->writeAhead(); !ready) return ready.error();
  catalogue::Catalogue catalogue(std::move(*database), orSystemClock(clock));
  if (!writable && catalogue.schemaVersion() < store::migrations().back().number)
    return refused(message("An older Ostraka made this project, and it is read-only here; copy it "
                           "to a folder that "
                           "you can write to, and open it there."),
                   folder);
  const auto save = [&]() -> Result<void> {
    const Result<fs::path> copy = backUpInto(folder, catalogue, "-before-update");
    return copy ? Result<void>() : copy.error();
  };
  if (const Result<void> done = store::migrate(catalogue.database(), store::migrations(), save);
      !done)
    return done.error();
  const Result<records::ProjectRecord> record = catalogue::Settings(catalogue).project();
  if (!record) return record.error();
  if (record->id.empty()) return store::damagedCatalogue(message("it contains no project"), file);
  return catalogue;
}

// Nothing, or what a killed process left of a project that it was making.
bool isFree(const fs::path& folder) {
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    const bool ours = std::find(kFolders.begin(), kFolders.end(), name) != kFolders.end();
    if (ours ? !fs::is_directory(entry.symlink_status()) || !fs::is_empty(entry.path(), code)
             : !store::PartialFile::isLeftover(entry.path()))
      return false;
  }
  return !code;
}

}  // namespace

Result<void> checkOutsideArchives(const fs::path& project) {
  const fs::path archive = archiveAt(project);
  if (archive.empty()) return {};
  return refused(message("This project lies in the archive '%1', which any change would make "
                         "invalid; restore the archive to a new folder, and open that.",
                         archive.string()),
                 project);
}

Result<Project> Project::create(const fs::path& folder, const records::ProjectRecord& record,
                                const catalogue::Catalogue::Clock& clock) {
  if (const Result<void> good = checkOutputPlace(folder); !good) return good.error();
  std::error_code code;
  const bool there = fs::exists(folder, code);
  if (there && (!fs::is_directory(folder, code) || !isFree(folder)))
    return refused(message("A new project needs a new or empty folder; choose another name."),
                   folder);
  if (const Result<void> good = checkFolder(folder); !good) return good.error();
  const auto undone = [&](const Error& error) {
    std::error_code ignored;
    for (const char* name : kFolders) fs::remove(folder / name, ignored);
    if (!there) fs::remove(folder, ignored);
    return error;
  };
  for (const char* name : kFolders) {
    fs::create_directories(folder / name, code);
    if (code == std::errc::no_space_on_device) return undone(cannotWrite(folder, code.value()));
    if (code)
      return undone(
          {ErrorCode::CannotWrite,
           message("The folder cannot be created; choose a location that you can write to."),
           folder.string()});
  }
  store::PartialFile::removeLeftovers(folder);
  const auto make = [&]() -> Result<void> {
    Result<store::PartialFile> file = store::PartialFile::beside(folder / kFile);
    if (!file) return file.error();
    {
      Result<std::unique_ptr<store::Database>> database =
          store::Database::open(file->path(), store::Database::Mode::Create);
      if (!database) return database.error();
      const Result<void> ready = store::migrate(**database, store::migrations(), {});
      if (!ready) return ready;
      catalogue::Catalogue catalogue(std::move(*database), orSystemClock(clock));
      const Result<void> set =
          catalogue::Settings(catalogue).setProject(record, {{}, "new project", {}});
      if (!set) return set;
    }
    return file->become(folder / kFile, store::PartialFile::Existing::Refused);
  };
  if (const Result<void> made = make(); !made) return undone(made.error());
  Result<Project> opened = open(folder, clock);
  if (opened) return opened;
  // What is said to have failed must not be in the way when it is tried again.
  for (const char* part : {"-wal", "-shm", ""}) fs::remove((folder / kFile).string() + part, code);
  return undone(opened.error());
}

Result<Project> Project::open(const fs::path& folder, const catalogue::Catalogue::Clock& clock,
                              const store::Waiting& waiting) {
  if (const Result<void> good = checkFolder(folder); !good) return good.error();
  Result<catalogue::Catalogue> catalogue = openCatalogue(folder, clock, waiting);
  if (!catalogue) return catalogue.error();
  // Once for all connections: those of other threads come later, and read it for each sherd.
  if (const Result<void> inside = checkPaths(*catalogue); !inside) return inside.error();
  if (const Result<void> own = checkNoLinkInCluster(folder); !own) return own.error();
  Project project(fs::absolute(folder), std::move(*catalogue));
  if (project.catalogue().readOnly()) return project;
  for (const fs::path& place : {folder, folder / "backups"})
    store::PartialFile::removeLeftovers(place);
  Result<std::vector<std::string>> kept = finishMerge(project.catalogue_, project.folder_, waiting);
  if (!kept) return kept.error();
  project.kept_files_ = std::move(*kept);
  return project;
}

Result<bool> Project::removeUnused(const fs::path& folder, std::int64_t history) {
  {
    const Result<Project> project = open(folder);
    if (!project) return project.error();
    if (catalogue::History(project->catalogue()).length() > history) return false;
  }
  const std::array<std::string, 3> database = {std::string(kFile) + "-wal",
                                                std::string(kFile) + "-shm", kFile};
  std::vector<fs::path> folders;
  std::error_code code;
  for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    const std::string name = at->path().filename().string();
    if (std::find(kFolders.begin(), kFolders.end(), name) != kFolders.end())
      folders.push_back(at->path());
    else if (std::find(database.begin(), database.end(), name) == database.end())
      return false;
  }
  if (code) return cannotWrite(folder, code.value());
  std::vector<fs::path> all;  // in the order in which they go
  for (const fs::path& own : folders) {
    for (fs::directory_iterator at(own, code), end; !code && at != end; at.increment(code)) {
      if (own.filename() != "backups" || !at->path().filename().string().starts_with("catalogue-"))
        return false;
      all.push_back(at->path());
    }
    if (code) return cannotWrite(own, code.value());
  }
  // The catalogue last: a folder that somebody filled meanwhile is not empty and leaves it whole.
  all.insert(all.end(), folders.begin(), folders.end());
  for (const std::string& name : database) all.push_back(folder / name);
  all.push_back(folder);
  for (const fs::path& one : all)
    if (fs::remove(one, code); code) return cannotWrite(one, code.value());
  return true;
}

bool Project::isProject(const fs::path& folder) {
  std::error_code code;
  return fs::is_regular_file(folder / kFile, code);
}

Result<catalogue::Catalogue> Project::connect(const fs::path& folder) {
  return openCatalogue(folder, {}, {});
}

fs::path Project::batchFolder(const std::string& number) const {
  return folder_ / "batches" / number;
}
fs::path Project::resultsFolder(const std::string& number) const {
  return folder_ / "results" / number;
}

}  // namespace ostraka::upkeep
