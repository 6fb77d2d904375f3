#pragma once
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "rig/camera.h"
#include "texture/view.h"

namespace ostraka::texture {

/// A photograph of a side: its camera, which may be that of a smaller picture, and its mask.
struct Photograph {
  rig::PosedImage image;  ///< image.file: the photograph's path
  cv::Mat1b mask;
  /// Of the plate's directions, where the lights stand still.
  Eigen::Matrix3d light_from_plate = Eigen::Matrix3d::Identity();
};

/// A sherd to be textured, mesh frame (the front's plate), mm.
struct Subject {
  std::vector<Eigen::Vector3f> points;  ///< of both sides, about 1.5 mm apart
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
};

/// What the photographs show of one sherd, and those that cannot be read, which is the batch's.
struct Shown {
  const std::vector<View>& views;
  const std::vector<Error>& unread;
};

/// What the photographs of a batch show of its sherds, read when it is first asked for: each
/// photograph once, at full size, of which only the parts with sherds are kept. What one sherd
/// hides of another is no part of the other's view.
class SherdViews {
 public:
  SherdViews(std::vector<Photograph> photographs, std::vector<Subject> sherds, int threads);
  /// Of the sherd with this index; holds as long as this does. Errors: Cancelled; that of the first
  /// photograph where none can be read.
  Result<Shown> of(std::size_t sherd, const std::stop_token& stop);

 private:
  Result<void> read(const std::stop_token& stop);
  std::vector<Photograph> photographs_;
  std::vector<Subject> sherds_;
  int threads_;
  std::optional<std::vector<std::vector<View>>> views_;
  std::vector<Error> unread_;
};

}  // namespace ostraka::texture
