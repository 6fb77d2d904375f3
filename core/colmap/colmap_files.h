#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "rig/camera.h"

namespace ostraka::colmap {

/// COLMAP's sparse model as its files hold it. Its pixels have their centre at +0.5; the
/// conversions below shift by that, these structs do not.
struct ColmapCamera {
  std::uint32_t id = 0;
  int model = 1;  ///< COLMAP's number: 0 SIMPLE_PINHOLE ... 4 OPENCV, 5 OPENCV_FISHEYE
  std::uint64_t width = 0, height = 0;
  std::vector<double> parameters;
};

struct ColmapImage {
  struct Observation {
    Eigen::Vector2d pixel;
    std::int64_t point = -1;  ///< id of its point, -1 without one
  };
  std::uint32_t id = 0, camera = 0;
  Eigen::Isometry3d camera_from_world = Eigen::Isometry3d::Identity();
  std::string name;
  std::vector<Observation> observations;
};

struct ColmapPoint {
  std::uint64_t id = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::array<std::uint8_t, 3> colour{};
  double error_px = 0;
  std::vector<std::array<std::uint32_t, 2>> track;  ///< image id, index of its observation
};

struct ColmapModel {
  std::vector<ColmapCamera> cameras;  ///< these three sorted by id when read
  std::vector<ColmapImage> images;
  std::vector<ColmapPoint> points;
};

/// COLMAP's own: cameras.bin, images.bin and points3D.bin of a folder. Errors: UnusableInput
/// (missing, cut off, unknown camera model, counts beyond the file's size).
Result<ColmapModel> readColmapModel(const std::filesystem::path& folder);
/// The same three as text, which every version of COLMAP and OpenMVS reads.
Result<void> writeColmapModel(const std::filesystem::path& folder, const ColmapModel& model);

/// Number of parameters of a camera model, 0 for one that is not known here.
int colmapParameterCount(int model);

/// PINHOLE without distortion, OPENCV without k3, FULL_OPENCV with more, OPENCV_FISHEYE. The terms
/// of a thin prism, for which COLMAP has no model, must be 0.
ColmapCamera toColmap(const rig::Intrinsics& intrinsics, std::uint32_t id);
/// Errors: UnusableInput (FOV, a THIN_PRISM_FISHEYE that is more than a fisheye, numbers that are
/// no camera).
Result<rig::Intrinsics> fromColmap(const ColmapCamera& camera);

/// Cameras and images with ids from 1 in their order, one camera per image; names[i] is the file
/// name of images[i]. Without points.
ColmapModel toColmap(const std::vector<rig::PosedImage>& images,
                     const std::vector<std::string>& names);
/// Posed images in the order of the model's images; file = name; the world is taken for the plate.
Result<std::vector<rig::PosedImage>> fromColmap(const ColmapModel& model);

}  // namespace ostraka::colmap
