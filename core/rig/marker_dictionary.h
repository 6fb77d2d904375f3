#pragma once
#include <Eigen/Core>
#include <array>
#include <opencv2/aruco.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "paper/sheet.h"

/// Markers as OpenCV has them, and their ink on paper.
namespace ostraka::rig {

/// OpenCV's predefined dictionary by its name, as DICT_4X4_100. Errors: UnusableInput.
Result<cv::Ptr<cv::aruco::Dictionary>> markerDictionary(const std::string& name);

/// The black cells of a picture as closed lines along the cells' edges, in cells from the upper
/// left corner; to be filled by the even-odd rule. One shape: no seams between cells.
/// cells: 8-bit, below 128 is black.
std::vector<std::vector<Eigen::Vector2d>> outlinesOfInk(const cv::Mat& cells);

/// corners: on the paper, mm, in the order around the marker as OpenCV gives them.
Shape markerInk(const cv::Ptr<cv::aruco::Dictionary>& dictionary, int id,
                const std::array<Eigen::Vector2d, 4>& corners);

/// A ChArUco board as OpenCV draws and reads it: mm from the upper left corner of its squares.
/// The board's dictionary must be known.
std::vector<Shape> boardInk(const batch::Board& board);

}  // namespace ostraka::rig
