#pragma once
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "batch/batch.h"
#include "paper/sheet.h"

namespace ostraka::rig {

/// The black cells of a picture as closed lines along the cells' edges, in cells from the upper
/// left corner; to be filled by the even-odd rule. One shape: no seams between cells.
/// cells: 8-bit, below 128 is black.
std::vector<std::vector<Eigen::Vector2d>> outlinesOfInk(const cv::Mat& cells);

/// A ChArUco board as OpenCV draws and reads it: mm from the upper left corner of its squares.
/// The board's dictionary must be known.
std::vector<Shape> boardInk(const batch::Board& board);

}  // namespace ostraka::rig
