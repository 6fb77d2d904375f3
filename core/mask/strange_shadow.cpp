#include "mask/strange_shadow.h"

#include <opencv2/imgproc.hpp>

namespace ostraka::mask {
namespace {

constexpr float kDarkened = 0.25F;     // log brightness: a fifth of the light is missing
constexpr double kBesideSherd_mm = 6;  // a sherd's own shadow is darkest there

}  // namespace

double darkenedShare(const cv::Mat3f& residual, const cv::Mat1b& group, const cv::Mat1b& plate,
                     int reduction, double mm_per_pixel) {
  const int reach = cvCeil(kBesideSherd_mm / (reduction * mm_per_pixel));
  cv::Mat1b near;
  cv::dilate(group, near,
             cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * reach + 1, 2 * reach + 1}));
  int bare = 0, darkened = 0;
  for (int y = 0; y < near.rows; ++y)
    for (int x = 0; x < near.cols; ++x) {
      if (near(y, x) != 0 || plate(y, x) == 0) continue;
      const cv::Vec3f& v = residual(y * reduction, x * reduction);
      ++bare;
      if (v[0] + v[1] + v[2] < -3 * kDarkened) ++darkened;
    }
  return bare > 0 ? static_cast<double>(darkened) / bare : 0;
}

}  // namespace ostraka::mask
