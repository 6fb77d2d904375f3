#include "upkeep/repair.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <map>
#include <utility>

#include "base/message.h"
#include "catalogue/settings.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "store/database.h"
#include "store/file_header.h"
#include "store/migrations.h"
#include "store/partial_file.h"
#include "store/schema_check.h"
#include "upkeep/backups.h"
#include "upkeep/file_check.h"
#include "upkeep/page_repair.h"
#include "upkeep/project.h"
#include "upkeep/row_repair.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

const char* const kWal = "-wal";
const std::string kDamaged = "catalogue-damaged-";  // and the time

std::int64_t systemTime() {
  return std::int64_t{std::chrono::duration_cast<std::chrono::milliseconds>(
                          std::chrono::system_clock::now().time_since_epoch())
                          .count()};
}

// All of SQLite's range, as long as this lives: nobody has the catalogue open, and whoever opens it
// waits. Of the open file, not of the process, so that copying the file does not drop it.
class ExclusiveLock {
 public:
  static Result<ExclusiveLock> take(const fs::path& file) {
    ExclusiveLock lock(::open(file.c_str(), O_RDWR | O_CLOEXEC));
    if (lock.fd_ < 0) return cannotWrite(file, errno);
    constexpr off_t kPendingByte = 0x40000000;
    struct flock range {};
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_start = kPendingByte;
    range.l_len = 512;
    const bool taken = ::fcntl(lock.fd_, F_OFD_SETLK, &range) == 0;
    if (!taken && errno != EAGAIN && errno != EACCES) return cannotWrite(file, errno);
    // Another repair may have replaced the file between the two.
    struct stat held {};
    struct stat named {};
    if (!taken || ::fstat(lock.fd_, &held) != 0 || ::stat(file.c_str(), &named) != 0 ||
        held.st_dev != named.st_dev || held.st_ino != named.st_ino)
      return Error{
          ErrorCode::Failed,
          message("Another program has this project open; close it there, then repair it."),
          file.parent_path().string()};
    return lock;
  }
  ~ExclusiveLock() {
    if (fd_ >= 0) ::close(fd_);
  }
  ExclusiveLock(ExclusiveLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  ExclusiveLock& operator=(ExclusiveLock&&) = delete;

 private:
  explicit ExclusiveLock(int fd) : fd_(fd) {}
  int fd_;
};

class Repair {
 public:
  Repair(fs::path project, Progress& progress, std::stop_token stop,
         catalogue::Catalogue::Clock clock)
      : project_(std::move(project)),
        file_(project_ / "catalogue.sqlite"),
        repaired_(store::repairedBeside(file_)),
        progress_(progress),
        stop_(std::move(stop)),
        clock_(std::move(clock)) {}

  Result<RepairReport> run() {
    if (fs::is_symlink(file_))  // its WAL lies beside what it leads to
      return Error::unusable(message("A link or a file has taken the place of a folder, or a link "
                                     "that of a file; replace it "
                                     "with the folder or the file itself."),
                             file_.string());
    std::error_code failed;
    const bool gone = !fs::exists(file_, failed);
    if (gone)  // one that is empty is made from the backups
      if (Result<void> made = writeFileAtomically(file_, {}); !made) return made.error();
    const Result<ExclusiveLock> alone = ExclusiveLock::take(file_);
    if (!alone) return alone.error();
    Result<RepairReport> done = repairAlone();
    if (!done && gone) fs::remove(file_, failed);
    return done;
  }

 private:
  Result<RepairReport> repairAlone() {
    std::error_code failed;
    const bool interrupted = fs::exists(fs::symlink_status(repaired_, failed));
    if (interrupted) {
      const Result<bool> ended = endInterrupted();
      if (!ended) return ended.error();
      if (*ended) return report_;
    }
    Result<store::PartialFile> fresh = store::PartialFile::beside(file_);
    if (!fresh) return fresh.error();
    Result<store::PartialFile> copy = store::PartialFile::beside(file_);
    if (!copy) return copy.error();
    const bool foreign_wal = store::hasWalOfAnother(file_);
    if (Result<void> copied = copyFile(file_, copy->path()); !copied) return copied.error();
    if (!foreign_wal && fs::exists(file_.string() + kWal))
      if (Result<void> copied = copyFile(file_.string() + kWal, copy->path().string() + kWal);
          !copied)
        return copied.error();
    progress_.report(0, 4);
    backups_ = backupsOf(project_, clock_());
    const Result<PageRepair> pages = repairPages(copy->path(), backups_);
    if (!pages) return pages.error();
    const Result<bool> version_known = checkVersion(copy->path(), store::Database::Mode::ReadOnly);
    if (!version_known) return version_known.error();
    if (interrupted)
      if (Result<void> aside = setAside(); !aside) return aside.error();
    report_.pages = pages->pages;
    report_.pages_by_bit = pages->by_bit;
    report_.pages_by_backup = pages->by_backup;
    report_.pages_lost = static_cast<int>(pages->lost.size()) + pages->wal_pages_lost;
    progress_.report(1, 4);
    if (stop_.stop_requested()) return Error::cancelled();
    bool provable = report_.pages_lost == 0;
    if (provable) {
      const Result<bool> whole = isWhole(copy->path());
      if (!whole) return whole.error();
      provable = *whole;
    }
    // A first page that stands whole in the WAL alone keeps SQLite from reading it.
    if (provable && pages->by_bit + pages->by_backup == 0 && !pages->wal_damaged &&
        store::checkHeader(file_))
      return report_;
    if (!provable)
      if (Result<void> made = makeFrom(copy->path(), *pages, *fresh); !made) return made.error();
    if (!*version_known)
      report_.warning = message(
          "The version of the damaged catalogue cannot be read, so this repair relies on the "
          "backup %1. If a newer Ostraka has changed this project since, put the damaged file "
          "back and repair it with that version.",
          base_.filename());
    if (pages->wal_pages_lost > 0 || foreign_wal)
      report_.rows.push_back(
          {file_.filename().string() + kWal, 0, {}, {}, RepairedRow::From::Nowhere});
    progress_.report(3, 4);
    if (stop_.stop_requested()) return Error::cancelled();
    if (Result<void> put = putInPlace(provable ? *copy : *fresh); !put) return put.error();
    return report_;
  }

  Result<catalogue::Catalogue> opened(const fs::path& file, store::Database::Mode mode) const {
    Result<std::unique_ptr<store::Database>> database = store::Database::open(file, mode);
    if (!database) return database.error();
    return catalogue::Catalogue(std::move(*database), clock_);
  }

  // A newer version is refused, as by opening: this program would take what it does not know for
  // damage. Its page must be whole; false where nothing tells the version.
  Result<bool> checkVersion(const fs::path& file, store::Database::Mode mode) const {
    const Result<catalogue::Catalogue> catalogue = opened(file, mode);
    if (!catalogue) return false;
    const Result<int> version =
        catalogue->database().asResult([&] { return catalogue->schemaVersion(); });
    if (!version || *version <= store::migrations().back().number) return version.has_value();
    Error newer = store::migrate(catalogue->database(), store::migrations(), {}).error();
    newer.where = file_.string();
    return newer;
  }

  // A disk that takes nothing says nothing of the file. What leads outside the project is no damage
  // that a backup could mend: it is refused, as it is by opening.
  Result<bool> isWhole(const fs::path& file) const {
    const Result<catalogue::Catalogue> catalogue = opened(file, store::Database::Mode::ReadWrite);
    const Result<void> intact = catalogue ? isIntact(*catalogue) : catalogue.error();
    if (!intact && intact.error().code == ErrorCode::CannotWrite) return intact.error();
    if (!intact) return false;
    if (const Result<void> inside = checkPaths(*catalogue); !inside) return inside.error();
    return true;
  }

  static Result<void> isIntact(const catalogue::Catalogue& catalogue) {
    if (Result<void> ours = store::checkSchema(catalogue.database()); !ours) return ours;
    return catalogue.checkIntegrity();
  }

  // Empty where the file says nothing, or is not ours.
  std::string projectOf(const fs::path& file) const {
    const Result<catalogue::Catalogue> catalogue = opened(file, store::Database::Mode::ReadOnly);
    if (!catalogue || !store::checkSchema(catalogue->database())) return {};
    const Result<records::ProjectRecord> project = catalogue::Settings(*catalogue).project();
    return project ? project->id : std::string();
  }

  // The first whole one is what rows are taken from.
  Result<void> findBase(const fs::path& damaged) {
    std::string project = projectOf(damaged);
    if (project.empty()) {
      Result<std::string> found = projectIn(project_, backups_);
      if (!found) return found.error();
      project = std::move(*found);
    }
    for (const Backup& backup : copiesOf(project, backups_)) {
      if (stop_.stop_requested()) return Error::cancelled();
      if (const Result<bool> known = checkVersion(backup.file, store::Database::Mode::ReadOnly);
          !known)
        return known.error();
      const Result<catalogue::Catalogue> catalogue =
          opened(backup.file, store::Database::Mode::ReadOnly);
      if (!catalogue || !catalogue->checkIntegrity() || !checkPaths(*catalogue)) continue;
      base_ = backup.file;
      break;
    }
    return {};
  }

  Result<void> makeFrom(const fs::path& damaged, const PageRepair& pages,
                        store::PartialFile& fresh) {
    if (Result<void> found = findBase(damaged); !found) return found;
    const Error needs_backup = {
        ErrorCode::Damaged,
        message("The catalogue is damaged, and none of its backups is intact; copy one from an "
                "archive or another disk into the folder backups, then repair it again."),
        file_.string()};
    // Where each page is whole, each row can be read.
    if (base_.empty() && report_.pages_lost > 0) return needs_backup;
    report_.backup = base_;
    Result<store::PartialFile> base = store::PartialFile::beside(file_);
    if (!base) return base.error();
    if (Result<void> ready = makeBase(base->path()); !ready) return ready;
    const Result<bool> rows = collect(damaged, pages, base->path(), fresh.path());
    if (!rows) return rows.error();
    if (!*rows && base_.empty()) return needs_backup;
    report_.all_from_backup = !*rows;
    if (!*rows) {
      report_.rows.clear();
      Result<catalogue::Catalogue> source = opened(base->path(), store::Database::Mode::ReadWrite);
      if (!source) return source.error();
      fs::resize_file(fresh.path(), 0);
      return source->database().asResult([&] { source->database().copyTo(fresh.path()); });
    }
    const Result<catalogue::Catalogue> made =
        opened(fresh.path(), store::Database::Mode::ReadWrite);
    if (!made) return made.error();
    if (Result<void> intact = isIntact(*made); !intact) return intact;
    return checkPaths(*made);
  }

  // The backup itself stays as it is: an older one is brought to this program's schema first.
  // Without any it is an empty catalogue.
  Result<void> makeBase(const fs::path& file) const {
    if (!base_.empty()) {
      const Result<catalogue::Catalogue> original = opened(base_, store::Database::Mode::ReadOnly);
      if (!original) return original.error();
      if (Result<void> copied =
              original->database().asResult([&] { original->database().copyTo(file); });
          !copied)
        return copied;
    }
    const Result<catalogue::Catalogue> catalogue = opened(
        file, base_.empty() ? store::Database::Mode::Create : store::Database::Mode::ReadWrite);
    if (!catalogue) return catalogue.error();
    return store::migrate(catalogue->database(), store::migrations(),
                          []() -> Result<void> { return {}; });
  }

  // False where the damaged file says nothing that fits together.
  Result<bool> collect(const fs::path& damaged, const PageRepair& pages, const fs::path& base,
                       const fs::path& fresh) {
    if (static_cast<int>(pages.lost.size()) >= pages.pages) return false;
    if (const Result<bool> schema = takeSchemaPages(damaged, pages, base); !schema || !*schema)
      return schema;
    const Result<catalogue::Catalogue> lost = opened(damaged, store::Database::Mode::ReadWrite);
    Result<catalogue::Catalogue> backup = opened(base, store::Database::Mode::ReadWrite);
    if (!lost || !backup || lost->schemaVersion() != backup->schemaVersion()) return false;
    // Rows are not read through a view or a check of others: they need never end.
    if (!store::checkSchema(lost->database())) return false;
    Result<std::unique_ptr<store::Database>> database =
        store::Database::open(fresh, store::Database::Mode::Create);
    if (!database) return database.error();
    if (const Result<void> made = store::migrate(**database, store::migrations(), {}); !made)
      return made.error();
    if (const Result<void> rows =
            collectRows(lost->database(), backup->database(), **database, report_);
        !rows)
      return notForTheDisk(rows.error());
    catalogue::Catalogue repaired(std::move(*database), clock_);
    const Result<std::int64_t> last = backup->database().asResult([&] {
      return backup->database().sql("SELECT max(number) FROM history").one<std::int64_t>();
    });
    if (!last) return false;
    if (const Result<void> replayed = replayHistory(repaired, *last, report_); !replayed)
      return notForTheDisk(replayed.error());
    nameRows(repaired.database());
    return true;
  }

  // Rows that do not fit together are taken from the backup; what finds no room is not.
  static Result<bool> notForTheDisk(const Error& error) {
    if (error.code == ErrorCode::CannotWrite) return error;
    return false;
  }

  void nameRows(store::Database& database) {
    const std::map<std::string, std::string> names = {
        {"sherd", "number"},    {"batch", "number"}, {"context", "number"}, {"bag", "number"},
        {"site", "code"},       {"trench", "code"},  {"file", "path"},      {"scan", "path"},
        {"photograph", "path"}, {"person", "name"}};
    for (RepairedRow& row : report_.rows) {
      const auto name = names.find(row.table);
      if (name == names.end() || row.row == 0 || !row.name.empty()) continue;
      store::Statement found =
          database.sql("SELECT " + name->second + " FROM " + row.table + " WHERE row = ?", row.row);
      found.read(row.name);
    }
  }

  // A copy lies among the backups first, and the damaged file with its WAL beside the project's.
  // Then the repaired file gets the name that the next opening and the next repair look for: killed
  // before that, nothing is changed; killed after it, the next repair ends this one.
  Result<void> putInPlace(store::PartialFile& made) {
    {
      const Result<catalogue::Catalogue> catalogue =
          opened(made.path(), store::Database::Mode::ReadWrite);
      if (!catalogue) return catalogue.error();
      const Result<fs::path> saved = backUpInto(project_, *catalogue, {});
      if (!saved) return saved.error();
    }
    report_.damaged = damagedCopy();
    const fs::path wal = file_.string() + kWal, damaged_wal = report_.damaged.string() + kWal;
    if (Result<void> copied = copyFile(file_, report_.damaged); !copied) return copied;
    const bool has_wal = fs::exists(wal);
    if (has_wal)
      if (Result<void> copied = copyFile(wal, damaged_wal); !copied) {
        std::error_code stays;
        fs::remove(report_.damaged, stays);  // without it the copy would look whole
        return copied;
      }
    if (Result<void> synced = syncFile(report_.damaged); !synced) return synced;
    if (has_wal)
      if (Result<void> synced = syncFile(damaged_wal); !synced) return synced;
    if (Result<void> ready = made.become(repaired_, store::PartialFile::Existing::Replaced); !ready)
      return ready;
    return replaceDamaged();
  }

  // The damaged file and its WAL were kept before the repaired one got this name. False where what
  // bears it is no whole catalogue, or where somebody has put another in the damaged one's place
  // since; then what lies there is repaired.
  Result<bool> endInterrupted() {
    if (fs::is_regular_file(fs::symlink_status(repaired_))) {
      // A reader would leave an empty WAL beside it.
      if (const Result<bool> known = checkVersion(repaired_, store::Database::Mode::ReadWrite);
          !known)
        return known.error();
      const Result<bool> whole = isWhole(repaired_);
      if (!whole && whole.error().code != ErrorCode::UnusableInput) return whole;
      if (const fs::path kept = keptCopy(); whole && *whole && !kept.empty()) {
        report_.damaged = kept;
        report_.interrupted = true;
        if (Result<void> replaced = replaceDamaged(); !replaced) return replaced.error();
        return true;
      }
    }
    return false;
  }

  // What no repair can be ended with is kept as damaged, too.
  Result<void> setAside() const {
    std::error_code failed;
    fs::rename(repaired_, damagedCopy(), failed);
    return failed ? Result<void>(cannotWrite(repaired_, failed.value())) : Result<void>();
  }

  // Its WAL must not be left to the new file, not even by a power cut between the two.
  Result<void> replaceDamaged() {
    std::error_code failed;
    fs::remove(file_.string() + kWal, failed);
    if (failed) return cannotWrite(file_, failed.value());
    syncFolder(project_);
    for (const fs::path& of : {file_, repaired_}) fs::remove(of.string() + "-shm", failed);
    fs::rename(repaired_, file_, failed);
    if (failed) return cannotWrite(file_, failed.value());
    syncFolder(project_);
    return {};
  }

  // The copy of what lies there, byte for byte, and of its WAL where that was not removed yet;
  // empty where there is none.
  fs::path keptCopy() const {
    const auto sum = [](const fs::path& file) -> std::string {
      Result<OpenFile> open = OpenFile::open(file);
      if (!open) return {};
      const Result<Checksum> found = checksumOf(*open, {});
      return found ? found->sha256 : std::string();
    };
    const bool has_wal = fs::exists(file_.string() + kWal);
    const std::string here = sum(file_), wal = sum(file_.string() + kWal);
    if (here.empty() || (has_wal && wal.empty())) return {};
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(project_, ignored))
      if (isDamagedCopy(entry.path()) && sum(entry.path()) == here &&
          (!has_wal || sum(entry.path().string() + kWal) == wal))
        return entry.path();
    return {};
  }

  fs::path damagedCopy() const { return project_ / (kDamaged + timeStamp(clock_()) + ".sqlite"); }
  static bool isDamagedCopy(const fs::path& file) {
    return file.filename().string().starts_with(kDamaged) && file.extension() == ".sqlite";
  }

  fs::path project_, file_, repaired_;
  Progress& progress_;
  std::stop_token stop_;
  catalogue::Catalogue::Clock clock_;
  std::vector<fs::path> backups_;
  fs::path base_;
  RepairReport report_;
};

}  // namespace

Message RepairedRow::words(const std::string& backup) const {
  std::string what = table;
  if (row > 0) what += " " + std::to_string(row);
  if (!name.empty()) what += " (" + name + ")";
  if (!field.empty()) what += ", " + field;
  return !owner.empty()          ? message("%1: not restored; it belongs to %2", what, owner)
         : from == From::Backup  ? message("%1: from %2", what, backup)
         : from == From::History ? message("%1: from the history", what)
                                 : message("%1: not restored", what);
}

Result<RepairReport> repairCatalogue(const fs::path& project, Progress& progress,
                                     std::stop_token stop,
                                     const catalogue::Catalogue::Clock& clock) {
  const catalogue::Catalogue::Clock now = clock ? clock : systemTime;
  if (Result<void> outside = checkOutsideArchives(project); !outside) return outside.error();
  // A catalogue that is gone is as one that is damaged all over.
  std::error_code code;
  const bool gone =
      fs::symlink_status(project / "catalogue.sqlite", code).type() == fs::file_type::not_found;
  if (!Project::isProject(project) && !(gone && !backupsOf(project, now()).empty()))
    return Error::unusable(message("Not an Ostraka project: this folder has no catalogue.sqlite."),
                           project.string());
  store::PartialFile::removeLeftovers(project);
  return Repair(fs::absolute(project), progress, std::move(stop), now).run();
}

}  // namespace ostraka::upkeep
