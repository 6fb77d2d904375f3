#include "mask/strange_shadow.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace ostraka::mask {
namespace {

constexpr float kDarkened = 0.25F;     // log brightness: a fifth of the light is missing
constexpr double kBesideSherd_mm = 6;  // a sherd's own shadow is darkest there

// With commas between. In groups, since a message holds nine values.
Message listed(std::vector<Message> parts) {
  constexpr std::size_t kMostValues = 9;
  while (parts.size() > 1) {
    std::vector<Message> groups;
    for (std::size_t first = 0; first < parts.size(); first += kMostValues) {
      std::string places;
      std::vector<MessageValue> values;
      for (std::size_t i = first; i < std::min(first + kMostValues, parts.size()); ++i) {
        values.emplace_back(parts[i]);
        places += (i == first ? "%" : ", %") + std::to_string(values.size());
      }
      groups.emplace_back(places, std::move(values));
    }
    parts = std::move(groups);
  }
  return parts.front();
}

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

Message warningOf(const std::vector<StrangeShadow>& shadows) {
  std::vector<Message> named;
  for (const StrangeShadow& shadow : shadows)
    named.push_back(message("%1 (%2 % of the bare plate)", shadow.file, shadow.percent));
  return message(
      "masks: a shadow that the other photographs do not show falls on the plate in %1; keep "
      "people and hands out of the light, and retake these if their masks look wrong",
      listed(std::move(named)));
}

}  // namespace ostraka::mask
