#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "mask/masks.h"
#include "rig/camera.h"
#include "rig/sheet_bend.h"

namespace ostraka::mask {

inline constexpr double kTallest_mm = 320;  ///< as much as a plate is wide

struct PlateMaskOptions {
  int threads = 1;
  double height_mm = 80;  ///< of the space that the visual hull is carved from; doubled while
                          ///< something reaches its top, up to kTallest_mm
  double min_sherd_area_mm2 =
      25;               ///< smaller things are crumbs: a sherd of 5 x 5 mm has no contour
  rig::SheetBend bend;  ///< of a printed sheet (Plate::sheet)
  /// Per photograph, of any size (Shown), or empty: what a coarse reconstruction of all that is
  /// there shows. Needed where the plate has no markers: its picture is then what lies bare.
  std::vector<cv::Mat1b> shown;
};

/// Masks of one side from the marker plate: a round one that turns below cameras at rest, or a
/// printed sheet (Plate::sheet) that photographs look down on from anywhere. On a sheet sherds may
/// lie on the markers; what lies beyond its edge is none.
/// images: cameras and poses, plate frame, mm; photographs: CV_8UC3 (BGR), one per image, same size
/// as its intrinsics say. empty_photographs: the bare plate at one of the stops, indexed
/// by PosedImage::camera; the span or single Mats may be empty. A photograph whose empty partner
/// does not fit the pose is masked without it, with a warning. Errors: UnusableInput (sizes,
/// counts), NotEnough (no sherd found, fewer than 3 images), Cancelled.
Result<MaskResult> maskByPlate(std::span<const rig::PosedImage> images,
                               std::span<const cv::Mat> photographs, const batch::Plate& plate,
                               std::span<const cv::Mat> empty_photographs,
                               const PlateMaskOptions& options, Progress& progress,
                               std::stop_token stop);

}  // namespace ostraka::mask
