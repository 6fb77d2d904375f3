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
  cv::Mat1b shown;              ///< 0: beyond the photograph, of which it says nothing; empty: none
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
  /// Whether the photograph shows what is at this place.
  bool shows(const Eigen::Vector2f& pixel) const {
    return holds(pixel) && (shown.empty() || shown(static_cast<int>(pixel.y() + 0.5F),
                                                   static_cast<int>(pixel.x() + 0.5F)) != 0);
  }
};

/// A part of a photograph as a pinhole with the camera's focal lengths shows it.
class StraightPart {
 public:
  /// part: in the photograph's pixels, on which a pinhole's lie; it may reach beyond them.
  StraightPart(const rig::Intrinsics& camera, const cv::Rect& part);
  /// Of a picture of the photograph's size. border: what is taken for what it does not show, as
  /// cv::remap says; 0 if constant.
  cv::Mat of(const cv::Mat& picture, int interpolation, int border) const;

 private:
  cv::Rect part_;
  // Where the part's pixels lie in the photograph; empty: in the same place.
  cv::Mat map_x_, map_y_;
};

/// The part with all that the view shows of the object: the photograph's rectangle and, where the
/// lens drew what lies beyond it into the photograph, as much more, by whole pixels of all levels.
/// At most a photograph's width and height more on each side (a fisheye's rim goes on for ever).
cv::Rect wholeOf(const View& view);

/// The frames of one part of a view from the full size (first) to the coarsest; pixels and index
/// are empty. The photograph is the whole one, the part as of StraightPart.
std::vector<Frame> buildPyramid(const View& view, const cv::Mat& photograph, const cv::Rect& part,
                                int levels);
/// The same of wholeOf(view), with the photograph that it holds.
std::vector<Frame> buildPyramid(const View& view, int levels);

/// What the mask alone tells.
struct Outline {
  cv::Rect whole;          ///< of the view
  Frame frame;             ///< the coarsest of its frames, without grey values
  std::int64_t shown = 0;  ///< pixels of the full size inside the mask
};
Outline outlineOf(const View& view, int levels);

}  // namespace ostraka::stereo
