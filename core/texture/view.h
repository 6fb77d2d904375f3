#pragma once
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "batch/batch.h"
#include "cloud/point_cloud.h"
#include "rig/camera.h"

namespace ostraka::texture {

/// What one photograph shows of one sherd: the part of it around the sherd, at full resolution.
struct View {
  cv::Mat3b picture;                   ///< BGR as photographed
  cv::Mat1b mask;                      ///< of the same size; below 128: not this sherd
  double mask_step = 1;                ///< pixels of the photograph to one of the mask it came from
  Eigen::Vector2i corner{0, 0};        ///< the part's first pixel in the photograph
  rig::Intrinsics intrinsics;          ///< of the whole photograph
  Eigen::Isometry3d camera_from_mesh;  ///< mm
  double reach = 0;  ///< the farthest that the photograph shows off its axis, x / z; beyond it a
                     ///< lens model may fold back into the picture
  int photograph = 0;  ///< counted over the batch
  /// Of the mesh's normals, where the lights stand still (light.h).
  Eigen::Matrix3d light_from_mesh = Eigen::Matrix3d::Identity();

  /// Whether a point in the camera's frame, mm, lies where the lens model holds.
  bool isInSight(const Eigen::Vector3d& in_camera) const {
    return in_camera.z() > 0 && in_camera.head<2>().norm() <= reach * in_camera.z();
  }

  /// Pixel within the part of a point in front of the camera, mesh frame, mm.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const {
    return intrinsics.project(camera_from_mesh * point) - corner.cast<double>();
  }
  Eigen::Vector3d centre() const { return camera_from_mesh.inverse().translation(); }
};

/// The part of a photograph that shows the points, cut out (copied). photograph: 8-bit BGR, maybe
/// larger than the image's camera and the mask say, whose pixels then are taken to its size; mask
/// below 128: no sherd. mesh_from_plate: where the image's plate frame lies. points: of the sherd,
/// its tips to 2.5 mm. Nothing where neither photograph nor mask shows any of them.
std::optional<View> cutOut(const cv::Mat3b& photograph, const cv::Mat1b& mask,
                           const rig::PosedImage& image, const Eigen::Isometry3d& mesh_from_plate,
                           const std::vector<Eigen::Vector3f>& points);

/// Takes out of the mask what other sherds hide, or show in this one's place. own, others: points
/// about 1.5 mm apart, camera frame, mm.
void hideOthers(View& view, const std::vector<Eigen::Vector3d>& own,
                const std::vector<Eigen::Vector3d>& others);

/// A pixel's edge on the mesh, mm, in the photograph that was taken from nearest; 0 without views.
double finestPixel_mm(const TriangleMesh& mesh, const std::vector<View>& views);

/// How far off the mesh is at each pixel of a part, so that a point behind it is known.
class DepthMap {
 public:
  DepthMap(const TriangleMesh& mesh, const View& view);
  /// Whether nothing lies in front of a point that View::project brings to `pixel` at `depth_mm`;
  /// cosine: of its normal to the line of sight.
  bool sees(const Eigen::Vector2d& pixel, double depth_mm, double cosine) const;

 private:
  int stride_ = 1;
  double pixel_mm_ = 0;  ///< a cell's edge at the mesh
  cv::Mat1f nearest_;    ///< mm, the least within a cell around
};

}  // namespace ostraka::texture
