#include "catalogue/project.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <set>

#include "catalogue/database.h"
#include "catalogue/migrations.h"
#include "catalogue/names.h"
#include "catalogue/network_share.h"
#include "catalogue/numbering.h"
#include "catalogue/values.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "catalogue.sqlite";
const std::string kBackup = "catalogue-";  // and the time: 20261121-181557-123
const std::size_t kDayLetters = kBackup.size() + 8;

Catalogue::Clock orSystemClock(const Catalogue::Clock& clock) {
  if (clock) return clock;
  return [] {
    return std::int64_t{std::chrono::duration_cast<std::chrono::milliseconds>(
                            std::chrono::system_clock::now().time_since_epoch())
                            .count()};
  };
}

Error refused(std::string what, const fs::path& where) {
  return {ErrorCode::UnusableInput, std::move(what), where.string()};
}

Result<void> checkFolder(const fs::path& folder) {
  if (const std::string share = networkShareOf(fs::absolute(folder)); !share.empty())
    return refused("The folder lies on a network share (" + share +
                       "), where catalogues get damaged; use a folder on this computer's own disk "
                       "and copy backups to the share.",
                   folder);
  return {};
}

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

Result<fs::path> backUpTo(const fs::path& folder, const Catalogue& catalogue,
                          const std::string& kind) {
  std::error_code code;
  fs::create_directories(folder / "backups", code);
  fs::path file = folder / "backups" / (kBackup + timeStamp(catalogue.now()) + kind + ".sqlite");
  for (int more = 2; fs::exists(file, code); ++more)
    file = folder / "backups" /
           (kBackup + timeStamp(catalogue.now()) + kind + "-" + std::to_string(more) + ".sqlite");
  if (const Result<void> made = catalogue.backup(file); !made) return made.error();
  return file;
}

Result<Catalogue> openCatalogue(const fs::path& folder, const Catalogue::Clock& clock) {
  const fs::path file = folder / kFile;
  std::error_code code;
  if (!fs::is_regular_file(file, code))
    return refused("This folder is no Ostraka project: it holds no catalogue.sqlite.", folder);
  Result<std::unique_ptr<Database>> database = Database::open(file, Database::Mode::ReadWrite);
  if (!database) return database.error();
  Database& handle = **database;
  Catalogue catalogue(std::move(*database), orSystemClock(clock));
  const Result<void> current = migrate(handle, migrations(), [&]() -> Result<void> {
    const Result<fs::path> saved = backUpTo(folder, catalogue, "-before-update");
    return saved ? Result<void>() : saved.error();
  });
  if (!current) return current.error();
  return catalogue;
}

}  // namespace

Result<Project> Project::create(const fs::path& folder, const ProjectRecord& record,
                                const Catalogue::Clock& clock) {
  std::error_code code;
  if (fs::exists(folder, code) && (!fs::is_directory(folder, code) || !fs::is_empty(folder, code)))
    return refused("A new project needs a new or an empty folder; choose another name.", folder);
  if (const Result<void> good = checkFolder(folder); !good) return good.error();
  const bool made = fs::create_directories(folder, code);
  const auto undone = [&](const Error& error) {
    std::error_code ignored;
    for (const char* name : {"catalogue.sqlite", "catalogue.sqlite-wal", "catalogue.sqlite-shm"})
      fs::remove(folder / name, ignored);
    for (const char* name : {"batches", "results", "backups"}) fs::remove(folder / name, ignored);
    if (made) fs::remove(folder, ignored);
    return error;
  };
  for (const char* name : {"batches", "results", "backups"}) {
    fs::create_directories(folder / name, code);
    if (code)
      return undone({ErrorCode::CannotWrite,
                     "The folder cannot be made; choose a place that you may write to.",
                     folder.string()});
  }
  Result<std::unique_ptr<Database>> database =
      Database::open(folder / kFile, Database::Mode::Create);
  if (!database) return undone(database.error());
  const Result<void> ready = migrate(**database, migrations(), []() -> Result<void> { return {}; });
  if (!ready) return undone(ready.error());
  Catalogue catalogue(std::move(*database), orSystemClock(clock));
  if (const Result<void> set = catalogue.setProject(record, {{}, "new project", {}}); !set) {
    // The connection must be gone before its files are.
    { const Catalogue closing = std::move(catalogue); }
    return undone(set.error());
  }
  return Project(fs::absolute(folder), std::move(catalogue));
}

Result<Project> Project::open(const fs::path& folder, const Catalogue::Clock& clock) {
  if (const Result<void> good = checkFolder(folder); !good) return good.error();
  Result<Catalogue> catalogue = openCatalogue(folder, clock);
  if (!catalogue) return catalogue.error();
  return Project(fs::absolute(folder), std::move(*catalogue));
}

bool Project::isProject(const fs::path& folder) {
  std::error_code code;
  return fs::is_regular_file(folder / kFile, code);
}

Result<Catalogue> Project::connect() const {
  return connect(folder_);
}

Result<Catalogue> Project::connect(const fs::path& folder) {
  return openCatalogue(folder, {});
}

fs::path Project::batchFolder(const std::string& number) const {
  return folder_ / "batches" / number;
}
fs::path Project::resultsFolder(const std::string& number) const {
  return folder_ / "results" / number;
}
fs::path Project::absolute(const std::string& relative) const {
  return folder_ / relative;
}

Result<std::string> Project::relative(const fs::path& absolute) const {
  const Result<std::string> path = checkedPath(
      fs::absolute(absolute).lexically_normal().lexically_relative(folder_).generic_string());
  if (!path) return refused("This file does not lie in the project's folder.", absolute);
  return path;
}

Result<fs::path> Project::backUp(int keep, int days) const {
  Result<fs::path> file = backUpTo(folder_, catalogue_, {});
  if (!file) return file;
  // Copies made before an update are for life; only the others make room.
  int seen = 0;
  std::set<std::string> seen_days;
  std::error_code ignored;
  for (const fs::path& old : backups()) {
    const std::string name = old.filename().string();
    if (name.find("-before-") != std::string::npos) continue;
    const bool last_of_its_day = seen_days.insert(name.substr(0, kDayLetters)).second;
    const bool kept_for_its_day = last_of_its_day && static_cast<int>(seen_days.size()) <= days;
    if (++seen > keep && !kept_for_its_day) fs::remove(old, ignored);
  }
  return file;
}

Result<bool> Project::backUpIfChanged(std::chrono::milliseconds after) const {
  const Result<std::int64_t> changed = catalogue_.database().door([&] {
    std::int64_t at = 0;
    Statement last =
        catalogue_.database().sql("SELECT at FROM history ORDER BY number DESC LIMIT 1");
    if (last.next()) last >> at;
    return at;
  });
  if (!changed) return changed.error();
  // The names sort as their times do.
  const auto nameAt = [](std::int64_t ms) { return kBackup + timeStamp(ms); };
  std::string newest;
  for (const fs::path& copy : backups()) newest = std::max(newest, copy.filename().string());
  if (*changed == 0 || nameAt(*changed) < newest) return false;
  if (nameAt(catalogue_.now() - after.count()) < newest) return false;
  const Result<fs::path> made = backUp();
  if (!made) return made.error();
  return true;
}

std::vector<fs::path> Project::backups() const {
  std::vector<fs::path> files;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "backups", code))
    if (entry.path().extension() == ".sqlite") files.push_back(entry.path());
  std::sort(files.rbegin(), files.rend());
  return files;
}

}  // namespace ostraka::catalogue
