#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"
#include "rig/camera.h"
#include "rig/sheet_bend.h"

namespace ostraka::mask {

/// What a coarse reconstruction of the whole scene shows in a photograph.
enum Shown : unsigned char { kNothingShown = 0, kGroundShown = 1, kRaisedShown = 2 };

/// How far each point lies above the ground, z = 0 but for its bend.
std::vector<float> heightsAbove(const PointCloud& cloud, const rig::SheetBend& bend);

/// How far above the ground points must lie to be told from it: four of its SD. Taken from the
/// points that lie below it, down to `thickness`: those above may be of thin sherds, however many.
double leastRaised(std::span<const float> heights, double thickness);

/// The nearest points at each pixel of `image` and its neighbours: Shown, of the image's size.
/// heights: heightsAbove. Points within `least_raised` of the ground, and below it, are the ground.
/// Gaps::Filled: so are the gaps between points of one kind, and holes in what is raised, for a
/// smooth surface shows nothing that stereo could match; Gaps::Left: only what points say.
enum class Gaps { Filled, Left };
cv::Mat1b shownBy(const PointCloud& cloud, std::span<const float> heights,
                  const rig::PosedImage& image, double least_raised, Gaps gaps);

/// weighHeights from such a picture, for a photograph of `size`: what is shown, but not along its
/// edges, which are as coarse as the reconstruction.
cv::Mat1f heightsShown(const cv::Mat1b& shown, cv::Size size);

/// 255 in the cells of a grid before which `shown` has something raised. pixel_of_cell: where a
/// photograph of `size` shows each.
cv::Mat1b coveredCells(const cv::Mat1b& shown, cv::Size size, const cv::Mat2f& pixel_of_cell);

}  // namespace ostraka::mask
