#include "mask/shadow_depths.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "ground/plate_picture.h"

namespace ostraka::mask {
namespace {

constexpr float kLeastShadow = 0.15F;  // log; shallower is the plate's own change
constexpr double kPriorDepths = 20;    // samples, spread over all depths
// At a sherd's foot, within the hull's margin, shadows are deeper than any beside it.
constexpr float kDeeper = 3;
// Where it lasts, it was seen almost to the foot.
constexpr float kDeeperInSight = 1.5F;
constexpr double kEverywhere = 1 / 3.0;  // density that Evidence takes for any depth
constexpr double kMostShadeOdds = 3;
constexpr float kSureClay = 3;  // log odds
constexpr double kDarkestShare = 0.01;
constexpr float kSteeper = 0.5F;  // log

float shadeOf(const cv::Vec3f& v) {
  return (v[0] + v[1] + v[2]) / 3;
}

bool isNeutralShade(const cv::Vec3f& v) {
  const float g = shadeOf(v);
  const float spread = std::max({v[0], v[1], v[2]}) - std::min({v[0], v[1], v[2]});
  return spread < 0.1F + 0.2F * std::abs(g);
}

std::size_t depthStep(float darkness, std::size_t steps) {
  return static_cast<std::size_t>(
      std::clamp(darkness / kShadowStep, 0.F, static_cast<float>(steps - 1)));
}

float levelAt(const cv::Mat& photograph, int y, int x) {
  const cv::Vec3b& v = photograph.at<cv::Vec3b>(y, x);
  return std::log(static_cast<float>(v[0] + v[1] + v[2]) / 3 + ground::kDarkLevel);
}

// By the darkest hundredth of what is surely sherd. Breaks lie steeper to the light than faces.
float darkestClay(std::span<const ShadowSight> sights, int reduction) {
  std::vector<float> levels;
  for (const ShadowSight& view : sights)
    for (int y = 0; y < view.group.rows; ++y)
      for (int x = 0; x < view.group.cols; ++x) {
        const int row = y * reduction + reduction / 2, column = x * reduction + reduction / 2;
        if (view.group(y, x) != 0 && view.log_odds(row, column) > kSureClay)
          levels.push_back(levelAt(view.photograph, row, column));
      }
  if (levels.empty()) return 0;
  const auto at = levels.begin() +
                  static_cast<std::ptrdiff_t>(kDarkestShare * static_cast<double>(levels.size()));
  std::nth_element(levels.begin(), at, levels.end());
  return *at - kSteeper;
}

using Counts = std::array<double, std::tuple_size_v<decltype(ShadowDepths::odds)>>;

// By how often each darkness was seen; a shadow may be `deeper` times as dark as one that was seen.
void setOdds(ShadowDepths& depths, const Counts& counts, float deeper) {
  double all = 0;
  for (const double count : counts) all += count;
  const std::size_t first = depthStep(kLeastShadow, counts.size()) + 1;
  for (std::size_t k = first; k < counts.size(); ++k) {
    double most = 0;
    for (auto j = static_cast<std::size_t>(static_cast<float>(k) / deeper); j <= k; ++j)
      most = std::max(most, counts[j]);
    const double density = (most + kPriorDepths / static_cast<double>(counts.size())) /
                           ((all + kPriorDepths) * kShadowStep);
    depths.odds[k] =
        static_cast<float>(std::clamp(std::log(kEverywhere / density), 0.0, kMostShadeOdds));
  }
  // Once too dark for a shadow, darker is no more like one.
  for (std::size_t k = first; k < counts.size(); ++k)
    depths.odds[k] = std::max(depths.odds[k], depths.odds[k - 1]);
}

}  // namespace

void ShadowDepths::addTo(cv::Mat1f& log_odds, const cv::Mat3f& residual,
                         const cv::Mat& photograph) const {
  for (int y = 0; y < log_odds.rows; ++y)
    for (int x = 0; x < log_odds.cols; ++x) {
      const float g = shadeOf(residual(y, x));
      if (g < 0 && levelAt(photograph, y, x) > darkest_clay)
        log_odds(y, x) += odds[depthStep(-g, odds.size())];
    }
}

ShadowDepths learnShadowDepths(std::span<const ShadowSight> sights, int reduction) {
  ShadowDepths depths;
  Counts counts{};
  for (const ShadowSight& view : sights) {
    cv::Mat1b near;
    cv::dilate(view.group, near, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    for (int y = 0; y < near.rows; ++y)
      for (int x = 0; x < near.cols; ++x) {
        if (near(y, x) != 0 || view.plate(y, x) == 0) continue;
        const cv::Vec3f& v =
            view.residual(y * reduction + reduction / 2, x * reduction + reduction / 2);
        const float darkness = -shadeOf(v);
        if (darkness < kLeastShadow || !isNeutralShade(v)) continue;
        counts[depthStep(darkness, counts.size())] += 1;
      }
  }
  setOdds(depths, counts, kDeeper);
  depths.darkest_clay = darkestClay(sights, reduction);
  return depths;
}

ShadowDepths depthsOfLastingShade(const ground::SheetPicture& picture) {
  ShadowDepths depths;
  Counts counts{};
  for (int y = 0; y < picture.shade.rows; ++y)
    for (int x = 0; x < picture.shade.cols; ++x)
      if (picture.shade(y, x) != 0)
        counts[depthStep(-shadeOf(picture.correction(y, x)), counts.size())] += 1;
  if (*std::max_element(counts.begin(), counts.end()) > 0) setOdds(depths, counts, kDeeperInSight);
  return depths;
}

}  // namespace ostraka::mask
