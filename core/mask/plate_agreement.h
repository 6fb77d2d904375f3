#pragma once
#include <functional>
#include <opencv2/core/mat.hpp>
#include <span>

#include "rig/camera.h"
#include "rig/sheet_bend.h"

namespace ostraka::mask {

/// A photograph's residual against the bare plate (log, 3 channels), where it was taken from, and
/// where the hull shows in it (reduced, 0 = not; a pixel that it does not show sees the plate).
struct PlateView {
  const rig::PosedImage* image = nullptr;
  const cv::Mat3f* residual = nullptr;
  const cv::Mat1b* hull = nullptr;
  int reduction = 4;
  rig::SheetBend bend = {};
  const cv::Mat1b* plate = nullptr;  ///< reduced, 0 where the plate is not known; null: nowhere
};

/// A shadow lies on the plate: the other cameras of the same stop see the same darkening at the
/// same plate point. What stands on the plate is seen in front of another plate point by each
/// camera, so there the residuals differ. Adds the log likelihood ratio of that to `log_odds`,
/// where `allowed` is set and `bare_at` (plate x, y in mm) says that nothing stands on the plate
/// point behind the pixel. A camera in whose view the hull may hide that point is no witness, nor
/// is one for which the plate is not known there: along a sheet's edge the table shines in.
void weighAgreement(const PlateView& view, std::span<const PlateView> others,
                    const std::function<bool(double, double)>& bare_at, const cv::Mat1b& allowed,
                    cv::Mat1f& log_odds);

}  // namespace ostraka::mask
