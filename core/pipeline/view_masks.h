#pragma once
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mask/masks.h"
#include "rig/camera.h"

namespace ostraka::pipeline {

/// Masks of one side's photographs by hand where no marker tells what sherds lie on. With a ground
/// (Poses::grounds) a coarse reconstruction of all that the photographs show tells what stands on
/// it, and the ground's picture is what lies bare; without one the masks are those of the one body
/// in the middle that all photographs agree on (maskByHull). Errors: as maskByPlate and maskByHull.
Result<mask::MaskResult> masksFromViews(const std::vector<rig::PosedImage>& images,
                                        const std::vector<cv::Mat>& photographs,
                                        const std::optional<Eigen::AlignedBox2d>& ground,
                                        int threads, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace ostraka::pipeline
