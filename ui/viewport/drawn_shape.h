#pragma once
#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

#include <vector>

#include "cloud/point_cloud.h"
#include "ui/viewport/shading.h"
#include "ui/viewport/shown_texture.h"

class vtkMatrix4x4;
class vtkPlane;
class vtkRenderer;

namespace ostraka::ui {

/// A cloud or a mesh as it is drawn: whole, and with fewer points or triangles for while it moves.
class DrawnShape {
 public:
  DrawnShape(vtkRenderer& renderer, Shape shape);

  void clear();
  /// normals: empty where there are none. One colour for each point.
  void setPoints(const std::vector<Eigen::Vector3f>& points,
                 const std::vector<Eigen::Vector3f>& normals, const std::vector<Color>& colours);
  /// The colours are those of the mesh without a texture, and while it moves.
  void setMesh(const TriangleMesh& mesh, const std::vector<Color>& colours,
               const ShownTexture& texture);
  void setColours(const std::vector<Color>& colours);
  void setLight(Light light);  ///< at first Shaded

  void setVisible(bool visible);
  void setMatrix(vtkMatrix4x4* matrix);
  void setCut(vtkPlane* plane);  ///< null: whole
  void setBandColour(const QColor& colour);
  void setMoving(bool moving);
  /// Before each frame, with the renderer's context.
  void setFrame(const FrameFacts& frame);

  vtkPolyData* data() { return whole_.data; }
  bool empty() { return whole_.data->GetNumberOfPoints() == 0; }

 private:
  struct Level {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void setTexture(const ShownTexture& texture);
  void dropTexture();
  void filled(std::size_t parts, std::size_t coarse_parts);
  void choose();

  vtkRenderer& renderer_;
  Shape shape_;
  Level whole_, coarse_;
  vtkNew<vtkImageData> picture_;  ///< empty: no texture
  vtkNew<vtkTexture> texture_;    ///< of the whole level: places on it have no meaning between
                                  ///< vertices that the coarse one joins
  float spacing_mm_ = 0;          ///< median
  bool visible_ = true, moving_ = false, has_coarse_ = false;
};

}  // namespace ostraka::ui
