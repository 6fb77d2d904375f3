#include "registration/turn_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "registration/fracture_colour.h"
#include "registration/self_check.h"

namespace ostraka::registration {
namespace {

constexpr double kFitStep = 2.5;     // of the coarse strips' spacing: a fit reaches half as far
constexpr int kBetween = 5;          // turns that are tried for each fit: half a spacing apart
constexpr double kDistinct = 2;      // log-likelihoods of unrelated colours are alike at all turns
constexpr double kFineStepMm = 0.2;  // fine detail agrees about this far to either side

FittedPose turnedBy(const FittedPose& pose, double angle_rad, const Strip& front,
                    const PairFit& pair) {
  FittedPose turned;
  turned.start = pose.start;
  turned.alike = pose.alike;  // so that colours count from the first: by shape alone it would slide
  Vector6 x = Vector6::Zero();
  x.head<3>() = angle_rad * front.up;
  turned.front_from_back = turned.begun =
      changed(pose.front_from_back, x, pair.pivot(pose.front_from_back));
  return turned;
}

// Within one step of the coarse search, by the fine strips' detail.
FittedPose refined(FittedPose pose, double step_rad, const Strip& front, const Strip& back,
                   const PairFit& pair, int threads) {
  pair.fine(pose);
  const int half = std::max(1, static_cast<int>(std::ceil(step_rad * pair.radius() / kFineStepMm)));
  std::vector<double> likelihoods(static_cast<std::size_t>(2 * half + 1));
  const auto at = [&](std::size_t k) {
    return turnedBy(pose, step_rad * (static_cast<double>(k) - half) / half, front, pair);
  };
  parallelFor(likelihoods.size(), threads, [&](std::size_t k) {
    likelihoods[k] =
        correlateColours(front.fine, back.fine, at(k).front_from_back, {}).log_likelihood;
  });
  const auto best = std::max_element(likelihoods.begin(), likelihoods.end());
  return at(static_cast<std::size_t>(best - likelihoods.begin()));
}

}  // namespace

std::optional<FittedPose> turnByColours(const FittedPose& pose, const Strip& front,
                                        const Strip& back, const PairFit& pair, int threads,
                                        const std::stop_token& stop) {
  if (front.coarse.colours.empty() || back.coarse.colours.empty()) return {};
  const double around_mm = 2 * std::numbers::pi * pair.radius();
  const int count =
      std::max(8, static_cast<int>(std::ceil(around_mm / (kFitStep * pair.coarseMm()))));
  ColourOptions colours;
  colours.reach_mm = pair.coarseMm();
  struct Turn {
    FittedPose pose;
    double likelihood = 0;
  };
  std::vector<Turn> turns(static_cast<std::size_t>(count));
  const double step_rad = 2 * std::numbers::pi / count;
  parallelFor(turns.size(), threads, [&](std::size_t k) {
    if (stop.stop_requested()) return;
    FittedPose fit = turnedBy(pose, step_rad * static_cast<double>(k), front, pair);
    pair.coarse(fit);
    for (int j = -kBetween / 2; j <= kBetween / 2; ++j) {
      const FittedPose turned = turnedBy(fit, step_rad * j / kBetween, front, pair);
      const double likelihood =
          correlateColours(front.coarse, back.coarse, turned.front_from_back, colours)
              .log_likelihood;
      if (j > -kBetween / 2 && likelihood <= turns[k].likelihood) continue;
      turns[k] = {turned, likelihood};
    }
  });
  std::size_t best = 0;
  for (std::size_t k = 1; k < turns.size(); ++k)
    if (turns[k].likelihood > turns[best].likelihood) best = k;
  double other = 0;  // neighbours share detail with the best
  for (std::size_t k = 2; k + 2 < turns.size(); ++k)
    other = std::max(other, turns[(best + k) % turns.size()].likelihood);
  // Of so many turns some agree a little by chance.
  const double by_chance = kRivalGap + std::log(static_cast<double>(count) * kBetween);
  if (!(turns[best].likelihood > std::max(kDistinct * other, by_chance))) return {};
  return refined(turns[best].pose, step_rad / kBetween, front, back, pair, threads);
}

}  // namespace ostraka::registration
