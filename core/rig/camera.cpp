#include "rig/camera.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::rig {
namespace {

// Cameras without a plate stand in a frame of their own, as scans do.
constexpr double kMost_mm = limits::kScanReach_mm.most;

Result<PosedImage> imageFromJson(const nlohmann::json& value, const std::string& where) {
  PosedImage image;
  try {
    image.file = value.at("file").get<std::string>();
    if (value.contains("side") && value["side"] == "back") image.side = batch::Side::Back;
    image.camera = wholeOr(value, "camera", 0, 0, limits::kRigCameras.most);
    image.stop = wholeOr(value, "stop", 0, 0, limits::kRigStops.most);
    image.intrinsics.width = wholeAt(value, "width", 8, limits::kImageSide.most);
    image.intrinsics.height = wholeAt(value, "height", 8, limits::kImageSide.most);
    const auto& k = value.at("K");
    image.intrinsics.fx = numberIn(k.at(0).at(0), "K");
    image.intrinsics.fy = numberIn(k.at(1).at(1), "K");
    image.intrinsics.cx = numberIn(k.at(0).at(2), "K");
    image.intrinsics.cy = numberIn(k.at(1).at(2), "K");
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) pose(r, c) = numberIn(value.at("R").at(r).at(c), "R");
      pose(r, 3) = numberIn(value.at("t").at(r), "t", -kMost_mm, kMost_mm);
    }
    const Eigen::Matrix3d rotation = pose.topLeftCorner<3, 3>();
    const bool rigid =
        pose.allFinite() &&
        (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <
            1e-3 &&
        rotation.determinant() > 0;
    const Intrinsics& i = image.intrinsics;
    if (!rigid || !(i.fx > 0 && i.fy > 0))
      return Error::unusable(
          message("The camera of '%1' has no valid K, R, t or size.", image.file), where);
    readLens(value, image.intrinsics);
    image.camera_from_plate.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
    image.camera_from_plate.translation() = pose.topRightCorner<3, 1>();
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(
        refused,
        image.file.empty()
            ? message("An image lacks file, width, height, K, R or t.")
            : message("An image lacks file, width, height, K, R or t (%1).", image.file),
        where);
  }
  return image;
}

}  // namespace

PoseBlock toBlock(const Eigen::Isometry3d& pose) {
  const Eigen::AngleAxisd turn(pose.linear());
  const Eigen::Vector3d w = turn.angle() * turn.axis(), t = pose.translation();
  return {w.x(), w.y(), w.z(), t.x(), t.y(), t.z()};
}

Eigen::Isometry3d poseFrom(const PoseBlock& block) {
  const Eigen::Vector3d w(block.data());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (w.norm() > 0) pose.linear() = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(block.data() + 3);
  return pose;
}

Intrinsics reduced(const Intrinsics& camera, int width, int height) {
  const double x = static_cast<double>(width) / camera.width,
               y = static_cast<double>(height) / camera.height;
  Intrinsics small = camera;
  small.width = width;
  small.height = height;
  small.fx *= x;
  small.fy *= y;
  small.cx = (camera.cx + 0.5) * x - 0.5;
  small.cy = (camera.cy + 0.5) * y - 0.5;
  return small;
}

Intrinsics reducedTo(const Intrinsics& camera, double megapixels) {
  const double shrink = std::sqrt(megapixels * 1e6 / camera.width / camera.height);
  if (shrink >= 1) return camera;
  return reduced(camera, static_cast<int>(std::lround(shrink * camera.width)),
                 static_cast<int>(std::lround(shrink * camera.height)));
}

bool Intrinsics::hasDistortion() const {
  return distortion != Distortion{};
}

Eigen::Vector2d Intrinsics::project(const Eigen::Vector3d& p) const {
  Eigen::Vector2d n;
  bend(distortion, distortion.terms.data(), p.x() / p.z(), p.y() / p.z(), n.data());
  return {fx * n.x() + cx, fy * n.y() + cy};
}

Eigen::Vector2d Intrinsics::unproject(const Eigen::Vector2d& pixel) const {
  return distortion.unbent({(pixel.x() - cx) / fx, (pixel.y() - cy) / fy});
}

Result<std::vector<PosedImage>> readCameras(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  if (!json->is_object() || !json->contains("images") || !(*json)["images"].is_array() ||
      (*json)["images"].empty())
    return Error::unusable(message("The camera file has no list 'images'."), file.string());
  std::vector<PosedImage> images;
  for (const nlohmann::json& value : (*json)["images"]) {
    Result<PosedImage> image = imageFromJson(value, file.string());
    if (!image) return image.error();
    images.push_back(std::move(*image));
  }
  return images;
}

Result<void> writeCameras(const std::filesystem::path& file,
                          const std::vector<PosedImage>& images) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PosedImage& image : images) {
    const Intrinsics& i = image.intrinsics;
    const Eigen::Matrix3d r = image.camera_from_plate.linear();
    const Eigen::Vector3d t = image.camera_from_plate.translation();
    nlohmann::ordered_json json = {{"file", image.file},
                                   {"side", batch::name(image.side)},
                                   {"camera", image.camera},
                                   {"stop", image.stop},
                                   {"width", i.width},
                                   {"height", i.height},
                                   {"K", {{i.fx, 0, i.cx}, {0, i.fy, i.cy}, {0, 0, 1}}}};
    writeLens(i.distortion, json);
    json["R"] = {
        {r(0, 0), r(0, 1), r(0, 2)}, {r(1, 0), r(1, 1), r(1, 2)}, {r(2, 0), r(2, 1), r(2, 2)}};
    json["t"] = {t.x(), t.y(), t.z()};
    list.push_back(std::move(json));
  }
  return writeJson(file, {{"unit", "mm"}, {"images", list}});
}

std::string maskName(const PosedImage& image) {
  return std::filesystem::path(image.file).stem().string() + ".png";
}

}  // namespace ostraka::rig
