#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "rig/camera.h"

namespace ostraka::calibration {

/// Corners of a calibration target seen in one picture.
struct TargetView {
  std::string file;
  std::vector<Eigen::Vector3d> points;  ///< on the target, mm, z = 0 on a board
  std::vector<Eigen::Vector2d> pixels;  ///< one per point; integer = pixel centre
};

/// A plain grid of markers, as OpenCV's GridBoard draws it: ids row by row from the top left.
struct MarkerGrid {
  std::string dictionary;
  int markers_x = 0, markers_y = 0;
  double marker_mm = 0, gap_mm = 0;
  int first_id = 0;
};

/// Chessboard corners of a ChArUco board (frame: origin top left as drawn, y down); empty points
/// when the board is not there. Saddle points are refined over windows that stay clear of markers.
Result<TargetView> findBoard(const cv::Mat& photograph, const batch::Board& board);

/// Marker corners of a grid of markers, sub-pixel; empty when there is none.
Result<TargetView> findGrid(const cv::Mat& photograph, const MarkerGrid& grid);

/// What a calibration found, and how far it can be trusted.
struct IntrinsicsReport {
  rig::Intrinsics intrinsics;
  std::array<double, 9> sd{};  ///< of fx fy cx cy k1 k2 p1 p2 k3; 0 for a term kept at zero
  double rms_px = 0;
  std::vector<std::string> files;                     ///< of the views that were used
  std::vector<double> rms_per_view_px;                ///< one per file
  std::vector<Eigen::Isometry3d> camera_from_target;  ///< one per file
  std::size_t worst_view = 0;                         ///< index into files
  std::vector<Message> set_aside;  ///< pictures that could not be used, each with its reason
  std::vector<Message> advice;     ///< what is wanting, in words, with what to do; may be empty
  bool focal_determined = false;   ///< sd of the focal length below 1 %
};

/// Plane target calibration (Zhang 2000, OpenCV): square pixels, five distortion terms less those
/// that the views do not determine. Views with fewer than 6 corners are set aside.
/// Errors: NotEnough (fewer than 3 usable views), Failed (no camera explains the views).
Result<IntrinsicsReport> calibrateIntrinsics(std::span<const TargetView> views, int width,
                                             int height);

/// Focal length and k1 from views of the turning plate alone: all of them show one tilt, so the
/// principal point is taken for the picture's centre and square pixels are believed.
/// Errors: as calibrateIntrinsics; one view is enough.
Result<IntrinsicsReport> intrinsicsFromPlate(std::span<const TargetView> views, int width,
                                             int height);

}  // namespace ostraka::calibration
