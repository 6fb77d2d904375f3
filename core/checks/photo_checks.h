#pragma once
#include <span>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "rig/camera.h"

namespace ostraka::checks {

struct PhotoCheckOptions {
  double most_edge_growth = 1.4;  ///< markers' edges wider than the camera's sharpest are a blur
  double wide_edge_px = 0.5;      ///< and wider by this: edges are known to 0.1 px
  /// All of a side are blurred when even its sharpest edge is wider than this once the photographs
  /// have the size that they are used in; sharp ones have 2 to 4 pixels.
  double widest_sharp_px = 6;
  double megapixels = 5;        ///< that size, at most
  double most_left_out = 0.25;  ///< of a side's photographs, for a blur; more of them stay in use
  double least_step = 30;       ///< grey values from a marker's black to its paper, of 255
  double most_covered = 0.1;    ///< share of the markers that no photograph of a side shows
  /// Photographs by hand: PosedImage::camera counts them, those of one size are one camera's.
  bool one_camera = false;
  int threads = 0;
};

struct PhotoFindings {
  std::vector<Message> warnings;    ///< sentences that name the files
  std::vector<std::size_t> spoilt;  ///< by index of images, rising: better left out
};

/// What is wrong with the photographs: which are blurred (masks and stereo are worse with them than
/// without), and which markers are covered through a whole side. Errors: a photograph that cannot
/// be read, Cancelled.
Result<PhotoFindings> checkPhotographs(std::span<const rig::PosedImage> images,
                                       const batch::Plate& plate, const PhotoCheckOptions& options,
                                       std::stop_token stop);

}  // namespace ostraka::checks
