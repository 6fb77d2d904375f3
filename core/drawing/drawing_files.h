#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "paper/sheet.h"

namespace ostraka::drawing {

/// Whether sheets may be written there, FILE.pdf or FILE.svg, and none of the models that are
/// drawn. Error: UnusableInput.
Result<void> checkSheetsFile(const std::filesystem::path& file,
                             const std::vector<std::filesystem::path>& inputs = {});

/// Writes sheets into FILE.svg, a file each (further ones get -2, -3 behind the name), or into
/// FILE.pdf together. FILE itself is overwritten; a further sheet that is there already is not,
/// nor is one left that would look like the next of these. Returns the files. Errors: CannotWrite;
/// then no further sheet is written; those of checkSheetsFile.
Result<std::vector<std::filesystem::path>> writeSheets(const std::filesystem::path& file,
                                                       const std::vector<Page>& pages);

}  // namespace ostraka::drawing
