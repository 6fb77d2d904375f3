#include "mask/network_evidence.h"

#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/median.h"
#include "base/parallel.h"
#include "segmentation/network_mask.h"
#include "segmentation/network_odds.h"

namespace ostraka::mask {
namespace {

// Means over a group's cells of what the network says, 0..255. Labels and scale bars: below 1,
// sherds: above 170; and the share of cells that heights find in the plate: 0.5 and more, below
// 0.2.
constexpr double kUnseen = 25, kSeen = 128, kFlat = 0.3;

struct GroupMeans {
  double cells = 0, says = 0, low = 0;
};

}  // namespace

Result<void> addNetwork(std::span<const cv::Mat> photographs, std::span<ViewState> views,
                        int reduction, int threads, const std::stop_token& stop) {
  std::vector<cv::Mat1b> says(views.size());
  std::vector<segmentation::NetworkSight> sights;
  for (std::size_t i = 0; i < views.size(); ++i) {  // each on all processors
    if (stop.stop_requested()) return Error::cancelled();
    Result<cv::Mat1b> said = segmentation::maskByShippedNetwork(photographs[i]);
    if (!said) return said.error();
    says[i] = std::move(*said);
    ViewState& view = views[i];
    cv::resize(says[i], view.says, view.hull.clear.size(), 0, 0, cv::INTER_AREA);
    sights.push_back({view.says, view.hull.inside, view.hull.clear});
  }
  const auto odds = segmentation::NetworkOdds::learn(sights);
  parallelFor(views.size(), threads, [&](std::size_t i) {
    ViewState& view = views[i];
    const cv::Mat1f own = odds.of(says[i], view.log_odds.size());
    view.log_odds += own;
    const cv::Size size = view.hull.clear.size();
    view.hull.inside =
        cv::max(insideOf(view.log_odds, reduction), sharesOf(view.height_odds, size));
    view.hull.clear = view.hull.clear.mul(1 - sharesOf(own, size));
  });
  return {};
}

std::vector<unsigned char> flatThings(std::span<const ViewState> views) {
  std::array<GroupMeans, hull::kMostGroups + 1> groups{};
  for (const ViewState& view : views) {
    if (view.says.empty() || view.height_odds.empty()) continue;
    cv::Mat1f heights;
    cv::resize(view.height_odds, heights, view.group.size(), 0, 0, cv::INTER_AREA);
    for (int y = 0; y < view.group.rows; ++y)
      for (int x = 0; x < view.group.cols; ++x) {
        GroupMeans& group = groups[view.group(y, x)];
        group.cells += 1, group.says += view.says(y, x), group.low += heights(y, x) < 0 ? 1 : 0;
      }
  }
  std::vector<unsigned char> flat;
  std::vector<double> others;
  for (std::size_t g = 1; g < groups.size(); ++g) {
    const auto& [cells, says, low] = groups[g];
    if (cells == 0) continue;
    if (says < kUnseen * cells && low > kFlat * cells)
      flat.push_back(static_cast<unsigned char>(g));
    else
      others.push_back(says / cells);
  }
  if (others.empty() || medianOf(std::move(others)) < kSeen) flat.clear();
  return flat;
}

}  // namespace ostraka::mask
