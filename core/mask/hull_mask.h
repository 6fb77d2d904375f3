#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "mask/masks.h"
#include "rig/camera.h"

namespace ostraka::mask {

struct HullMaskOptions {
  int threads = 1;
};

/// Masks of one thing that all cameras look at, without a plate: the thing is what lies in the
/// middle of the views, looks unlike its surroundings, and agrees over the views as one body.
/// images and photographs as in maskByPlate, unit arbitrary. Errors: UnusableInput, NotEnough,
/// Cancelled.
Result<MaskResult> maskByHull(std::span<const rig::PosedImage> images,
                              std::span<const cv::Mat> photographs, const HullMaskOptions& options,
                              Progress& progress, std::stop_token stop);

}  // namespace ostraka::mask
