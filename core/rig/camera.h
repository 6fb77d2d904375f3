#pragma once
#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::rig {

/// A pinhole with OpenCV's five distortion terms k1 k2 p1 p2 k3. A pixel's centre has integer
/// coordinates; axes x right, y down, z forward.
struct Intrinsics {
  int width = 0, height = 0;
  double fx = 0, fy = 0, cx = 0, cy = 0;
  std::array<double, 5> distortion{};

  /// Pixel of a point in the camera frame, mm, with z > 0.
  Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const;
  /// Normalised image coordinates (x/z, y/z) of a pixel: the inverse of project, to 1e-9.
  Eigen::Vector2d unproject(const Eigen::Vector2d& pixel) const;
  bool hasDistortion() const;
};

/// The same camera with its pictures averaged down to this size. Pixels cover areas: a point at x
/// comes to (x + 0.5) width / old width - 0.5. The distortion is free of pixels and stays.
Intrinsics reduced(const Intrinsics& camera, int width, int height);
/// The same for pictures of so many millions of pixels; itself where it has no more.
Intrinsics reducedTo(const Intrinsics& camera, double megapixels);

/// A rotation as its axis times its angle, radians, then the shift: what adjustments turn.
using PoseBlock = std::array<double, 6>;
PoseBlock toBlock(const Eigen::Isometry3d& pose);
Eigen::Isometry3d poseFrom(const PoseBlock& block);

/// A photograph with its camera and pose: x_camera = camera_from_plate * x_plate.
struct PosedImage {
  std::string file;  ///< as named in its JSON, or the photograph's path
  batch::Side side = batch::Side::Front;
  int camera = 0, stop = 0;
  Intrinsics intrinsics;
  Eigen::Isometry3d camera_from_plate = Eigen::Isometry3d::Identity();

  Eigen::Vector2d project(const Eigen::Vector3d& p_plate) const {
    return intrinsics.project(camera_from_plate * p_plate);
  }
  Eigen::Vector3d centre() const { return camera_from_plate.inverse().translation(); }
};

/// The file of a photograph's mask, named as the photograph: cam0_pos00.png.
std::string maskName(const PosedImage& image);

/// {"unit":"mm","images":[{"file","width","height","K","dist","R","t"[,"side","camera","stop"]}]},
/// x_cam = R X + t. dist may hold 0, 4 or 5 numbers.
Result<std::vector<PosedImage>> readCameras(const std::filesystem::path& file);
Result<void> writeCameras(const std::filesystem::path& file, const std::vector<PosedImage>& images);

}  // namespace ostraka::rig
