#include "files/open_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include "base/message.h"
#include "files/files.h"
#include "files/unfinished_file.h"

namespace ostraka {
namespace {

constexpr int kMostNested = 64;
constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

Error cannotOpen(int reason, std::string where) {
  if (reason == ENOENT)
    return Error::unusable(message("There is no such file; check its name."), std::move(where));
  if (reason == ELOOP || reason == ENOTDIR)  // the latter is what O_DIRECTORY says of a link
    return Error::unusable(message("A link or a file has taken the place of a folder, or a link "
                                   "that of a file; replace it "
                                   "with the folder or the file itself."),
                           std::move(where));
  return Error::unusable(message("The file cannot be opened (%1); check its permissions.",
                                 std::string(std::strerror(reason))),
                         std::move(where));
}

Error cannotMake(int reason, std::string where) {
  if (reason == ELOOP || reason == ENOTDIR) return cannotOpen(reason, std::move(where));
  if (reason == EEXIST)
    return Error::unusable(
        message(
            "A file with this name already exists and is not overwritten; choose another name."),
        std::move(where));
  return cannotWrite(where, reason);
}

// In an open folder. Drivers of file systems answer a name that they do not know in several ways:
// ENOENT, where the folder is still there, is exfat-fuse's.
Error cannotCreate(int folder, int reason, std::string where) {
  struct stat info {};
  const bool there = ::fstat(folder, &info) == 0 && info.st_nlink > 0;
  if (there && (reason == EINVAL || reason == EILSEQ || reason == ENAMETOOLONG || reason == ENOENT))
    return Error::unusable(message("This disk does not accept this name; rename the file, or use a "
                                   "folder on another disk."),
                           std::move(where));
  return cannotMake(reason, std::move(where));
}

Message kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return message("This is a folder, not a file; choose a file.");
  if (S_ISFIFO(mode)) return message("This is a pipe, not a file; choose a file.");
  if (S_ISSOCK(mode)) return message("This is a socket, not a file; choose a file.");
  if (S_ISCHR(mode) || S_ISBLK(mode))
    return message("This is a device, not a file; choose a file.");
  return {};
}

// 0, or why a folder could not be read.
int listBelow(FileDescriptor folder, const std::string& at, int depth,
              std::vector<OpenFolder::Entry>& found) {
  if (depth > kMostNested) return ENAMETOOLONG;
  const int own = ::fcntl(folder.get(), F_DUPFD_CLOEXEC, 0);  // closedir closes it
  const std::unique_ptr<DIR, int (*)(DIR*)> open(own < 0 ? nullptr : ::fdopendir(own), ::closedir);
  if (open == nullptr) return errno;
  errno = 0;
  while (const dirent* entry = ::readdir(open.get())) {
    const std::string name = entry->d_name;
    if (name == "." || name == "..") continue;
    struct stat info {};
    if (::fstatat(folder.get(), name.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0) return errno;
    if (S_ISDIR(info.st_mode)) {
      FileDescriptor below(::openat(folder.get(), name.c_str(), kFolder));
      if (!below.isOpen()) return errno;
      if (const int failed = listBelow(std::move(below), at + name + "/", depth + 1, found))
        return failed;
    } else {
      found.push_back({at + name, S_ISREG(info.st_mode)});
    }
    errno = 0;
  }
  return errno;
}

}  // namespace

Message otherThanAFile(const std::filesystem::path& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? kindOf(info.st_mode) : Message();
}

Result<OpenFile> OpenFile::open(const std::filesystem::path& path) {
  // Before it is opened: opening a device may do something to it.
  if (Message other = otherThanAFile(path); !other.empty())
    return Error::unusable(std::move(other), path);
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file.isOpen()) return cannotOpen(errno, path.string());
  return of(std::move(file), path.string());
}

Result<OpenFile> OpenFile::within(const std::filesystem::path& folder, std::string_view path) {
  const Result<ContainedPath> contained = ContainedPath::parse(path);
  if (!contained) return contained.error();
  const Result<OpenFolder> opened = OpenFolder::open(folder);
  return opened ? opened->read(*contained) : Result<OpenFile>(opened.error());
}

Result<OpenFile> OpenFile::of(FileDescriptor file, std::string name) {
  struct stat info {};
  if (::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode))
    return Error::unusable(kindOf(info.st_mode), std::move(name));
  return OpenFile(std::move(file), std::move(name), info.st_size);
}

Result<std::size_t> OpenFile::read(std::span<char> piece) {
  std::size_t done = 0;
  while (done < piece.size()) {
    const ssize_t n = ::read(file_.get(), piece.data() + done, piece.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      return Error::unusable(message("The file cannot be read (%1); copy it again.",
                                     std::string(std::strerror(errno))),
                             name_);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

Result<std::string> OpenFile::readAll(std::size_t max_bytes) {
  if (static_cast<std::size_t>(bytes_) > max_bytes)
    return Error::unusable(
        message("The file is larger than the limit of %1 bytes; check that it is the right one.",
                max_bytes),
        name_);
  std::string bytes(static_cast<std::size_t>(bytes_), '\0');
  const Result<std::size_t> done = read(bytes);
  if (!done) return done.error();
  bytes.resize(*done);
  return bytes;
}

NewFile::~NewFile() {
  if (file_.isOpen()) ::unlinkat(folder_.get(), partial_.c_str(), 0);
}

Error NewFile::cannotWrite(int reason) const {
  return cannotMake(reason, where_);
}

Result<void> NewFile::write(std::string_view bytes) {
  return writeAll(file_.get(), bytes) ? Result<void>() : cannotWrite(errno);
}

Result<void> NewFile::finish() {
  if (::fsync(file_.get()) != 0) return cannotWrite(errno);
  int failed = ::renameat2(folder_.get(), partial_.c_str(), folder_.get(), name_.c_str(),
                           RENAME_NOREPLACE) == 0
                   ? 0
                   : errno;
  if (failed == EINVAL || failed == ENOSYS) {  // a file system that does not know the flag
    struct stat there {};
    const bool is_there = ::fstatat(folder_.get(), name_.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0;
    failed = is_there ? EEXIST : 0;
    if (!is_there && ::renameat(folder_.get(), partial_.c_str(), folder_.get(), name_.c_str()) != 0)
      failed = errno;
  }
  if (failed != 0) return cannotCreate(folder_.get(), failed, where_);
  file_ = FileDescriptor();
  ::fsync(folder_.get());
  return {};
}

Result<OpenFolder> OpenFolder::open(const std::filesystem::path& folder) {
  FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened.isOpen()) return cannotOpen(errno, folder.string());
  return OpenFolder(std::move(opened), folder);
}

Result<FileDescriptor> OpenFolder::folderOf(const ContainedPath& path, std::size_t parts,
                                            Missing missing) const {
  FileDescriptor folder(::fcntl(folder_.get(), F_DUPFD_CLOEXEC, 0));
  if (!folder.isOpen()) return cannotOpen(errno, named(path));
  for (std::size_t i = 0; i < parts; ++i) {
    const char* part = path.parts()[i].c_str();
    if (missing == Missing::Made && ::mkdirat(folder.get(), part, 0777) != 0 && errno != EEXIST)
      return cannotCreate(folder.get(), errno, named(path));
    FileDescriptor below(::openat(folder.get(), part, kFolder));
    if (!below.isOpen()) return cannotOpen(errno, named(path));
    folder = std::move(below);
  }
  return folder;
}

Result<OpenFile> OpenFolder::read(const ContainedPath& path) const {
  const Result<FileDescriptor> folder = folderOf(path, path.parts().size() - 1, Missing::Refused);
  if (!folder) return folder.error();
  FileDescriptor file(::openat(folder->get(), path.parts().back().c_str(),
                               O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file.isOpen()) return cannotOpen(errno, named(path));
  return OpenFile::of(std::move(file), named(path));
}

bool OpenFolder::has(const ContainedPath& path) const {
  const auto folder = folderOf(path, path.parts().size() - 1, Missing::Refused);
  struct stat there {};
  return folder &&
         ::fstatat(folder->get(), path.parts().back().c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0;
}

Result<NewFile> OpenFolder::create(const ContainedPath& path) const {
  Result<FileDescriptor> folder = folderOf(path, path.parts().size() - 1, Missing::Made);
  if (!folder) return folder.error();
  struct stat there {};
  if (::fstatat(folder->get(), path.parts().back().c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0)
    return cannotMake(EEXIST, named(path));
  UnfinishedFile begun = beginFile(folder->get(), path.parts().back(), 0644);
  if (!begun.file.isOpen()) return cannotCreate(folder->get(), errno, named(path));
  return NewFile(std::move(*folder), std::move(begun.file), std::move(begun.name),
                 path.parts().back(), named(path));
}

Result<void> OpenFolder::move(const ContainedPath& from, const ContainedPath& to) const {
  const auto source = folderOf(from, from.parts().size() - 1, Missing::Refused),
             target = folderOf(to, to.parts().size() - 1, Missing::Made);
  if (!source) return source.error();
  if (!target) return target.error();
  if (::renameat(source->get(), from.parts().back().c_str(), target->get(),
                 to.parts().back().c_str()) != 0)
    return cannotWrite(named(to), errno);
  ::fsync(target->get());
  return {};
}

Result<std::vector<OpenFolder::Entry>> OpenFolder::filesBelow(const ContainedPath& path) const {
  Result<FileDescriptor> folder = folderOf(path, path.parts().size(), Missing::Refused);
  if (!folder) return folder.error();
  std::vector<Entry> found;
  if (const int failed = listBelow(std::move(*folder), path.text() + "/", 1, found))
    return cannotOpen(failed, named(path));
  std::ranges::sort(found, {}, &Entry::path);
  return found;
}

}  // namespace ostraka
