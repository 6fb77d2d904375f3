#pragma once
#include <filesystem>

#include "base/result.h"

namespace ostraka {

/// The error of what could not be written there, in words; reason is an errno: a full disk, or
/// another one. Error: CannotWrite.
Error cannotWrite(const std::filesystem::path& path, int reason);

/// Makes the folder and those on the way to it. Error: CannotWrite.
Result<void> makeFolder(const std::filesystem::path& folder);

}  // namespace ostraka
