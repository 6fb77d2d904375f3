#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"
#include "rig/camera.h"

namespace ostraka::scan {

/// The things that pieces of a side's surface belong to, by the outlines of its masks: two pieces
/// that show within one outline in nearly all photographs are parts of one thing, between which
/// stereo found nothing; of things beside each other some photographs show the gap. Each piece gets
/// the number of the largest piece of its thing, mostly its own. pieces: at least one point each,
/// plate frame. masks: as many as images, of their sizes, >= 128 inside; without any all pieces are
/// things of their own.
std::vector<std::size_t> thingsOf(std::span<const PointCloud> pieces,
                                  std::span<const rig::PosedImage> images,
                                  std::span<const cv::Mat1b> masks);

}  // namespace ostraka::scan
