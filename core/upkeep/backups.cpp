// Copies of the catalogue, and which of them make room for new ones.
#include "upkeep/backups.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/message.h"
#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "files/contained_path.h"
#include "files/files.h"
#include "store/database.h"
#include "store/file_header.h"
#include "store/partial_file.h"
#include "store/schema_check.h"
#include "upkeep/project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

const std::string kBackup = "catalogue-";  // and the time: 20261121-181557-123
const std::size_t kDayLetters = kBackup.size() + 8;

// Made while the clock was ahead, or by no program of ours: it says nothing of how new it is.
bool isOfLater(const fs::path& file, std::int64_t now_ms) {
  return file.filename().string() > kBackup + timeStamp(now_ms) + "~";
}

// None of what is no catalogue of ours: it may have come with a stranger's archive.
std::optional<Backup> readBackup(const fs::path& file) {
  if (!store::checkSchema(file)) return std::nullopt;
  const auto database = store::Database::open(file, store::Database::Mode::ReadOnly);
  if (!database) return std::nullopt;
  const Result<Backup> read = (*database)->asResult([&] {
    Backup backup{file, {}, 0};
    store::Statement row =
        (*database)->sql("SELECT id, (SELECT ifnull(max(number), 0) FROM history) FROM project");
    row.read(backup.project, backup.history);
    return backup;
  });
  return read && !read->project.empty() ? std::optional(*read) : std::nullopt;
}

// How many of the files that a backup knows lie in the folder; those read before any damage.
int filesIn(const fs::path& folder, const fs::path& backup) {
  int found = 0;
  const auto database = store::Database::open(backup, store::Database::Mode::ReadOnly);
  if (!database) return found;
  const Result<void> counted = (*database)->asResult([&] {
    store::Statement rows = (*database)->sql("SELECT path FROM file");
    std::error_code failed;
    for (std::string path; rows.read(path);)
      if (const Result<ContainedPath> inside = ContainedPath::parse(path))
        found += fs::exists(fs::symlink_status(folder / path, failed)) ? 1 : 0;
  });
  static_cast<void>(counted);
  return found;
}

}  // namespace

// 20261121-181557-123: sorts as time does.
std::string timeStamp(std::int64_t now_ms) {
  const std::time_t seconds = static_cast<std::time_t>(now_ms / 1000);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[40];
  const std::size_t size = std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &parts);
  const std::string milliseconds = std::to_string(1000 + now_ms % 1000).substr(1);
  return std::string(text, size) + "-" + milliseconds;
}

Result<fs::path> backUpInto(const fs::path& folder, const catalogue::Catalogue& catalogue,
                            const std::string& kind) {
  // A connection still shows what it read before the file under it was emptied.
  if (const Result<void> live = store::checkHeader(catalogue.database().file()); !live)
    return live.error();
  std::error_code code;
  if (const Result<void> made = makeFolder(folder / "backups"); !made) return made.error();
  store::PartialFile::removeLeftovers(folder / "backups");
  fs::path file = folder / "backups" / (kBackup + timeStamp(catalogue.now()) + kind + ".sqlite");
  for (int more = 2; fs::exists(file, code); ++more)
    file = folder / "backups" /
           (kBackup + timeStamp(catalogue.now()) + kind + "-" + std::to_string(more) + ".sqlite");
  if (const Result<void> made = catalogue.backup(file); !made) return made.error();
  return file;
}

Result<fs::path> Project::backUp(int keep, int days) const {
  Result<fs::path> file = backUpInto(folder_, catalogue_, {});
  if (!file) return file;
  const Result<records::ProjectRecord> project = catalogue::Settings(catalogue_).project();
  if (!project) return project.error();
  // Copies made before an update or a repair are for life, and so are those with changes that this
  // one lacks; only the others of this project make room.
  const std::int64_t history = catalogue::History(catalogue_).length();
  std::error_code ignored;
  int seen = 0;
  std::set<std::string> seen_days;
  for (const Backup& old : copiesOf(project->id, backups())) {
    const std::string name = old.file.filename().string();
    if (name.find("-before-") != std::string::npos || isOfLater(old.file, catalogue_.now()) ||
        old.history > history)
      continue;
    const bool last_of_its_day = seen_days.insert(name.substr(0, kDayLetters)).second;
    const bool kept_for_its_day = last_of_its_day && static_cast<int>(seen_days.size()) <= days;
    if (++seen > keep && !kept_for_its_day && old.file != *file) fs::remove(old.file, ignored);
  }
  return file;
}

Result<bool> Project::backUpIfChanged(std::chrono::milliseconds after) const {
  const std::int64_t history = catalogue::History(catalogue_).length();
  if (history == 0) return false;
  const std::vector<fs::path> copies = backups();
  if (!copies.empty() && !isOfLater(copies.front(), catalogue_.now())) {
    // The names sort as their times do.
    const std::string soon = kBackup + timeStamp(catalogue_.now() - after.count());
    if (soon < copies.front().filename().string()) return false;
    // Not by when it was changed: the clock may have been behind then.
    const Result<records::ProjectRecord> own = catalogue::Settings(catalogue_).project();
    if (!own) return own.error();
    const std::optional<Backup> newest = readBackup(copies.front());
    if (newest && newest->project == own->id && newest->history == history) return false;
  }
  const Result<fs::path> made = backUp();
  if (!made) return made.error();
  return true;
}

std::vector<fs::path> backupsOf(const fs::path& folder, std::int64_t now_ms) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "backups", code))
    if (entry.path().extension() == ".sqlite") files.push_back(entry.path());
  std::sort(files.rbegin(), files.rend());
  std::stable_partition(files.begin(), files.end(),
                        [&](const fs::path& file) { return !isOfLater(file, now_ms); });
  return files;
}

std::vector<Backup> copiesOf(const std::string& project, const std::vector<fs::path>& files) {
  std::vector<Backup> copies;
  for (const fs::path& file : files) {
    std::optional<Backup> copy = readBackup(file);
    if (copy && copy->project == project) copies.push_back(std::move(*copy));
  }
  std::ranges::stable_sort(copies, std::greater(), &Backup::history);
  return copies;
}

Result<std::string> projectIn(const fs::path& folder, const std::vector<fs::path>& backups) {
  struct Found {
    int files = 0;  // at most, in any of its backups
    std::string name;
  };
  std::map<std::string, Found> projects;
  for (const fs::path& file : backups)
    if (const std::optional<Backup> copy = readBackup(file)) {
      Found& project = projects[copy->project];
      project.files = std::max(project.files, filesIn(folder, file));
      project.name = file.filename().string();
    }
  std::vector<std::pair<std::string, Found>> most(projects.begin(), projects.end());
  std::ranges::stable_sort(
      most, [](const auto& a, const auto& b) { return a.second.files > b.second.files; });
  if (most.size() > 1 && most[0].second.files == most[1].second.files)
    return Error::unusable(
        message("The backups %1 and %2 are of different projects, and nothing tells which of them "
                "this folder is; nothing was changed. Move those of the other project away, then "
                "repair it again.",
                most[0].second.name, most[1].second.name),
        folder / "backups");
  return most.empty() ? std::string() : most.front().first;
}

std::vector<fs::path> Project::backups() const {
  return backupsOf(folder_, catalogue_.now());
}

}  // namespace ostraka::upkeep
