#pragma once
#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <optional>
#include <vector>

namespace ostraka::rig {

using Quad = std::array<Eigen::Vector2d, 4>;  ///< pixels, in the order around the marker
Quad toQuad(const std::vector<cv::Point2f>& corners);

/// Corners of a black marker on white paper as the intersections of its four edges, each fitted by
/// a blurred step over all pixels beside it, in linear light (the sRGB curve undone): in stored
/// values a blurred edge seems to lie inside the black, by 0.3 px and more.
/// grey: 8-bit. start: right to 2 px. bits: cells along the marker's side without its border.
/// Nothing when an edge cannot be fitted (too small, too little contrast, outside of the image).
std::optional<Quad> refineByEdges(const cv::Mat& grey, const Quad& start, int bits);

/// By how much each corner moves when all four edges move outwards by one pixel.
Quad outwardPerPixel(const Quad& corners);

}  // namespace ostraka::rig
