#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"
#include "rig/camera.h"

namespace ostraka::review {

/// A raster over a frame's x and y: the middle of pixel (column, row) lies at
/// low_mm + px_mm * (column + 0.5, height - row - 0.5). Row 0 is on top: +y goes up.
struct PictureFrame {
  Eigen::Vector2d low_mm = Eigen::Vector2d::Zero();
  double px_mm = 0.2;
  int width = 0, height = 0;

  Eigen::Vector2d at(double column, double row) const {
    return low_mm + px_mm * Eigen::Vector2d(column + 0.5, height - row - 0.5);
  }
};

/// The frame around points, with a margin.
PictureFrame frameAround(std::span<const Eigen::Vector3f> points, double px_mm, double margin_mm);

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< row by row; alpha 0 beside the sherd; empty: no picture
};

enum class Facing { Up, Down };  ///< which of the points are seen: those on top, or those below

/// The photograph as seen straight along z of the frame: each pixel looks up the scan's height
/// there. Facing::Down gives the lower face as if seen through from above, so mirrored. points: in
/// the frame; plate_from_frame: to the photograph's plate. mask: coverage as the photograph; empty:
/// the scan's footprint cuts out.
Picture orthophoto(const cv::Mat& photograph, const cv::Mat1b& mask, const rig::PosedImage& image,
                   std::span<const Eigen::Vector3f> points,
                   const Eigen::Isometry3d& plate_from_frame, Facing facing,
                   const PictureFrame& frame);

/// The points themselves in their colours (or shaded grey), for scans without a photograph; a point
/// fills the gaps to its neighbours. frame_from_cloud brings them into the frame.
Picture pointPicture(const PointCloud& cloud, const Eigen::Isometry3d& frame_from_cloud,
                     Facing facing, const PictureFrame& frame);

}  // namespace ostraka::review
