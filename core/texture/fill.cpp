#include "texture/fill.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace ostraka::texture {
namespace {

struct Level {
  cv::Mat3f page;
  cv::Mat1f weight;  // 0 .. 1: how much of the texel is known
};

Level halved(const Level& level) {
  const cv::Size size((level.page.cols + 1) / 2, (level.page.rows + 1) / 2);
  Level half{cv::Mat3f(size, cv::Vec3f(0, 0, 0)), cv::Mat1f(size, 0.0f)};
  for (int y = 0; y < level.page.rows; ++y)
    for (int x = 0; x < level.page.cols; ++x) {
      half.page(y / 2, x / 2) += level.weight(y, x) * level.page(y, x);
      half.weight(y / 2, x / 2) += level.weight(y, x);
    }
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (half.weight(y, x) > 0) half.page(y, x) *= 1 / half.weight(y, x);
      half.weight(y, x) = std::min(1.0f, half.weight(y, x));
    }
  return half;
}

void fill(Level& level) {
  if (level.page.cols <= 1 && level.page.rows <= 1) return;
  Level half = halved(level);
  fill(half);
  cv::Mat3f smooth;
  cv::resize(half.page, smooth, {2 * half.page.cols, 2 * half.page.rows}, 0, 0, cv::INTER_LINEAR);
  for (int y = 0; y < level.page.rows; ++y)
    for (int x = 0; x < level.page.cols; ++x) {
      const float w = level.weight(y, x);
      level.page(y, x) = w * level.page(y, x) + (1 - w) * smooth(y, x);
    }
}

}  // namespace

cv::Mat3f filled(const cv::Mat3f& page, const cv::Mat1b& known) {
  if (cv::countNonZero(known) == 0) return page.clone();
  Level level{page.clone(), cv::Mat1f(page.size(), 0.0f)};
  for (int y = 0; y < page.rows; ++y)
    for (int x = 0; x < page.cols; ++x) level.weight(y, x) = known(y, x) != 0 ? 1.0f : 0.0f;
  fill(level);
  return level.page;
}

}  // namespace ostraka::texture
