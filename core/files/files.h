#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka {

/// The whole file; refuses files larger than max_bytes before allocating.
Result<std::string> readFile(const std::filesystem::path& path,
                             std::size_t max_bytes = std::size_t{4} << 30);

/// Writes beside the final name, syncs, renames, syncs the folder: after a crash or a full disk,
/// either the old or the new file is there, complete. Creates missing folders.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a file into another, which is empty or is made with the same permissions. Errors:
/// UnusableInput (from), CannotWrite; then `to` is gone, unless it held something before.
Result<void> copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes sure that what was created or renamed in the folder survives a power failure, if the disk
/// can guarantee that.
void syncFolder(const std::filesystem::path& folder);

/// The same for what was written to the file.
Result<void> syncFile(const std::filesystem::path& file);

/// Whether this process may write there: permissions and read-only file systems.
bool mayBeWritten(const std::filesystem::path& path);

/// SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// Whether errno says that no more can be written: a full disk, a quota, or a limit of file sizes.
bool isFullDisk(int reason);
/// The error CannotWrite for a path that could not be written; reason: errno.
Error cannotWrite(const std::filesystem::path& path, int reason);

/// Creates the folder and its missing parents. Error: CannotWrite.
Result<void> makeFolder(const std::filesystem::path& folder);

}  // namespace ostraka
