#include "mask/network_evidence.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/median.h"
#include "base/parallel.h"
#include "segmentation/network_mask.h"
#include "segmentation/network_odds.h"

namespace ostraka::mask {
namespace {

// Labels and scale bars: the network takes no cell of them for sherd, heights find 50 % and more of
// their cells in the plate. Sherds: 70 % and more, and below 20 % (docs/experiments.md).
constexpr uchar kSherd = 128;
constexpr double kUnseen = 0.1, kSeen = 0.5, kFlat = 0.3;

// Shade: less than three quarters of the light of the bare plate. High: rather so by the heights.
// +-50 % of these and the share: at most 0.004 of the 0.013 that batches/hand gains
// (docs/experiments.md).
constexpr float kDark = -0.3F, kHigh = 1, kSurelyHigh = 3;
constexpr double kSeldom = 0.005, kFewestDark = 1000;
constexpr double kFewestOfAThing = 1 / kSeldom;  // in one photograph
constexpr std::size_t kFewestViews = 3;
constexpr float kUnlimited = 1e3F;

bool isDark(const cv::Vec3f& residual) {
  return residual[0] + residual[1] + residual[2] < 3 * kDark;
}

struct GroupCells {
  double all = 0, sherd = 0, low = 0;
  double most_sherd = 0;  // largest share of one photograph
};
using Groups = std::array<GroupCells, hull::kMostGroups + 1>;

Groups groupsOf(const ViewState& view) {
  cv::Mat1f heights;
  cv::resize(view.height_odds, heights, view.group.size(), 0, 0, cv::INTER_AREA);
  Groups groups{};
  for (int y = 0; y < view.group.rows; ++y)
    for (int x = 0; x < view.group.cols; ++x) {
      GroupCells& group = groups[view.group(y, x)];
      group.all += 1;
      if (view.probability(y, x) >= kSherd) group.sherd += 1;
      if (heights(y, x) < 0) group.low += 1;
    }
  return groups;
}

struct HighCells {
  std::array<double, 256> by_probability{};
  double all = 0;

  void add(uchar probability) { by_probability[probability] += 1, all += 1; }
  ShadeLimit limit() const {
    ShadeLimit limit;
    limit.fill(kUnlimited);
    double so_far = 0;
    for (int probability = 0; probability < 256; ++probability) {
      so_far += by_probability[probability];
      if (so_far > kSeldom * all) break;
      limit[probability] = segmentation::networkLogOdds(probability);
    }
    return limit;
  }
};

// By probability the median, without a limit where there are too few.
ShadeLimit mostOf(const std::vector<ShadeLimit>& limits) {
  ShadeLimit most;
  most.fill(kUnlimited);
  if (limits.size() < kFewestViews) return most;
  for (std::size_t p = 0; p < most.size(); ++p) {
    std::vector<float> values;
    for (const ShadeLimit& limit : limits) values.push_back(limit[p]);
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    most[p] = values[values.size() / 2];
  }
  return most;
}

}  // namespace

Result<void> addNetwork(std::span<const cv::Mat> photographs, std::span<ViewState> views,
                        int reduction, int threads, const std::function<void()>& looked,
                        const std::stop_token& stop) {
  const auto sharp = segmentation::sherdProbabilities(photographs, looked, stop);
  if (!sharp) return sharp.error();
  std::vector<segmentation::NetworkSample> samples;
  for (std::size_t i = 0; i < views.size(); ++i) {
    ViewState& view = views[i];
    cv::resize((*sharp)[i], view.probability, view.hull.clear.size(), 0, 0, cv::INTER_AREA);
    samples.push_back({view.probability, view.hull.inside, view.hull.clear});
  }
  const auto odds = segmentation::NetworkOdds::learn(samples);
  if (odds.none()) return {};
  parallelFor(views.size(), threads, [&](std::size_t i) {
    ViewState& view = views[i];
    const cv::Mat1f added = odds.of((*sharp)[i], view.log_odds.size());
    view.log_odds += added;
    const cv::Size size = view.hull.clear.size();
    view.hull.inside =
        cv::max(insideOf(view.log_odds, reduction), sharesOf(view.height_odds, size));
    view.hull.clear = view.hull.clear.mul(1 - sharesOf(added, size));
  });
  return {};
}

std::vector<unsigned char> findFlatGroups(std::span<const ViewState> views) {
  Groups sums{};
  for (const ViewState& view : views) {
    const Groups groups = groupsOf(view);
    for (std::size_t g = 1; g < sums.size(); ++g) {
      if (groups[g].all == 0) continue;
      sums[g].all += groups[g].all, sums[g].sherd += groups[g].sherd, sums[g].low += groups[g].low;
      sums[g].most_sherd = std::max(sums[g].most_sherd, groups[g].sherd / groups[g].all);
    }
  }
  std::vector<unsigned char> flat;
  std::vector<double> others;  // shares that the network takes for sherd
  for (std::size_t g = 1; g < sums.size(); ++g) {
    const GroupCells& group = sums[g];
    if (group.all == 0) continue;
    if (group.most_sherd < kUnseen && group.low > kFlat * group.all)
      flat.push_back(static_cast<unsigned char>(g));
    else
      others.push_back(group.sherd / group.all);
  }
  if (others.empty() || medianOf(std::move(others)) < kSeen) return {};
  return flat;
}

ShadeLimits learnShadeLimits(std::span<const ViewState> views, int reduction, bool of_things) {
  HighCells dark;
  std::vector<std::map<unsigned char, HighCells>> cells(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ViewState& view = views[i];
    cv::Mat1f heights;
    cv::resize(view.height_odds, heights, view.group.size(), 0, 0, cv::INTER_AREA);
    for (int y = 0; y < view.group.rows; ++y)
      for (int x = 0; x < view.group.cols; ++x) {
        const unsigned char group = view.group(y, x);
        if (group == 0) continue;
        const uchar probability = view.probability(y, x);
        HighCells& of_thing = cells[i][group];
        if (heights(y, x) >= kSurelyHigh) of_thing.add(probability);
        const int row = y * reduction + reduction / 2, column = x * reduction + reduction / 2;
        if (heights(y, x) >= kHigh && isDark(view.residual(row, column))) dark.add(probability);
      }
  }
  ShadeLimits limits;
  limits.batch.fill(kUnlimited);
  if (dark.all >= kFewestDark) limits.batch = dark.limit();
  limits.things.resize(views.size());
  if (!of_things) return limits;
  std::map<unsigned char, std::vector<ShadeLimit>> well_seen;
  for (const auto& view : cells)
    for (const auto& [group, of_thing] : view)
      if (of_thing.all >= kFewestOfAThing) well_seen[group].push_back(of_thing.limit());
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const auto& [group, of_thing] : cells[i])
      limits.things[i][group] =
          of_thing.all >= kFewestOfAThing ? of_thing.limit() : mostOf(well_seen[group]);
  return limits;
}

void limitInShade(const ShadeLimits& limits, std::size_t index, ViewState& view) {
  std::array<const ShadeLimit*, 256> of_group;
  of_group.fill(&limits.batch);
  for (const auto& [group, limit] : limits.things[index]) of_group[group] = &limit;
  cv::Mat1b probability, group;
  cv::Mat1f heights;
  const cv::Size size = view.log_odds.size();
  cv::resize(view.probability, probability, size, 0, 0, cv::INTER_LINEAR);
  cv::resize(view.group, group, size, 0, 0, cv::INTER_NEAREST);
  cv::resize(view.height_odds, heights, size, 0, 0, cv::INTER_LINEAR);
  for (int y = 0; y < heights.rows; ++y)
    for (int x = 0; x < heights.cols; ++x)
      if (isDark(view.residual(y, x))) {
        float& odds = view.log_odds(y, x);
        const uchar p = probability(y, x);
        const float limit = std::min(limits.batch[p], (*of_group[group(y, x)])[p]);
        odds = std::min(odds, limit + std::max(0.F, heights(y, x)));
      }
}

}  // namespace ostraka::mask
