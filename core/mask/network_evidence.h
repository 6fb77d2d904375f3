#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "mask/view_state.h"

namespace ostraka::mask {

/// Ostraka's own network says of each photograph (CV_8UC3) where sherds are, and counts for as much
/// as the rest of the evidence bears it out in these photographs (segmentation::NetworkOdds): in
/// the views' log odds and in what the hull is carved from. One view per photograph, after the
/// plate and the heights were weighed. reduction: hull::HullOptions. Errors: Cancelled.
Result<void> addNetwork(std::span<const cv::Mat> photographs, std::span<ViewState> views,
                        int reduction, int threads, const std::stop_token& stop);

/// Numbers of the hull's groups that are no sherds: labels, scale bars, cards. They lie in the
/// plate and the network sees nothing of a sherd in them, in any photograph, though it sees the
/// others; where it is blind to most groups, none. views: after the hull is shown
/// (ViewState::group).
std::vector<unsigned char> flatThings(std::span<const ViewState> views);

}  // namespace ostraka::mask
