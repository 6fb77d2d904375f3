#include "drawing/drawing_files.h"

#include "base/message.h"
#include "base/text.h"
#include "files/files.h"
#include "files/output_place.h"
#include "images/png_image.h"
#include "images/tiff_image.h"

namespace ostraka::drawing {
namespace {

namespace fs = std::filesystem;

bool endsWith(const fs::path& file, const char* ending) {
  return lowerCase(file.extension().string()) == ending;
}

fs::path numbered(const fs::path& file, std::size_t index) {
  fs::path name = file;
  if (index > 0)
    name.replace_filename(file.stem().string() + "-" + std::to_string(index + 1) +
                          file.extension().string());
  return name;
}

Result<std::vector<fs::path>> writeEach(const fs::path& file,
                                        const std::vector<std::string>& contents) {
  for (std::size_t i = 1; i <= contents.size(); ++i) {
    std::error_code absent;
    if (const fs::path further = numbered(file, i); fs::exists(further, absent))
      return Error{
          ErrorCode::CannotWrite,
          message("A sheet of an earlier drawing already exists and is not overwritten; choose "
                  "another name, or delete that sheet."),
          further.string()};
  }
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    const fs::path name = numbered(file, i);
    if (const Result<void> r = writeFileAtomically(name, contents[i]); !r) {
      std::error_code stays;
      for (std::size_t k = 1; k < files.size(); ++k) fs::remove(files[k], stays);
      return r.error();
    }
    files.push_back(name);
  }
  return files;
}

}  // namespace

Result<DrawnAs> drawnAs(const fs::path& file, const std::vector<fs::path>& inputs) {
  if (const Result<void> good =
          checkOutputFile(file, {".pdf", ".svg", ".png", ".tif", ".tiff"}, inputs);
      !good)
    return good.error();
  return endsWith(file, ".pdf") || endsWith(file, ".svg") ? DrawnAs::Sheets : DrawnAs::Pictures;
}

Result<std::vector<fs::path>> writeSheets(const fs::path& file, const std::vector<Page>& pages) {
  if (const Result<void> good = checkOutputFile(file, {".pdf", ".svg"}); !good) return good.error();
  if (!endsWith(file, ".svg")) {
    if (const Result<void> r = writeFileAtomically(file, formatPdf(pages, file.stem().string()));
        !r)
      return r.error();
    return std::vector<fs::path>{file};
  }
  std::vector<std::string> sheets;
  for (std::size_t i = 0; i < pages.size(); ++i)
    sheets.push_back(formatSvg(pages[i], numbered(file, i).stem().string()));
  return writeEach(file, sheets);
}

std::string formatPicture(const ViewPicture& picture, const fs::path& file) {
  return endsWith(file, ".png") ? images::encodedPng(picture.pixels, 3, picture.dpi)
                                : images::encodedTiff(picture.pixels, picture.dpi);
}

Result<std::vector<fs::path>> writePictures(const fs::path& file,
                                            const std::vector<std::string>& pictures) {
  if (const Result<void> good = checkOutputFile(file, {".png", ".tif", ".tiff"}); !good)
    return good.error();
  return writeEach(file, pictures);
}

}  // namespace ostraka::drawing
