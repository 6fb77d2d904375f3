#pragma once
#include <array>
#include <filesystem>

#include "base/result.h"
#include "rig/sheet_bend.h"

namespace ostraka::calibration {

/// {"unit":"mm","front":{"reach","coefficients":[12]},"back":{...}}; bends: by side.
/// Error: CannotWrite.
Result<void> writeBends(const std::filesystem::path& file,
                        const std::array<rig::SheetBend, 2>& bends);
/// Error: UnusableInput.
Result<std::array<rig::SheetBend, 2>> readBends(const std::filesystem::path& file);

}  // namespace ostraka::calibration
