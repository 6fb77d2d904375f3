#pragma once
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPolyData.h>

#include <vector>

#include "cloud/point_cloud.h"
#include "ui/viewport/shading.h"

class vtkMatrix4x4;
class vtkPlane;
class vtkRenderer;

namespace ostraka::ui {

/// A cloud or a mesh as it is drawn: whole, and with fewer points or triangles for while it moves.
class DrawnShape {
 public:
  DrawnShape(vtkRenderer& renderer, Shape shape, Light light = Light::Shaded);

  void clear();
  /// normals: empty where there are none. One colour for each point.
  void setPoints(const std::vector<Eigen::Vector3f>& points,
                 const std::vector<Eigen::Vector3f>& normals, const std::vector<Color>& colours);
  void setMesh(const TriangleMesh& mesh, const std::vector<Color>& colours);
  void setColours(const std::vector<Color>& colours);

  void setVisible(bool visible);
  void setMatrix(vtkMatrix4x4* matrix);
  void setCut(vtkPlane* plane);  ///< null: whole
  void setBandColour(const QColor& colour);
  void setMoving(bool moving);
  void setFrame(const FrameFacts& frame);

  vtkPolyData* data() { return whole_.data; }
  bool empty() { return whole_.data->GetNumberOfPoints() == 0; }

 private:
  struct Level {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void filled(std::size_t parts, std::size_t coarse_parts);
  void choose();

  Shape shape_;
  Light light_;
  Level whole_, coarse_;
  float spacing_mm_ = 0;  ///< median
  bool visible_ = true, moving_ = false, has_coarse_ = false;
};

}  // namespace ostraka::ui
