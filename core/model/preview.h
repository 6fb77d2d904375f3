#pragma once
#include <Eigen/Geometry>
#include <functional>
#include <opencv2/core.hpp>

#include "cloud/point_cloud.h"

namespace ostraka::model {

struct PreviewOptions {
  int width_px = 480, height_px = 480;  ///< of one view
  double margin = 0.06;                 ///< of the picture, free on each side
  Color clay = {188, 176, 160};         ///< for meshes without colours
  Color background = {255, 255, 255};
  Color filled = {220, 120, 40};  ///< faces that no camera saw
  /// Colour (red, green, blue, 0..255) at a place of a triangle, by the weights of its corners;
  /// empty: that of the mesh's vertices.
  std::function<Eigen::Vector3d(const std::array<int, 3>&, const std::array<double, 3>&)> color_at =
      {};
};

/// An orthographic, shaded picture (BGR, 8 bit) along view_from_model's -z axis (the viewer looks
/// down z, x to the right, y up), scaled to fill it. Same bytes on every run.
cv::Mat renderView(const TriangleMesh& mesh, const Eigen::Matrix3d& view_from_model,
                   const PreviewOptions& options);

/// Front, back and the edge of a sherd lying in the plate's plane, side by side, at one scale, on
/// no ground: BGRA, so that it stands on paper, on a dark matte and in a chosen row alike.
cv::Mat renderPreview(const TriangleMesh& mesh, const PreviewOptions& options);

}  // namespace ostraka::model
