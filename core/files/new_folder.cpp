#include "files/new_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <system_error>

#include "base/message.h"
#include "files/files.h"
#include "files/output_place.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

bool holdsFiles(const fs::path& folder) {
  std::error_code failed;
  return fs::exists(folder, failed) &&
         (!fs::is_directory(folder, failed) ||
          fs::directory_iterator(folder, failed) != fs::end(fs::directory_iterator()));
}

// A disk of its own, or the folder in which the person stands.
bool cannotBeReplaced(const fs::path& place) {
  struct stat own {
  }, above{};
  if (::stat(place.c_str(), &own) != 0) return false;
  if (::stat(place.parent_path().c_str(), &above) != 0 || own.st_dev != above.st_dev) return true;
  std::error_code failed;
  return fs::equivalent(place, fs::current_path(failed), failed);
}

// A link leads to somebody's folder, whatever that holds.
bool isLeftover(const fs::path& partial) {
  std::error_code failed;
  if (!fs::is_directory(fs::symlink_status(partial, failed))) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(partial, failed))
    if (entry.path().filename() != kLockFile && entry.path().filename() != "content") return false;
  return !failed;
}

}  // namespace

Result<NewFolder> NewFolder::begin(const fs::path& where) {
  if (const Result<void> good = checkOutputPlace(where); !good) return good.error();
  std::error_code failed;
  fs::path place = fs::absolute(where, failed).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  if (holdsFiles(place))
    return Error::unusable(message("The folder already contains files; choose a new or empty one."),
                           where.string());
  if (cannotBeReplaced(place))
    return Error::unusable(
        message(
            "This folder is a mount point or the current folder; choose a new folder inside it."),
        where.string());
  const fs::path partial = place.string() + ".partial";
  if (fs::exists(fs::symlink_status(partial, failed)) && !isLeftover(partial))
    return Error::unusable(
        message(
            "This folder is needed for unfinished files but contains others; move it elsewhere."),
        partial.string());
  if (const Result<void> made = makeFolder(partial); !made) return made.error();
  Result<FolderLock> lock = FolderLock::take(partial);
  if (!lock) return lock.error();
  NewFolder folder(place, partial, std::move(*lock));
  fs::remove_all(folder.path(), failed);
  if (const Result<void> made = makeFolder(folder.path()); !made) return made.error();
  return folder;
}

NewFolder::NewFolder(NewFolder&& other) noexcept
    : place_(std::move(other.place_)),
      partial_(std::move(other.partial_)),
      lock_(std::move(other.lock_)) {
  other.partial_.clear();
}

NewFolder::~NewFolder() {
  if (partial_.empty()) return;
  std::error_code ignored;
  fs::remove_all(path(), ignored);
  lock_.endWithoutTrace();  // some disks keep an open file in its folder under another name
  fs::remove(partial_, ignored);
}

Result<void> NewFolder::finish() {
  syncFolder(path());
  std::error_code failed;
  fs::rename(path(), place_, failed);
  if (failed) return cannotWrite(place_, failed.value());
  syncFolder(place_.parent_path());
  return {};
}

}  // namespace ostraka
