#include "drawing/drawing_files.h"

#include "base/message.h"
#include "base/text.h"
#include "files/files.h"
#include "files/output_place.h"

namespace ostraka::drawing {
namespace {

namespace fs = std::filesystem;

bool isSvg(const fs::path& file) {
  return lowerCase(file.extension().string()) == ".svg";
}

fs::path sheetOf(const fs::path& file, std::size_t index) {
  fs::path name = file;
  if (index > 0)
    name.replace_filename(file.stem().string() + "-" + std::to_string(index + 1) + ".svg");
  return name;
}

}  // namespace

Result<void> checkSheetsFile(const fs::path& file, const std::vector<fs::path>& inputs) {
  return checkOutputFile(file, {".pdf", ".svg"}, inputs);
}

Result<std::vector<fs::path>> writeSheets(const fs::path& file, const std::vector<Page>& pages) {
  if (const Result<void> good = checkSheetsFile(file); !good) return good.error();
  if (!isSvg(file)) {
    if (const Result<void> r = writeFileAtomically(file, formatPdf(pages, file.stem().string()));
        !r)
      return r.error();
    return std::vector<fs::path>{file};
  }
  for (std::size_t i = 1; i <= pages.size(); ++i) {
    std::error_code absent;
    if (const fs::path further = sheetOf(file, i); fs::exists(further, absent))
      return Error{
          ErrorCode::CannotWrite,
          message("A sheet of an earlier drawing already exists and is not overwritten; choose "
                  "another name, or delete that sheet."),
          further.string()};
  }
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const fs::path name = sheetOf(file, i);
    if (const Result<void> r = writeFileAtomically(name, formatSvg(pages[i], name.stem().string()));
        !r) {
      std::error_code stays;
      for (std::size_t k = 1; k < files.size(); ++k) fs::remove(files[k], stays);
      return r.error();
    }
    files.push_back(name);
  }
  return files;
}

}  // namespace ostraka::drawing
