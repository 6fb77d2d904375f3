#include "batch/photograph.h"

#include <cmath>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "base/limits.h"
#include "base/text.h"
#include "files/files.h"
#include "images/decode.h"

namespace ostraka::batch {
namespace {

Result<cv::Mat> readImage(const std::filesystem::path& file, images::Values values) {
  const Result<std::string> bytes = readFile(file, limits::kImageBytes.most);
  if (!bytes) return bytes.error();
  return images::decodeImage(*bytes, values, file.string());
}

}  // namespace

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
  return readImage(file, images::Values::Bgr);
}

Result<cv::Mat> decodePhotograph(std::string_view bytes, const std::string& where) {
  return images::decodeImage(bytes, images::Values::Bgr, where);
}

Result<cv::Mat> readMask(const std::filesystem::path& file) {
  return readImage(file, images::Values::Grey);
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
