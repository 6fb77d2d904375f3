#pragma once
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "hull/hull.h"

namespace ostraka::mask {

/// What maskByPlate keeps of each photograph between the two passes, small enough for a whole side.
struct ViewState {
  cv::Mat3f residual;  ///< half the memory would do; 23 MB at 1600 x 1200
  cv::Mat1f log_odds;
  cv::Mat1f height_odds;  ///< half size, see weighHeights
  hull::HullView hull;
  cv::Mat1b probability;  ///< reduced: of sherd by the network, 0..255
  cv::Mat1b group;        ///< reduced: which group's hull shows
  cv::Mat1f depth;        ///< reduced: mm of hull behind it
  cv::Mat1f below;        ///< reduced: voxels from the floor up to the hull that it shows
  cv::Mat1b allowed;      ///< where a sherd may be
  cv::Mat1b plate;        ///< reduced: the plate inside the markers
  cv::Mat1b ink;          ///< 255 before a printed sheet's ink; empty before other plates
};

/// What maskByPlate's passes over a photograph take, as parts of one another: against the bare
/// plate, on planes, by the network, the hull carved and shown, other views, colours, the outline.
inline constexpr std::int64_t kWeigh = 4, kSweep = 1, kLook = 4, kCarve = 1, kShow = 1, kAsk = 1,
                              kLearn = 1, kCut = 3;
inline constexpr std::int64_t kOnce =
    kWeigh + kSweep + kLook + kCarve + kShow + kAsk + kLearn + kCut;
inline constexpr std::int64_t kAgain = kCarve + kShow + kCut;  ///< where shadows last on a sheet

/// Share of each cell that looks like a sherd, 0..1; so many pixels are a cell's side.
cv::Mat1f insideOf(const cv::Mat1f& log_odds, int reduction);
/// How much odds for a sherd count where the hull is carved, 0..1, in cells of a picture this
/// large.
cv::Mat1f sharesOf(const cv::Mat1f& odds, cv::Size size);

/// The view as its mask has it, to carve a hull anew.
hull::HullView hullViewOf(const ViewState& view, const cv::Mat1b& mask);

/// What stands above the plate (weighHeights, half size) speaks for a sherd.
void addHeights(ViewState& view, const cv::Mat1f& odds);

}  // namespace ostraka::mask
