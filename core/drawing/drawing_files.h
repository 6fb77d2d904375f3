#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "paper/sheet.h"

namespace ostraka::drawing {

/// Writes sheets into FILE.svg, a file each (further ones get -2, -3 behind the name), or into any
/// other name as one PDF. FILE itself is overwritten; a further sheet that is there already is not,
/// nor is one left that would look like the next of these. Returns the files. Errors: CannotWrite;
/// then no further sheet is written.
Result<std::vector<std::filesystem::path>> writeSheets(const std::filesystem::path& file,
                                                       const std::vector<Page>& pages);

}  // namespace ostraka::drawing
