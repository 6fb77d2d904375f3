#pragma once
#include <optional>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "checks/known_scale.h"
#include "colmap/colmap_program.h"
#include "rig/camera.h"

namespace ostraka::checks {

/// Lengths that are stated in mm in this program follow from a pixel's size on the object. Without
/// a known length a side is scaled so that a pixel is this long there: between the paper's
/// photographs (0.15 mm) and twelve megapixels less (0.24 mm).
constexpr double kNominalPixel_mm = 0.2;

/// Factor to that size: the median pixel at the points, over the images that look at them; 1 when
/// there is none.
double nominalScale(const colmap::ColmapPoses& poses);

/// mm per unit of one side's poses: from the lengths marked in scale.json, else from the board of
/// board.json lying on the plate in the photographs. Nothing where neither gives one.
/// Errors: Cancelled, and those of the photographs.
Result<std::optional<KnownScale>> knownScale(const batch::Batch& batch, batch::Side side,
                                             const colmap::ColmapPoses& poses, int threads,
                                             std::stop_token stop);

/// All lengths of one side's poses times `factor`.
void resizeSide(std::vector<rig::PosedImage>& images, batch::Side side, double factor);

/// The sentence that report and terminal must show for such a batch.
Message noScaleWarning();

}  // namespace ostraka::checks
