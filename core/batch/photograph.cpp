#include "batch/photograph.h"

#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "batch/image_header.h"

namespace ostraka::batch {
namespace {

Result<cv::Mat> decoded(const std::filesystem::path& file, int flags) {
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return bytes.error();
  const Result<ImageSize> size = imageSize(*bytes, file.string());
  if (!size) return size.error();
  cv::Mat image;
  try {
    const cv::Mat raw(1, static_cast<int>(bytes->size()), CV_8U, const_cast<char*>(bytes->data()));
    image = cv::imdecode(raw, flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty() || image.cols != size->width || image.rows != size->height)
    return Error{ErrorCode::UnusableInput, "The image cannot be decoded; copy it again.",
                 file.string()};
  return image;
}

}  // namespace

Result<cv::Mat> readPhotograph(const std::filesystem::path& file) {
  return decoded(file, cv::IMREAD_COLOR);
}

Result<cv::Mat> readMask(const std::filesystem::path& file) {
  return decoded(file, cv::IMREAD_GRAYSCALE);
}

}  // namespace ostraka::batch
