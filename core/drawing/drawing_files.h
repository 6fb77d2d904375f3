#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "drawing/view.h"
#include "paper/sheet.h"

namespace ostraka::drawing {

enum class DrawnAs { Sheets, Pictures };
/// Sheets: FILE.pdf or FILE.svg; pictures of the views alone: FILE.png or FILE.tif. Error:
/// UnusableInput for other names, one of the models that are drawn, a place where nothing may be
/// written.
Result<DrawnAs> drawnAs(const std::filesystem::path& file,
                        const std::vector<std::filesystem::path>& inputs = {});

/// Writes sheets into FILE.svg, a file each (further ones get -2, -3 behind the name), or into
/// FILE.pdf together. FILE itself is overwritten; a further sheet that is there already is not,
/// nor is one left that would look like the next of these. Returns the files. Errors: CannotWrite;
/// then no further sheet is written; those of drawnAs.
Result<std::vector<std::filesystem::path>> writeSheets(const std::filesystem::path& file,
                                                       const std::vector<Page>& pages);

/// The picture's file with its resolution in it, by the ending of the name: PNG (pHYs) or TIFF
/// (XResolution, YResolution), so that other programs place it in true size.
std::string formatPicture(const ViewPicture& picture, const std::filesystem::path& file);
/// Writes what formatPicture made for FILE.png or FILE.tif, a file each, named like the sheets in
/// writeSheets and with its errors.
Result<std::vector<std::filesystem::path>> writePictures(const std::filesystem::path& file,
                                                         const std::vector<std::string>& pictures);

}  // namespace ostraka::drawing
