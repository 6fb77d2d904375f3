#pragma once
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "paper/sheet.h"
#include "texture/texture.h"

namespace ostraka::drawing {

enum class Surface {
  Relief,     ///< light and shade of the form alone
  Painted,    ///< and the brightness of its photographs or colours: paint, slip, temper
  Orthophoto  ///< its photographs, or the colours at its vertices, in parallel projection as they
              ///< are: no light is added, no outline drawn
};

constexpr double kMmPerInch = 25.4;
/// Of pictures on paper, dots per inch: what publishers ask of photographs, and of line drawings.
enum class Dpi { Usual = 300, Fine = 600 };

struct ViewOptions {
  double scale = 1;      ///< mm on paper per mm
  Dpi dpi = Dpi::Usual;  ///< fewer where it is very large
  Surface surface = Surface::Relief;
  /// Of the same sherd, shown instead of the colours at the mesh's vertices.
  const texture::TexturedMesh* photographs = nullptr;
};

/// The picture of a view on white, in grey or, of an orthophoto, in BGR.
struct ViewPicture {
  cv::Mat pixels;
  Eigen::Vector2d corner;  ///< upper left on paper, mm, y down; the frame's origin at (0, 0)
  int dpi = 0;

  Eigen::Vector2d size_mm() const;  ///< on paper
};
/// A sherd in parallel projection along -x of the view's frame, z up, y to the right; light from
/// the upper left where it is shaded.
ViewPicture pictureOf(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                      const ViewOptions& options);

/// The same on a sheet, with its outline as a vector path where it is shaded.
struct SherdView {
  Sheet sheet;
  Eigen::AlignedBox2d box;  ///< of the outline, on paper
};
SherdView drawView(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                   const ViewOptions& options);

}  // namespace ostraka::drawing
