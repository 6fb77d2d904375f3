#include "batch/label_mask.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "base/limits.h"
#include "files/files.h"
#include "images/decode.h"
#include "images/jpeg_image.h"

namespace ostraka::batch {
namespace {

// The planes that tell what is inside.
cv::Mat withoutAlpha(const cv::Mat& labels) {
  if (labels.channels() != 4 && labels.channels() != 2) return labels;
  cv::Mat alpha, planes;
  cv::extractChannel(labels, alpha, labels.channels() - 1);
  double least = 0, most = 0;
  cv::minMaxLoc(alpha, &least, &most);
  if (least < most) return alpha;  // else opaque all over: the labels are in the colours
  if (labels.channels() == 4)
    cv::cvtColor(labels, planes, cv::COLOR_BGRA2BGR);
  else
    cv::extractChannel(labels, planes, 0);
  return planes;
}

}  // namespace

Result<cv::Mat1b> readLabelMask(const std::filesystem::path& file) {
  const Result<std::string> bytes = readFile(file, limits::kImageBytes.most);
  if (!bytes) return bytes.error();
  const Result<cv::Mat> labels =
      images::decodeImage(*bytes, images::Values::AsStored, file.string());
  if (!labels) return labels.error();
  const bool jpeg = images::isJpeg(*bytes);
  const cv::Mat planes = withoutAlpha(*labels);
  cv::Mat1b inside(planes.rows, planes.cols, uchar{0});
  for (int channel = 0; channel < planes.channels(); ++channel) {
    cv::Mat plane;
    cv::extractChannel(planes, plane, channel);
    inside |= jpeg ? plane >= 128 : plane != 0;
  }
  return inside;
}

}  // namespace ostraka::batch
