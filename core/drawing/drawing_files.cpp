#include "drawing/drawing_files.h"

#include "base/files.h"

namespace ostraka::drawing {
namespace {

namespace fs = std::filesystem;

bool isSvg(const fs::path& file) {
  return file.extension() == ".svg" || file.extension() == ".SVG";
}

}  // namespace

Result<std::vector<fs::path>> writeSheets(const fs::path& file, const std::vector<Page>& pages) {
  if (!isSvg(file)) {
    if (const Result<void> r = writeFileAtomically(file, formatPdf(pages, file.stem().string()));
        !r)
      return r.error();
    return std::vector<fs::path>{file};
  }
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    fs::path name = file;
    if (i > 0) name.replace_filename(file.stem().string() + "-" + std::to_string(i + 1) + ".svg");
    if (const Result<void> r = writeFileAtomically(name, formatSvg(pages[i], name.stem().string()));
        !r)
      return r.error();
    files.push_back(name);
  }
  return files;
}

}  // namespace ostraka::drawing
