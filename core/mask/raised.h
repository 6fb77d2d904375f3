#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "batch/batch.h"
#include "rig/camera.h"

namespace ostraka::mask {

/// How much each pixel looks like something above the plate, whatever its colour: the photographs
/// of one stop are laid over each other on planes parallel to the plate (plane sweep, Collins, CVPR
/// 1996), and the plane on which their texture agrees (normalised cross correlation) is where they
/// see a surface. A grey sherd on a grey plate has no colour of its own, but it is not at height 0.
/// images, photographs (CV_8UC3): those of one stop. Returns for each a CV_32FC1 of half its size:
/// log P(agreement | something above the plate) / P(agreement | plate), 0 where nothing can be told
/// (no texture, one photograph only, not above the plate). Shrunk by the correlation's window, so
/// that it does not reach beyond the outline of a sherd of the plate's brightness. The outline of
/// another alone makes windows agree that lie beside it: low odds are no evidence. bend_mm: how far
/// a sheet leaves its plane; so high nothing stands above it.
std::vector<cv::Mat1f> weighHeights(std::span<const rig::PosedImage* const> images,
                                    std::span<const cv::Mat* const> photographs,
                                    const batch::Plate& plate, double max_height_mm,
                                    double bend_mm = 0);

/// The sweep's cells: two pixels of this photograph at the plate's centre, but no finer than the
/// plate's picture is kept. A photograph from near of a part of a large sheet would take gigabytes.
double sweepPitch_mm(const rig::PosedImage& image, const batch::Plate& plate);

/// Such odds in a photograph's own size, less where it is darker than a third of the bare plate and
/// none below a sixth: what lies in so deep a shadow shows no grain, so its windows agree by the
/// outlines beside it. residual: log photograph - log bare plate.
cv::Mat1f heightsInTheLight(const cv::Mat1f& odds, const cv::Mat3f& residual);

}  // namespace ostraka::mask
