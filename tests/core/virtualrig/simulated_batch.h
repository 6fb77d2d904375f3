#pragma once
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "rig/camera.h"

/// What the tests of simulated batches look at in a batch's folder.
namespace ostraka::virtualrig {

/// Of all its files, by their names in it.
inline std::map<std::string, std::string> digestsOf(const std::filesystem::path& folder) {
  std::map<std::string, std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      out[std::filesystem::relative(entry.path(), folder).string()] =
          sha256(*readFile(entry.path()));
  return out;
}

/// The true mask of a photograph.
inline std::filesystem::path maskOf(const std::filesystem::path& folder,
                                    const rig::PosedImage& image) {
  std::string name = image.file.substr(0, image.file.size() - 4) + ".png";
  name[name.find('/')] = '_';
  return folder / "truth" / "masks" / name;
}

/// The true meshes as the photograph's true camera projects them.
inline cv::Mat projectedMeshes(const std::filesystem::path& folder, const rig::PosedImage& image,
                               const cv::Size& size) {
  cv::Mat drawn(size, CV_8U, cv::Scalar(0));
  const auto truth = *readJson(folder / "truth/sherds.json");
  for (const auto& sherd : truth["sherds"]) {
    const bool front = image.side == batch::Side::Front;
    const auto pose =
        *isometryFromJson(sherd[front ? "plate_from_model_front" : "plate_from_model_back"], "");
    const TriangleMesh mesh = readPly(folder / "truth" / sherd["mesh"].get<std::string>())->mesh;
    for (const auto& t : mesh.triangles) {
      std::vector<cv::Point> corners;  // in sixteenths of a pixel
      for (const int i : t) {
        const Eigen::Vector2d q = image.project(pose * mesh.vertices[i].cast<double>());
        corners.emplace_back(static_cast<int>(std::lround(16 * q.x())),
                             static_cast<int>(std::lround(16 * q.y())));
      }
      cv::fillConvexPoly(drawn, corners, 255, cv::LINE_8, 4);
    }
  }
  return drawn;
}

}  // namespace ostraka::virtualrig
