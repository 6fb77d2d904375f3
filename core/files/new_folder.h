#pragma once
#include <filesystem>

#include "base/result.h"
#include "files/folder_lock.h"

namespace ostraka {

/// A folder that is created completely or not at all: it is filled beside its place, in
/// PLACE.partial/content, and renamed once it is complete. What a killed run left is removed by the
/// next one for the same place; what goes out of scope unfinished is removed immediately.
class NewFolder {
 public:
  /// place: absent, or an empty folder. Errors: UnusableInput (files in it or in PLACE.partial, or
  /// a folder that no other can replace), CannotWrite (another run at work there, disk full ...).
  static Result<NewFolder> begin(const std::filesystem::path& place);
  ~NewFolder();
  NewFolder(NewFolder&& other) noexcept;
  NewFolder& operator=(NewFolder&&) = delete;

  std::filesystem::path path() const { return partial_ / "content"; }  ///< to be filled
  /// Moves the folder to its place. Error: CannotWrite; everything is then removed.
  Result<void> finish();

 private:
  NewFolder(std::filesystem::path place, std::filesystem::path partial, FolderLock lock)
      : place_(std::move(place)), partial_(std::move(partial)), lock_(std::move(lock)) {}
  std::filesystem::path place_, partial_;  ///< empty once moved from
  FolderLock lock_;
};

}  // namespace ostraka
