#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "batch/batch.h"
#include "rig/camera.h"
#include "scan/scan.h"

namespace ostraka::checks {

/// A sherd that was pushed while its side was photographed.
struct MovedSherd {
  std::string scan;   ///< its id
  int from_stop = 0;  ///< the first stop at which it lies elsewhere
  double by_mm = 0;
};

struct StillnessOptions {
  double least_move_mm = 1.0;  ///< smaller ones spoil little, and masks are not that sure
  double least_gain = 4;       ///< how much better a push must explain the masks (sum of squares)
  int least_views = 8;         ///< that show the sherd apart from others
  int least_beyond = 3;        ///< of them before a push and after it, one stop of three cameras
  double own_share = 0.95;     ///< of the scans' points on a patch of a mask that are this sherd's
  int threads = 0;
};

/// Looks at where each sherd lies on the photographs' masks against where its scan says: that
/// differs by a constant, by what stereo misses at the edges (alike for a camera wherever the plate
/// stands), and for a sherd that was pushed by a step from one stop on. images and masks belong to
/// one side, plate frame, +Z up; scans to the same. Linear in the photographs' pixels.
std::vector<MovedSherd> findMoved(std::span<const rig::PosedImage> images,
                                  std::span<const cv::Mat1b> masks,
                                  std::span<const scan::Scan> scans,
                                  const StillnessOptions& options);

/// What a person is told of one. photograph: the first one after the push where each has its own
/// camera pose; else empty, and the turntable's position is named.
Message movedWarning(const MovedSherd& sherd, batch::Side side, const std::string& photograph);

}  // namespace ostraka::checks
