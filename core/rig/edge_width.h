#pragma once
#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace ostraka::rig {

/// Widths in pixels of a marker's black-to-paper edges, at three places of each of its four sides:
/// contrast over the steepest slope. Small is sharp. A place where there is no edge, or that is not
/// on the picture, gives none.
/// corners: pixels, in the order around the marker as OpenCV gives them.
std::vector<double> edgeWidths(const cv::Mat1b& grey,
                               const std::array<Eigen::Vector2d, 4>& corners);

/// The median of these over many markers; 0 where fewer than 12 places have an edge.
double typicalWidth(std::vector<double> widths);

}  // namespace ostraka::rig
