#include "ground/sheet_rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/median.h"

namespace ostraka::ground {
namespace {

constexpr float kDeepest = -2.2F;    // log brightness: a tenth of the light is left in every shadow
constexpr float kShadowTint = 0.5F;  // light of the sky or off a sherd, per 1 of darkening
// What is even within 0.05 shows nearly no clay. Of that which looks like a shadow then, 0.72 to
// 0.94 lasts by five lamps and suns, 0.44 and 0.50 by two flashes.
constexpr float kEven = 0.05F;
constexpr double kMostLast = 0.6;
constexpr double kFewestDark = 0.0005;  // of all looks; they were 0.0013 to 0.01

bool looksLikeShadow(const SheetRest& rest, int row, int column) {
  if (!isKnown(rest(row, column))) return false;
  const cv::Vec3f logs = logsOf(rest(row, column));
  const float g = brightnessOfRest(logs);
  if (g > -2 * kStain.brightness || !mayBeShadow(logs)) return false;
  for (const auto& [y, x] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const cv::Vec3s& beside = rest(row + y, column + x);
    if (!isKnown(beside) || std::abs(brightnessOfRest(logsOf(beside)) - g) > kEven) return false;
  }
  return true;
}

}  // namespace

bool mayBeShadow(const cv::Vec3f& logs) {
  const float g = brightnessOfRest(logs);
  return g <= kStain.brightness && g >= kDeepest &&
         cv::norm(logs - cv::Vec3f::all(g)) <= kStain.colour + kShadowTint * std::abs(g);
}

bool lightStandsStill(const std::vector<SheetRest>& rests, const cv::Mat1b& paper) {
  std::int64_t looks = 0, dark = 0, lasting = 0;
  std::vector<float> seen, shadows;
  for (int row = 1; row < rests[0].rows - 1; ++row)
    for (int column = 1; column < rests[0].cols - 1; ++column) {
      if (paper(2 * row, 2 * column) == 0) continue;
      seen.clear();
      shadows.clear();
      for (const SheetRest& rest : rests) {
        if (!isKnown(rest(row, column))) continue;
        seen.push_back(brightnessOfRest(logsOf(rest(row, column))));
        if (looksLikeShadow(rest, row, column)) shadows.push_back(seen.back());
      }
      looks += static_cast<std::int64_t>(seen.size());
      if (seen.size() < 3 || shadows.empty()) continue;
      const float usual = medianOf(seen);
      const float alike = std::max(kStain.brightness, 0.15F * std::abs(usual));
      for (const float shadow : shadows) {
        ++dark;
        if (std::abs(shadow - usual) < alike) ++lasting;
      }
    }
  return static_cast<double>(dark) < kFewestDark * static_cast<double>(looks) ||
         static_cast<double>(lasting) >= kMostLast * static_cast<double>(dark);
}

}  // namespace ostraka::ground
