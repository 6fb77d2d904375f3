#pragma once
#include "stereo/frame.h"

namespace ostraka::stereo {

/// The samples of a reference pixel's window: places relative to the pixel, weights, grey values.
/// Filled up to whole groups of lanes with samples of weight 0.
struct Window {
  static constexpr int kLanes = 8;
  static constexpr int kMaxSamples = 128;
  alignas(32) float dx[kMaxSamples];
  alignas(32) float dy[kMaxSamples];
  alignas(32) float weight[kMaxSamples];
  alignas(32) float grey[kMaxSamples];  ///< less the pixel's own value
  int samples = 0;                      ///< a multiple of kLanes
  float total_weight = 0;
  float base = 0;  ///< the pixel's own value
};

/// The window around a pixel: a disc of radius 3, whose weights fall off as a Gaussian of SD 2
/// pixels. False where too little of it shows the object.
bool cutWindow(const Frame& frame, int x, int y, Window& window);

/// Where a window's samples lie in another frame: (x0 + xx dx + xy dy, y0 + yx dx + yy dy).
struct AffineMap {
  float x0, y0, xx, xy, yx, yy;
};

/// 1 - the weighted correlation of both windows, 0..2, invariant to gain and offset; samples
/// outside either mask do not count. Negative where too few count. Branch-free over the samples.
float dissimilarity(const Window& window, const Frame& other, const AffineMap& map);

}  // namespace ostraka::stereo
