#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "mask/view_state.h"

namespace ostraka::mask {

/// Adds the odds of Ostraka's own network, with a weight that is learnt in these photographs
/// (segmentation::NetworkOdds), to the views' log odds and to what the hull is carved from.
/// photographs: CV_8UC3, one per view. Call it after the plate and the heights were weighed.
/// reduction: as in hull::HullOptions. Errors: Cancelled, and those of sherdProbability.
Result<void> addNetwork(std::span<const cv::Mat> photographs, std::span<ViewState> views,
                        int reduction, int threads, const std::stop_token& stop);

/// Labels, scale bars, cards: numbers of the hull's groups that lie in the plate by their heights
/// and of which the network takes less than a tenth for sherd in each photograph. None where it has
/// no notion of most of the other groups, and where heights are not known (one photograph at each
/// stop of a turntable). views: after the hull is shown (ViewState::group).
std::vector<unsigned char> findFlatGroups(std::span<const ViewState> views);

}  // namespace ostraka::mask
