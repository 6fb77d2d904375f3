#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "cloud/point_cloud.h"
#include "ui/viewport/shown_texture.h"

class vtkCamera;
class vtkRenderer;

namespace ostraka::ui {

class DistanceScale;

/// A scan to be shown: its points with the fracture marked.
struct ShownScan {
  PointCloud cloud;
  std::vector<std::uint8_t> fracture;
  std::vector<int> strip_point;  ///< which of the distances a point has; -1, or empty: none
};

/// How one looks at a sherd: which way, and how large it is seen.
struct ViewPose {
  Eigen::Matrix3d view_from_front = Eigen::Matrix3d::Identity();  ///< right, up, to the viewer
  double half_height_mm = 0;  ///< of the picture: views of one height have one scale
};

/// The actors: two clouds, a mesh, a measured line, a section plane.
class SherdScene {
 public:
  SherdScene();
  ~SherdScene();

  vtkRenderer* renderer();
  vtkRenderer* above();  ///< of the layer above it, with the same camera
  vtkCamera* camera();

  void setPixelRatio(double ratio);

  void clear();
  void setSides(const ShownScan& front, const ShownScan& back);
  void setPose(const Eigen::Isometry3d& front_from_back);
  /// The points that have a distance in its colour, unshaded so that it can be read; NaN: 'not
  /// seen'. Empty: the fracture has the colours of the sides.
  void setDistances(const std::vector<float>& front_mm, const std::vector<float>& back_mm,
                    const DistanceScale& scale);
  void setModel(const TriangleMesh& mesh, const ShownTexture& texture);
  void setMeasure(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool shown);
  /// The back is drawn this far below the front, for looking between.
  void setApart(bool apart);

  /// Cuts away what lies on the right of the present view, through the middle, and turns the view
  /// so that one looks at the cut. Off: the view is as it was.
  void setSection(bool on);
  bool hasSection() const;
  void moveSection(double mm);

  /// While it moves fewer points and triangles are drawn, where there are many.
  void setMoving(bool moving);
  void resetView();  ///< obliquely from above, everything in sight
  void fitView();    ///< everything in sight, from where one looks
  void prepare();    ///< before each frame
  /// Unit, in the front's frame; away: from the viewer into the picture.
  void viewAxes(double right[3], double up[3], double away[3]) const;
  ViewPose viewPose() const;
  void setViewPose(const ViewPose& pose);  ///< what is in the middle stays there

 private:
  struct Actors;
  std::unique_ptr<Actors> actors_;
};

}  // namespace ostraka::ui
