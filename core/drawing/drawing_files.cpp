#include "drawing/drawing_files.h"

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "base/message.h"
#include "base/text.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/output_place.h"

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

std::string bigEndian(std::size_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

// Right after the header, which has a fixed length.
void insertResolution(std::string& png, int dpi) {
  constexpr std::size_t kHeader = 33;
  const auto per_metre = static_cast<std::size_t>(std::lround(1000 * dpi / kMmPerInch));
  const std::string size = bigEndian(per_metre) + bigEndian(per_metre) + '\1';
  const std::string chunk = "pHYs" + size;
  png.insert(kHeader, bigEndian(size.size()) + chunk + bigEndian(crc32(chunk)));
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

Result<std::string> formatPicture(const ViewPicture& picture, const fs::path& file) {
  constexpr int kInch = 2;  // the unit, as TIFF counts them
  const bool png = endsWith(file, ".png");
  const std::vector<int> resolution = {cv::IMWRITE_TIFF_RESUNIT, kInch,
                                       cv::IMWRITE_TIFF_XDPI,    picture.dpi,
                                       cv::IMWRITE_TIFF_YDPI,    picture.dpi};
  std::vector<unsigned char> encoded;
  if (!cv::imencode(png ? ".png" : ".tif", picture.pixels, encoded,
                    png ? std::vector<int>() : resolution))
    return Error::failed(message("The picture could not be encoded."), file.string());
  std::string bytes(encoded.begin(), encoded.end());
  if (png) insertResolution(bytes, picture.dpi);
  return bytes;
}

Result<std::vector<fs::path>> writePictures(const fs::path& file,
                                            const std::vector<std::string>& pictures) {
  if (const Result<void> good = checkOutputFile(file, {".png", ".tif", ".tiff"}); !good)
    return good.error();
  return writeEach(file, pictures);
}

}  // namespace ostraka::drawing
