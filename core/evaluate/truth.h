#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka::evaluate {

/// One sherd of a batch's truth; its mesh is closed and in the model's own frame, mm.
struct TrueSherd {
  std::string id;
  TriangleMesh mesh;
  Eigen::Isometry3d plate_front_from_model = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d plate_back_from_model = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d frontFromBack() const {
    return plate_front_from_model * plate_back_from_model.inverse();
  }
};

/// truth/sherds.json with its meshes. plate_from_model_back may be absent: then it equals the
/// front's. Errors: an unreadable file, a mesh outside of the folder, a transform that is not rigid
/// or moves off any plate, a mesh without faces.
Result<std::vector<TrueSherd>> readTrueSherds(const std::filesystem::path& truth_folder);

}  // namespace ostraka::evaluate
