#include "batch/photograph.h"

#include <cmath>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"
#include "batch/heif_image.h"
#include "batch/image_header.h"
#include "batch/jpeg_image.h"
#include "batch/raw_image.h"
#include "files/files.h"

namespace ostraka::batch {
namespace {

Result<cv::Mat> decoded(std::string_view bytes, const std::string& where, int flags) {
  // What a RAW file's own size is comes out only with its values, which takes as long again.
  if (hasRawEnding(where)) return decodeRaw(bytes, where);
  const Result<ImageSize> size = imageSize(bytes, where);
  if (!size) return size.error();
  const Result<cv::Mat> image =
      isHeif(bytes)   ? decodeHeif(bytes, where)
      : isJpeg(bytes) ? decodeJpeg(bytes, *size, flags == cv::IMREAD_GRAYSCALE ? 1 : 3, where)
                      : Result<cv::Mat>(decodedByOpenCv(bytes, flags));
  if (!image) return image.error();
  if (image->empty() || image->cols != size->width || image->rows != size->height)
    return undecodableImage(where);
  return *image;
}

Result<cv::Mat> readImage(const std::filesystem::path& file, int flags) {
  const Result<std::string> bytes = readFile(file, limits::kImageBytes.most);
  if (!bytes) return bytes.error();
  return decoded(*bytes, file.string(), flags);
}

}  // namespace

cv::Mat decodedByOpenCv(std::string_view bytes, int flags) {
  try {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    return cv::imdecode(raw, flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    return {};
  }
}

void makeOpenCvThrowBadAlloc() {
  cv::redirectError([](int status, const char*, const char*, const char*, int, void*) -> int {
    if (status == cv::Error::StsNoMem) throw std::bad_alloc();
    return 0;
  });
}

bool hasPhotographEnding(const std::filesystem::path& file) {
  const std::string ending = lowerCase(file.extension().string());
  return ending == ".jpg" || ending == ".jpeg" || ending == ".png" || ending == ".tif" ||
         ending == ".tiff" || ending == ".heic" || ending == ".heif";
}

Result<cv::Mat> readPhotograph(const std::filesystem::path& file) {
  return readImage(file, cv::IMREAD_COLOR);
}

Result<cv::Mat> decodePhotograph(std::string_view bytes, const std::string& where) {
  return decoded(bytes, where, cv::IMREAD_COLOR);
}

Result<cv::Mat> readMask(const std::filesystem::path& file) {
  return readImage(file, cv::IMREAD_GRAYSCALE);
}

cv::Mat reducedTo(const cv::Mat& picture, int width, int height) {
  if (picture.cols <= width && picture.rows <= height) return picture;
  cv::Mat small;
  cv::resize(picture, small, {width, height}, 0, 0, cv::INTER_AREA);
  return small;
}

cv::Mat greyOf(const cv::Mat& photograph) {
  if (photograph.channels() == 1) return photograph;
  cv::Mat grey;
  cv::cvtColor(photograph, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

const std::array<double, 256>& linearLight() {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) {
      const double v = static_cast<double>(i) / 255.0;
      light[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    return light;
  }();
  return table;
}

}  // namespace ostraka::batch
