#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "base/sheet.h"

namespace ostraka::drawing {

/// Writes sheets into FILE.svg, a file each (further ones get -2, -3 behind the name), or into any
/// other name as one PDF. Returns the files. Errors: CannotWrite.
Result<std::vector<std::filesystem::path>> writeSheets(const std::filesystem::path& file,
                                                       const std::vector<Page>& pages);

}  // namespace ostraka::drawing
