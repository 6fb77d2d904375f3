#pragma once
#include <Eigen/Geometry>

#include "paper/sheet.h"
#include "texture/texture.h"

namespace ostraka::drawing {

enum class Surface {
  Relief,  ///< light and shade of the form alone
  Painted  ///< and the brightness of its photographs or colours: paint, slip, temper
};

struct ViewOptions {
  double scale = 1;           ///< mm on paper per mm
  double pixels_per_mm = 12;  ///< on paper; about 300 dots per inch, fewer where it is very large
  Surface surface = Surface::Relief;
  /// Of the same sherd, shown where it is painted instead of the colours at the mesh's vertices.
  const texture::TexturedMesh* photographs = nullptr;
};

/// A sherd seen along -x of the view's frame, z up, y to the right: a shaded picture, light from
/// the upper left, and its outline as a vector path. On paper, mm, y down; the frame's origin at
/// (0, 0).
struct SherdView {
  Sheet sheet;
  Eigen::AlignedBox2d box;  ///< of the outline, on paper
};
SherdView drawView(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                   const ViewOptions& options);

}  // namespace ostraka::drawing
