#pragma once
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mask/masks.h"
#include "pipeline/process_batch.h"
#include "rig/camera.h"
#include "rig/sheet_bend.h"

namespace ostraka::pipeline {

/// What sherds lie on: z = 0 but for its bend.
struct Ground {
  Eigen::AlignedBox2d extent;  ///< mm
  rig::SheetBend bend;
  bool printed = false;  ///< its print tells, too, what lies bare: a reconstruction is asked only
                         ///< for what it surely shows
};

/// Millions of pixels that the coarse reconstruction sees of a photograph, in a run that works on
/// so many: half a million are enough to tell a sherd of 5 mm height from a table. Drafts
/// (kDraftMegapixels) see half as many, in half the time: of batches/hand they cost 0.002 of the
/// masks' IoU (docs/experiments.md). They see no fewer photographs: of twenty by hand every second
/// is seen anyhow, and of every third no two would lie within stereo's angles.
double coarseMegapixels(double megapixels);

struct CoarseOptions {
  int threads = 1;
  double megapixels = coarseMegapixels(kUsualMegapixels);
};

/// What stands on the ground, photograph by photograph, as a coarse reconstruction of all that lies
/// there shows it without masks (mask::Shown). Errors: as stereo::reconstruct.
Result<std::vector<cv::Mat1b>> shownOn(const Ground& ground,
                                       const std::vector<rig::PosedImage>& images,
                                       const std::vector<cv::Mat>& photographs,
                                       const CoarseOptions& options, Progress& progress,
                                       const std::stop_token& stop);

/// Masks of one side's photographs by hand where no marker tells what sherds lie on. With a ground
/// (Poses::grounds) a coarse reconstruction of all that the photographs show tells what stands on
/// it, and the ground's picture is what lies bare; without one the masks are those of the one body
/// in the middle that all photographs agree on (maskByHull). Errors: as maskByPlate and maskByHull.
Result<mask::MaskResult> masksFromViews(const std::vector<rig::PosedImage>& images,
                                        const std::vector<cv::Mat>& photographs,
                                        const std::optional<Eigen::AlignedBox2d>& ground,
                                        const CoarseOptions& options, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace ostraka::pipeline
