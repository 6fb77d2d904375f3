#include "mask/colour_model.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace ostraka::mask {
namespace {

constexpr int kLevels = 18;  // of brightness, a quarter of e each: from log 4 to log 260
constexpr int kTints = 13;   // of each colour difference, 0.08 wide: the noise in dark pixels
constexpr int kMargin = 25;  // pixels around a group where its background is learnt

void sharpenPart(const cv::Mat3f& colours, const cv::Mat1b& group, const cv::Mat1b& any,
                 const cv::Rect& part, cv::Mat1f& log_odds) {
  ColourHistogram sherd, ground;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) {
      const float odds = log_odds(y, x);
      if (group(y - part.y, x - part.x) != 0 && odds > 4)
        sherd.add(ColourHistogram::bin(colours(y, x)));
      else if (odds < -1.5F || any(y, x) == 0)
        ground.add(ColourHistogram::bin(colours(y, x)));
    }
  sherd.finish();
  ground.finish();
  if (sherd.total() < 100 || ground.total() < 100) return;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) {
      if (group(y - part.y, x - part.x) == 0) continue;
      const int bin = ColourHistogram::bin(colours(y, x));
      log_odds(y, x) += std::clamp(std::log(sherd.density(bin) / ground.density(bin)), -2.F, 2.F);
    }
}

}  // namespace

ColourHistogram::ColourHistogram() : counts_(kLevels * kTints * kTints, 0.F) {}

int ColourHistogram::bin(const cv::Vec3f& log_colour) {
  const float level = (log_colour[0] + log_colour[1] + log_colour[2]) / 3;
  const auto tint = [](float v) {
    return std::clamp(static_cast<int>(std::floor(v / 0.08F + 0.5F * kTints)), 0, kTints - 1);
  };
  const int row = std::clamp(static_cast<int>((level - 1.386F) * 4), 0, kLevels - 1);
  return (row * kTints + tint(log_colour[2] - log_colour[1])) * kTints +
         tint(log_colour[1] - log_colour[0]);
}

void ColourHistogram::finish() {
  for (const int stride : {1, kTints, kTints * kTints}) {
    const std::vector<float> before = counts_;
    const int length = stride == kTints * kTints ? kLevels : kTints;
    for (int i = 0; i < static_cast<int>(counts_.size()); ++i) {
      const int place = i / stride % length;
      const float left = place > 0 ? before[i - stride] : before[i];
      const float right = place + 1 < length ? before[i + stride] : before[i];
      counts_[i] = 0.25F * left + 0.5F * before[i] + 0.25F * right;
    }
  }
  total_ = 0;
  for (const float count : counts_) total_ += count;
}

float ColourHistogram::density(int bin) const {
  return total_ > 0 ? counts_[bin] / total_ + 1e-4F : 1e-4F;
}

void sharpenByColours(const cv::Mat3f& log_colours, const cv::Mat1b& allowed, cv::Mat1f& log_odds) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(allowed, labels, stats, centres, 8, CV_32S);
  for (int label = 1; label < count; ++label) {
    const cv::Rect tight(
        stats.at<int>(label, cv::CC_STAT_LEFT), stats.at<int>(label, cv::CC_STAT_TOP),
        stats.at<int>(label, cv::CC_STAT_WIDTH), stats.at<int>(label, cv::CC_STAT_HEIGHT));
    const cv::Rect part = cv::Rect(tight.x - kMargin, tight.y - kMargin, tight.width + 2 * kMargin,
                                   tight.height + 2 * kMargin) &
                          cv::Rect({0, 0}, allowed.size());
    const cv::Mat1b group = labels(part) == label;
    sharpenPart(log_colours, group, allowed, part, log_odds);
  }
}

}  // namespace ostraka::mask
