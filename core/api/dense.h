#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/points_and_meshes.h"
#include "version.h"

namespace ostraka::api {

/// A photograph with its camera. A pixel's centre has integer coordinates; camera axes are x right,
/// y down, z forward.
struct DensePhotograph {
  int width = 0, height = 0;           ///< pixels
  std::span<const std::uint8_t> rgb;   ///< 3 * width * height, sRGB, rows from the top
  std::span<const std::uint8_t> mask;  ///< width * height, 0 = background, 255 = object; or empty:
                                       ///< what is lit before a dark background is the object
  double fx = 0, fy = 0, cx = 0, cy = 0;  ///< pixels
  /// OpenCV's k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4; of a fisheye k1 k2 k3 k4.
  std::array<double, 12> distortion{};
  Eigen::Isometry3d camera_from_world = Eigen::Isometry3d::Identity();  ///< mm
  bool fisheye = false;  ///< whether distortion is of cv::fisheye
};

struct DenseCloud {
  PointCloud cloud;            ///< world frame, mm; normals, colours, and quality 0..1
  double confirmed_share = 0;  ///< of the depths, those that another photograph bears out, 0..1
  bool plausible = false;      ///< false: the cameras cannot be those of these photographs
};

/// The surface in at least 3 photographs with known cameras, as oriented, coloured points: `ostraka
/// dense` without files. The pixels are only read during the call. threads: 0 for all processors;
/// the result does not depend on it.
/// Errors: UnusableInput, which names the photograph (sizes that differ from width and height, an
/// impossible camera, a pose that is not rigid or moves by more than 1 km), NotEnough (fewer than 3
/// photographs, nothing found), Cancelled. Memory is about 90 bytes per pixel of all photographs.
OSTRAKA_API Result<DenseCloud> dense(std::span<const DensePhotograph> photographs, int threads,
                                     Progress& progress, std::stop_token stop);

}  // namespace ostraka::api
