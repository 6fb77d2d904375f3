#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "cloud/point_cloud.h"

class vtkCamera;
class vtkRenderer;

namespace ostraka::ui {

using Rgb = std::array<std::uint8_t, 3>;

/// The actors: two clouds, the rim's distances, a mesh, a measured line, a section plane.
class SherdScene {
 public:
  SherdScene();
  ~SherdScene();

  vtkRenderer* renderer();
  vtkRenderer* above();  ///< of the layer above it, with the same camera
  vtkCamera* camera();

  struct Look {
    Rgb background{}, text{}, front_rim{}, back_rim{};
  };
  void setLook(const Look& look);
  void setPixelRatio(double ratio);

  void clear();
  void setFront(const PointCloud& cloud, const std::vector<std::uint8_t>& rim);
  void setBack(const PointCloud& cloud, const std::vector<std::uint8_t>& rim);
  void setPose(const Eigen::Isometry3d& front_from_back);
  void setRim(const std::vector<Eigen::Vector3f>& points, const std::vector<Rgb>& colours);
  void setModel(const TriangleMesh& mesh);
  void setMeasure(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool shown);
  /// The back is drawn this far below the front, for looking between.
  void setApart(bool apart);

  /// Cuts away what lies on the right of the present view, through the middle, and turns the view
  /// so that one looks at the cut. Of the scans only a slice stays. Off: the view is as it was.
  void setSection(bool on);
  bool hasSection() const;
  void moveSection(double mm);

  void resetView();  ///< obliquely from above, everything in sight
  void fitView();    ///< everything in sight, from where one looks
  void prepare();    ///< before each frame
  /// Unit, in the front's frame; away: from the viewer into the picture.
  void viewAxes(double right[3], double up[3], double away[3]) const;

 private:
  struct Actors;
  std::unique_ptr<Actors> actors_;
};

}  // namespace ostraka::ui
