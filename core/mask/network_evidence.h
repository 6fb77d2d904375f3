#pragma once
#include <array>
#include <functional>
#include <map>
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
/// reduction: as in hull::HullOptions. looked: called after each photograph. Errors: Cancelled, and
/// those of sherdProbabilities.
Result<void> addNetwork(std::span<const cv::Mat> photographs, std::span<ViewState> views,
                        int reduction, int threads, const std::function<void()>& looked,
                        const std::stop_token& stop);

/// Labels, scale bars, cards: numbers of the hull's groups that lie in the plate by their heights
/// and of which the network takes less than a tenth for sherd in each photograph. None where it has
/// no notion of most of the other groups, and where heights are not known (one photograph at each
/// stop of a turntable). views: after the hull is shown (ViewState::group).
std::vector<unsigned char> findFlatGroups(std::span<const ViewState> views);

/// In the shade under a sherd its plate has grain of its own and the clay's colour, which falls on
/// it off the clay; only the network and the heights tell it from dark clay. For each probability
/// of the network, 0..255: how much odds may say for a sherd where it is dark, heights left aside.
/// That is what the network says where it hardly ever says so of what stands high, and without a
/// limit elsewhere: a network without a notion of dark clay limits nothing.
using ShadeLimit = std::array<float, 256>;
struct ShadeLimits {
  ShadeLimit batch;  ///< from all that is dark and stands high
  /// By view and group of the hull, from what surely stands high there, dark or not; where a
  /// photograph shows too little of a thing, what most of its other photographs say.
  std::vector<std::map<unsigned char, ShadeLimit>> things;
};
/// views: after the hull is shown. reduction: as in hull::HullOptions. of_things: where shadows
/// last; turned on a plate, dark flanks of clay that do not surely stand high would be lost.
ShadeLimits learnShadeLimits(std::span<const ViewState> views, int reduction, bool of_things);
/// index: of the view among those that the limits were learnt from.
void limitInShade(const ShadeLimits& limits, std::size_t index, ViewState& view);

}  // namespace ostraka::mask
