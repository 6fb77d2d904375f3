#pragma once
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "colmap/colmap_files.h"
#include "colmap/colmap_format.h"

namespace ostraka::colmap {

/// The forms that the program does not need: the binary one is COLMAP's to write, the text one its
/// to read.
class BinaryForm {
 public:
  explicit BinaryForm(const std::vector<ColmapCamera>& cameras) {
    put(std::uint64_t{cameras.size()});
    for (const ColmapCamera& camera : cameras) {
      put(camera.id), put(std::int32_t{camera.model}), put(camera.width), put(camera.height);
      for (const double value : camera.parameters) put(value);
    }
  }
  explicit BinaryForm(const std::vector<ColmapImage>& images) {
    put(std::uint64_t{images.size()});
    for (const ColmapImage& image : images) {
      const Eigen::Quaterniond q(image.camera_from_world.linear());
      put(image.id);
      for (const double value : {q.w(), q.x(), q.y(), q.z()}) put(value);
      for (int k = 0; k < 3; ++k) put(double{image.camera_from_world.translation()[k]});
      put(image.camera);
      bytes += image.name + '\0';
      put(std::uint64_t{image.observations.size()});
      for (const ColmapImage::Observation& seen : image.observations)
        put(double{seen.pixel.x()}), put(double{seen.pixel.y()}), put(seen.point);
    }
  }
  explicit BinaryForm(const std::vector<ColmapPoint>& points) {
    put(std::uint64_t{points.size()});
    for (const ColmapPoint& point : points) {
      put(point.id);
      for (int k = 0; k < 3; ++k) put(double{point.position[k]});
      for (const std::uint8_t channel : point.colour) put(channel);
      put(point.error_px);
      put(std::uint64_t{point.track.size()});
      for (const auto& [image, index] : point.track) put(image), put(index);
    }
  }
  std::string bytes;

 private:
  template <class T>
  void put(T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
};

inline void writeBinaryModel(const std::filesystem::path& folder, const ColmapModel& model) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "cameras.bin") << BinaryForm(model.cameras).bytes;
  std::ofstream(folder / "images.bin") << BinaryForm(model.images).bytes;
  std::ofstream(folder / "points3D.bin") << BinaryForm(model.points).bytes;
}

/// Without its comments; as many lines as there are.
inline std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with('#')) lines.push_back(line);
  return lines;
}

inline ColmapModel textModelIn(const std::filesystem::path& folder) {
  ColmapModel model;
  for (const std::string& line : linesOf(folder / "cameras.txt")) {
    std::istringstream words(line);
    ColmapCamera camera;
    std::string name;
    words >> camera.id >> name >> camera.width >> camera.height;
    camera.model = 0;
    while (name != colmapModelName(camera.model)) ++camera.model;
    for (double value; words >> value;) camera.parameters.push_back(value);
    model.cameras.push_back(camera);
  }
  const std::vector<std::string> lines = linesOf(folder / "images.txt");
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    std::istringstream words(lines[i]), pixels(lines[i + 1]);
    ColmapImage image;
    Eigen::Quaterniond turn;
    Eigen::Vector3d shift;
    words >> image.id >> turn.w() >> turn.x() >> turn.y() >> turn.z();
    words >> shift.x() >> shift.y() >> shift.z() >> image.camera >> std::ws;
    std::getline(words, image.name);
    image.camera_from_world = Eigen::Translation3d(shift) * turn.normalized();
    for (ColmapImage::Observation seen; pixels >> seen.pixel.x() >> seen.pixel.y() >> seen.point;)
      image.observations.push_back(seen);
    model.images.push_back(image);
  }
  for (const std::string& line : linesOf(folder / "points3D.txt")) {
    std::istringstream words(line);
    ColmapPoint point;
    words >> point.id >> point.position.x() >> point.position.y() >> point.position.z();
    for (std::uint8_t& channel : point.colour) {
      int value = 0;
      words >> value;
      channel = static_cast<std::uint8_t>(value);
    }
    words >> point.error_px;
    for (std::array<std::uint32_t, 2> seen{}; words >> seen[0] >> seen[1];)
      point.track.push_back(seen);
    model.points.push_back(point);
  }
  return model;
}

}  // namespace ostraka::colmap
