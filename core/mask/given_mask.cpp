#include "mask/given_mask.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <system_error>

namespace ostraka::mask {
namespace {

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

Result<cv::Mat1b> readGivenMask(const std::filesystem::path& path, int width, int height) {
  const std::string expected = "a mask of " + sizeText(width, height) + " pixels";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return Error{ErrorCode::UnusableInput,
                 "The mask is missing; expected " + expected + " under this name.", path.string()};
  cv::Mat labels;
  try {
    labels = cv::imread(path.string(), cv::IMREAD_UNCHANGED | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    labels.release();
  }
  if (labels.empty())
    return Error{ErrorCode::UnusableInput,
                 "The mask cannot be read as a picture; expected " + expected + ".", path.string()};
  if (labels.cols != width || labels.rows != height)
    return Error{ErrorCode::UnusableInput,
                 "The mask has " + sizeText(labels.cols, labels.rows) + " pixels; expected " +
                     expected + ", the size of its photograph.",
                 path.string()};
  cv::Mat planes = labels;
  if (labels.channels() == 4 || labels.channels() == 2) {
    cv::Mat alpha;
    cv::extractChannel(labels, alpha, labels.channels() - 1);
    double least = 0, most = 0;
    cv::minMaxLoc(alpha, &least, &most);
    if (least < most)
      planes = alpha;  // else opaque all over: the labels are in the colours
    else if (labels.channels() == 4)
      cv::cvtColor(labels, planes, cv::COLOR_BGRA2BGR);
    else
      cv::extractChannel(labels, planes, 0);
  }
  cv::Mat1b inside(height, width, uchar{0});
  for (int channel = 0; channel < planes.channels(); ++channel) {
    cv::Mat plane;
    cv::extractChannel(planes, plane, channel);
    inside |= plane != 0;
  }
  return inside;
}

}  // namespace ostraka::mask
