#pragma once
#include <filesystem>

#include "base/result.h"

namespace ostraka::app {

/// Whether an import may write what it refused there: a new file in a folder that is there, or in
/// the place of an earlier table of refusals; never in a project or a sealed folder. Nothing is
/// written. An empty path is none. Error: UnusableInput.
Result<void> checkRefusalsFile(const std::filesystem::path& file);

}  // namespace ostraka::app
