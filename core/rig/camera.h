#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::rig {

/// Standard: OpenCV's five terms. Full: with its rational and thin-prism terms behind them.
/// Fisheye: four terms of the angle (Kannala and Brandt 2006; OpenCV's cv::fisheye).
enum class Lens { Standard, Full, Fisheye };

/// How a lens bends the picture of a pinhole, in coordinates x/z, y/z: free of pixels.
struct Distortion {
  /// k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4; of a fisheye k1 k2 k3 k4. Those of no use are 0.
  std::array<double, 12> terms{};
  Lens lens = Lens::Standard;

  double& operator[](std::size_t k) { return terms[k]; }
  double operator[](std::size_t k) const { return terms[k]; }
  bool operator==(const Distortion&) const = default;

  /// Without the terms of no use, as OpenCV takes them: 5, 8, 12 or, of a fisheye, 4.
  std::vector<double> list() const;
  /// Where the lens shows what a pinhole shows at n, and the inverse, to 1e-9. What lies beyond
  /// reach has no inverse: the nearest within is returned.
  Eigen::Vector2d bent(const Eigen::Vector2d& n) const;
  Eigen::Vector2d unbent(const Eigen::Vector2d& n) const;
  /// d bent / d n.
  Eigen::Matrix2d slope(const Eigen::Vector2d& n) const;
  /// Off the axis, as x/z: up to there the model is one to one; beyond it folds back into the
  /// picture. At most 14 (86 degrees).
  double reach() const;
};

/// The equations of Distortion::bent for numbers with derivatives. own: the first five terms (the
/// four of a fisheye), which an adjustment may turn; the others are those of the lens.
template <class T>
void bend(const Distortion& lens, const T* own, const T& x, const T& y, T* out) {
  const T r2 = x * x + y * y;
  if (lens.lens == Lens::Fisheye) {
    using std::atan, std::sqrt;
    T scale(1.0);
    if (r2 > 1e-16) {
      const T r = sqrt(r2), angle = atan(r), a2 = angle * angle;
      scale = angle / r * (1.0 + a2 * (own[0] + a2 * (own[1] + a2 * (own[2] + a2 * own[3]))));
    }
    out[0] = x * scale;
    out[1] = y * scale;
    return;
  }
  const auto& further = lens.terms;
  T radial = 1.0 + r2 * (own[0] + r2 * (own[1] + r2 * own[4]));
  if (lens.lens == Lens::Full)
    radial = radial / (1.0 + r2 * (further[5] + r2 * (further[6] + r2 * further[7])));
  out[0] = x * radial + 2.0 * own[2] * x * y + own[3] * (r2 + 2.0 * x * x);
  out[1] = y * radial + own[2] * (r2 + 2.0 * y * y) + 2.0 * own[3] * x * y;
  if (lens.lens != Lens::Full) return;
  out[0] = out[0] + r2 * (further[8] + r2 * further[9]);
  out[1] = out[1] + r2 * (further[10] + r2 * further[11]);
}

/// A pinhole behind a lens. A pixel's centre has integer coordinates; axes x right, y down, z
/// forward.
struct Intrinsics {
  int width = 0, height = 0;
  double fx = 0, fy = 0, cx = 0, cy = 0;
  Distortion distortion{};

  /// Pixel of a point in the camera frame, mm, with z > 0.
  Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const;
  /// Normalised image coordinates (x/z, y/z) of a pixel: the inverse of project, to 1e-9.
  Eigen::Vector2d unproject(const Eigen::Vector2d& pixel) const;
  bool hasDistortion() const;
  /// Whether a lens of more than the five terms folds within the middle half of the picture, which
  /// none does. Five terms may that were estimated from few markers.
  bool folds() const;
};

/// Reads "dist" (0, 4, 5, 8 or 12 numbers in OpenCV's order) and "lens" ("standard", or "fisheye"
/// with 4 numbers) into a camera that has its size and K. Throws nlohmann's exceptions: a
/// JsonValueError, whose sentence says what is no lens.
void readLens(const nlohmann::json& from, Intrinsics& camera);
/// Appends the same to an object.
void writeLens(const Distortion& lens, nlohmann::ordered_json& to);

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

/// {"unit":"mm","images":[{"file","width","height","K","dist"[,"lens"],"R","t"[,"side","camera",
/// "stop"]}]}, x_cam = R X + t; "dist" and "lens" as readLens reads them.
Result<std::vector<PosedImage>> readCameras(const std::filesystem::path& file);
Result<void> writeCameras(const std::filesystem::path& file, const std::vector<PosedImage>& images);

}  // namespace ostraka::rig
