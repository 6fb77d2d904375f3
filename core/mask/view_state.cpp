#include "mask/view_state.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "mask/raised.h"

namespace ostraka::mask {

cv::Mat1f sharesOf(const cv::Mat1f& odds, cv::Size size) {
  cv::Mat1f shares;
  cv::resize(odds, shares, size, 0, 0, cv::INTER_AREA);
  for (float& share : shares) share = std::clamp(share / 4, 0.F, 1.F);
  return shares;
}

cv::Mat1f insideOf(const cv::Mat1f& log_odds, int reduction) {
  cv::Mat1f inside = log_odds.clone(), small;
  for (float& odds : inside) odds = odds > 2 ? 1.F : 0.F;
  const cv::Size size(inside.cols / reduction, inside.rows / reduction);
  cv::resize(inside, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

hull::HullView hullViewOf(const ViewState& view, const cv::Mat1b& mask) {
  hull::HullView carved{view.hull.image, {}, {}};
  cv::Mat small;
  cv::resize(mask, small, view.hull.clear.size(), 0, 0, cv::INTER_AREA);
  small.convertTo(carved.inside, CV_32F, 1 / 255.0);
  carved.clear = 1 - carved.inside;
  carved.clear.setTo(0, view.plate == 0);
  return carved;
}

void addHeights(ViewState& view, const cv::Mat1f& odds) {
  view.height_odds = odds;
  view.log_odds += heightsInTheLight(odds, view.residual);
  const cv::Mat1f shares = sharesOf(odds, view.hull.clear.size());
  view.hull.inside = cv::max(view.hull.inside, shares);
  view.hull.clear = view.hull.clear.mul(1 - shares);
}

}  // namespace ostraka::mask
