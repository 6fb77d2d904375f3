#include "store/partial_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "files/files.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

const std::string kEnd = ".partial";

// Of the database and of SQLite's files beside it: X.partial-wal belongs to X.partial.
fs::path databaseOf(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::size_t end = name.rfind(kEnd);
  return end == std::string::npos ? fs::path()
                                  : file.parent_path() / name.substr(0, end + kEnd.size());
}

}  // namespace

Result<PartialFile> PartialFile::beside(const fs::path& file) {
  const fs::path folder = fs::absolute(file).parent_path();
  // Between making it and holding it nobody may take it for a leftover.
  const std::optional<Hold> alone = Hold::wait(folder, std::chrono::seconds(10));
  for (int n = 0;; ++n) {
    const fs::path path =
        file.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(n) + kEnd;
    const int made =
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (made < 0 && errno == EEXIST) continue;
    if (made < 0) return cannotWrite(file, errno);
    ::close(made);
    if (std::optional<Hold> hold = Hold::take(path)) return PartialFile(path, std::move(*hold));
    return cannotWrite(file, errno);
  }
}

PartialFile::PartialFile(PartialFile&& other) noexcept
    : path_(std::exchange(other.path_, {})), hold_(std::move(other.hold_)) {}

PartialFile::~PartialFile() {
  if (path_.empty()) return;
  std::error_code ignored;
  for (const char* part : {"", "-wal", "-shm", "-journal"})
    fs::remove(path_.string() + part, ignored);
}

Result<void> PartialFile::become(const fs::path& file, Existing existing) {
  // SQLite keeps to itself that it could not bring all into the file when it closed it.
  std::error_code none;
  for (const char* part : {"-wal", "-journal"})
    if (const auto bytes = fs::file_size(path_.string() + part, none); !none && bytes > 0)
      return cannotWrite(path_, ENOSPC);
  if (Result<void> synced = syncFile(path_); !synced) return synced;
  int failed = -1;
  if (existing == Existing::Refused) {
    failed = ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, file.c_str(), RENAME_NOREPLACE);
    std::error_code ignored;
    // File systems that cannot refuse by themselves.
    if (failed != 0 && errno == EINVAL && !fs::exists(file, ignored))
      failed = ::rename(path_.c_str(), file.c_str());
  } else {
    failed = ::rename(path_.c_str(), file.c_str());
  }
  if (failed != 0) return cannotWrite(file, errno);
  path_.clear();
  syncFolder(fs::absolute(file).parent_path());
  return {};
}

bool PartialFile::isLeftover(const fs::path& file) {
  const fs::path database = databaseOf(file);
  if (database.empty() || database.filename().string().find(".sqlite.") == std::string::npos)
    return false;
  std::error_code ignored;
  return !fs::exists(database, ignored) || Hold::take(database).has_value();
}

void PartialFile::removeLeftovers(const fs::path& folder) {
  const std::optional<Hold> alone = Hold::take(folder);
  if (!alone) return;  // another one is at it
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored) && isLeftover(entry.path()))
      fs::remove(entry.path(), ignored);
  }
}

}  // namespace ostraka::store
