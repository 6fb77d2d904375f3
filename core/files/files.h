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

/// Writes beside the final name, syncs, renames, syncs the folder: after a crash or a full disk
/// the old file or the new one is there, whole. Folders on the way are created.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// What was made or renamed in the folder outlives a power failure, where the disk can promise
/// that.
void syncFolder(const std::filesystem::path& folder);

/// What was written to the file outlives a power failure, likewise.
Result<void> syncFile(const std::filesystem::path& file);

/// Whether this process may write there: permissions, and file systems that can only be read.
bool mayBeWritten(const std::filesystem::path& path);

/// SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// The error of what could not be written there, in words; reason is an errno: a full disk, or
/// another one. Error: CannotWrite.
Error cannotWrite(const std::filesystem::path& path, int reason);

/// Makes the folder and those on the way to it. Error: CannotWrite.
Result<void> makeFolder(const std::filesystem::path& folder);

}  // namespace ostraka
