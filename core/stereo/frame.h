#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "stereo/stereo.h"

namespace ostraka::stereo {

/// One view at one level of the pyramid: a pinhole without distortion. Lengths in pixels of the
/// level.
struct Frame {
  int width = 0, height = 0;
  int light = 0;  ///< frames of the same number were lit alike: View's stop
  float fx = 0, fy = 0, cx = 0, cy = 0;
  Eigen::Matrix3f rotation;     ///< camera_from_plate
  Eigen::Vector3f translation;  ///< camera_from_plate, mm
  Eigen::Vector3f centre;       ///< the camera's place in the plate's frame, mm
  cv::Mat1f grey;               ///< 1..255; 0 where the photograph does not show the object
  cv::Mat1f coverage;           ///< 0..1, the share of the pixel inside the mask
  /// Four neighbours' grey values (x,y) (x+1,y) (x,y+1) (x+1,y+1) in one word, lowest byte first,
  /// so that one access serves an interpolation; a byte of 0 is outside.
  std::vector<std::uint32_t> packed;

  std::vector<cv::Point> pixels;  ///< those to work on, row by row
  cv::Mat1i index;                ///< place of a pixel in `pixels`, -1 outside

  Eigen::Vector3f ray(float x, float y) const { return {(x - cx) / fx, (y - cy) / fy, 1.0F}; }
  Eigen::Vector3f toCamera(const Eigen::Vector3f& p_plate) const {
    return rotation * p_plate + translation;
  }
  Eigen::Vector2f project(const Eigen::Vector3f& p_camera) const {
    return {fx * p_camera.x() / p_camera.z() + cx, fy * p_camera.y() / p_camera.z() + cy};
  }
  bool holds(const Eigen::Vector2f& pixel) const {
    return pixel.x() >= 0.0F && pixel.y() >= 0.0F && pixel.x() < static_cast<float>(width - 1) &&
           pixel.y() < static_cast<float>(height - 1);
  }
};

/// The frames of one part of a view from the full size (first) to the coarsest; pixels and index
/// are empty. The photograph is the whole one, the part a rectangle of its pixels without
/// distortion.
std::vector<Frame> buildPyramid(const View& view, const cv::Mat& photograph, const cv::Rect& part,
                                int levels);
/// The same of the whole view, with the photograph that it holds.
std::vector<Frame> buildPyramid(const View& view, int levels);

/// What the mask alone tells.
struct Outline {
  Frame frame;             ///< the coarsest of the view's frames, without grey values
  std::int64_t shown = 0;  ///< pixels of the full size inside the mask
};
Outline outlineOf(const View& view, int levels);

}  // namespace ostraka::stereo
