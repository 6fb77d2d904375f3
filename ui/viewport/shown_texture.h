#pragma once
#include <Eigen/Core>
#include <QImage>
#include <vector>

namespace ostraka::ui {

/// A picture on a mesh. Without a place for each vertex the mesh is shown in its own colours.
struct ShownTexture {
  QImage picture;                   ///< sRGB; null: none
  std::vector<Eigen::Vector2f> uv;  ///< per vertex, 0..1 from the picture's top left corner
};

}  // namespace ostraka::ui
