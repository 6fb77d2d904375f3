#pragma once
#include <opencv2/core/mat.hpp>

#include "cloud/point_cloud.h"
#include "rig/camera.h"

namespace ostraka::mask {

/// What a coarse reconstruction of the whole scene shows in a photograph.
enum Shown : unsigned char { kNothingShown = 0, kGroundShown = 1, kRaisedShown = 2 };

/// How far above the ground (z = 0) points of this cloud must lie to be told from it: four SD of
/// the points that lie within `thickness` of it.
double leastRaised(const PointCloud& cloud, double thickness);

/// The nearest points at each pixel of `image`, its neighbours filled: Shown, of the image's size.
/// Points within `least_raised` above the ground, and below it, are the ground. Holes in what is
/// raised are filled: a smooth surface shows nothing that stereo could match.
cv::Mat1b shownBy(const PointCloud& cloud, const rig::PosedImage& image, double least_raised);

/// weighHeights from such a picture, for a photograph of `size`: what is shown, but not along its
/// edges, which are as coarse as the reconstruction.
cv::Mat1f heightsShown(const cv::Mat1b& shown, cv::Size size);

/// 255 where the photograph cannot be trusted to show the bare ground: what is raised and around
/// it.
cv::Mat1b mayBeCovered(const cv::Mat1b& shown);

}  // namespace ostraka::mask
