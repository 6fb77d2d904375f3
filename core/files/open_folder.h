#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "files/contained_path.h"
#include "files/file_descriptor.h"

namespace ostraka {

/// What stands in the place of a regular file, in a sentence; empty for a regular file and for
/// nothing. A link counts as what it leads to.
Message otherThanAFile(const std::filesystem::path& path);

/// A regular file, opened once: everything read comes from one file, even if another takes its name
/// in the meantime.
class OpenFile {
 public:
  /// Links on the way are followed: for names that come from a person. A folder, pipe, device or
  /// socket is refused by its kind, without waiting for a writer. Error: UnusableInput.
  static Result<OpenFile> open(const std::filesystem::path& path);
  /// For names that come from a catalogue or another file: ContainedPath and OpenFolder in one.
  static Result<OpenFile> within(const std::filesystem::path& folder, std::string_view path);
  /// The next bytes; 0 at the end.
  Result<std::size_t> read(std::span<char> piece);
  /// All of them; refuses files larger than max_bytes before allocating.
  Result<std::string> readAll(std::size_t max_bytes = std::size_t{4} << 30);
  std::int64_t bytes() const { return bytes_; }  ///< when it was opened
  const std::string& name() const { return name_; }

 private:
  friend class OpenFolder;
  static Result<OpenFile> of(FileDescriptor file, std::string name);
  OpenFile(FileDescriptor file, std::string name, std::int64_t bytes)
      : file_(std::move(file)), name_(std::move(name)), bytes_(bytes) {}
  FileDescriptor file_;
  std::string name_;  ///< for errors
  std::int64_t bytes_;
};

/// A file that is written beside its place, under a temporary name; without finish() nothing
/// remains.
class NewFile {
 public:
  NewFile(NewFile&&) noexcept = default;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();
  Result<void> write(std::string_view bytes);
  /// Syncs it and gives it its name. Errors: a file of that name is there, the disk has no such
  /// names.
  Result<void> finish();

 private:
  friend class OpenFolder;
  NewFile(FileDescriptor folder, FileDescriptor file, std::string partial, std::string name,
          std::string where)
      : folder_(std::move(folder)),
        file_(std::move(file)),
        partial_(std::move(partial)),
        name_(std::move(name)),
        where_(std::move(where)) {}
  Error cannotWrite(int reason) const;
  FileDescriptor folder_, file_;
  std::string partial_, name_, where_;
};

/// A folder, opened once. Everything below it is reached part by part without following links, so
/// that no path leads out of it, whatever happens to the folder in the meantime.
class OpenFolder {
 public:
  /// The folder itself may be reached through links: a person named it.
  static Result<OpenFolder> open(const std::filesystem::path& folder);
  /// Error: UnusableInput for a missing file, a link on the way, or anything but a regular file.
  Result<OpenFile> read(const ContainedPath& path) const;
  /// Creates missing folders. Errors: UnusableInput for a link on the way, an existing file, or a
  /// name that the disk does not accept; CannotWrite.
  Result<NewFile> create(const ContainedPath& path) const;
  /// Moves a file to another place below this folder, where it replaces a file. Creates missing
  /// folders. Errors: UnusableInput for a link on the way, CannotWrite.
  Result<void> move(const ContainedPath& from, const ContainedPath& to) const;
  /// Whether anything has this name.
  bool has(const ContainedPath& path) const;
  struct Entry {
    std::string path;
    bool is_regular;  ///< else a link, a pipe, a device
  };
  /// Everything but folders below a folder of this one, sorted by name. Errors: it is not a folder,
  /// cannot be read, or is nested deeper than 64.
  Result<std::vector<Entry>> filesBelow(const ContainedPath& path) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  enum class Missing { Refused, Made };
  OpenFolder(FileDescriptor folder, std::filesystem::path path)
      : folder_(std::move(folder)), path_(std::move(path)) {}
  Result<FileDescriptor> folderOf(const ContainedPath& path, std::size_t parts,
                                  Missing missing) const;
  std::string named(const ContainedPath& path) const { return (path_ / path.text()).string(); }
  FileDescriptor folder_;
  std::filesystem::path path_;
};

}  // namespace ostraka
