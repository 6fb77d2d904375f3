#include "pairing/paper.h"

#include <algorithm>

#include "pairing/turning_angles.h"

namespace ostraka::pairing {

Result<PaperCost> paperCost(std::span<const Eigen::Vector2d> front,
                            std::span<const Eigen::Vector2d> back_mirrored) {
  constexpr int kSamples = 200;  // the paper's number
  const Result<std::vector<double>> a = turningAngles(front, kSamples);
  if (!a) return a.error();
  const Result<std::vector<double>> b = turningAngles(back_mirrored, kSamples);
  if (!b) return b.error();
  const std::vector<double> costs = shiftCosts(*a, *b, Offset::None);
  const auto best = std::min_element(costs.begin(), costs.end());
  return PaperCost{*best, static_cast<int>(best - costs.begin())};
}

}  // namespace ostraka::pairing
