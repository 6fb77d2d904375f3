#include "colmap/colmap_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/message.h"
#include "colmap/colmap_format.h"

namespace ostraka::colmap {
namespace {

struct CameraModel {
  const char* name;
  int parameters;
};

// In the order of COLMAP's numbers.
constexpr std::array<CameraModel, 11> kModels{{{"SIMPLE_PINHOLE", 3},
                                               {"PINHOLE", 4},
                                               {"SIMPLE_RADIAL", 4},
                                               {"RADIAL", 5},
                                               {"OPENCV", 8},
                                               {"OPENCV_FISHEYE", 8},
                                               {"FULL_OPENCV", 12},
                                               {"FOV", 5},
                                               {"SIMPLE_RADIAL_FISHEYE", 4},
                                               {"RADIAL_FISHEYE", 5},
                                               {"THIN_PRISM_FISHEYE", 12}}};

constexpr double kCentre = 0.5;  // of a pixel in COLMAP's convention; in ours 0

bool valid(const rig::Intrinsics& i) {
  return i.width > 0 && i.height > 0 && i.width <= 100'000 && i.height <= 100'000 &&
         std::isfinite(i.fx + i.fy + i.cx + i.cy) && i.fx > 0 && i.fy > 0 &&
         std::all_of(i.distortion.terms.begin(), i.distortion.terms.end(),
                     [](double term) { return std::isfinite(term); }) &&
         !i.folds();
}

// From COLMAP's parameters behind the focal length and the centre; nothing where none of ours is
// the same.
std::optional<rig::Distortion> lensOf(int model, const std::vector<double>& p) {
  using enum rig::Lens;
  switch (model) {
    case 0:
    case 1:
      return rig::Distortion{};
    case 2:
      return rig::Distortion{{p[3]}, Standard};
    case 3:
      return rig::Distortion{{p[3], p[4]}, Standard};
    case 4:
      return rig::Distortion{{p[4], p[5], p[6], p[7]}, Standard};
    case 5:
      return rig::Distortion{{p[4], p[5], p[6], p[7]}, Fisheye};
    case 6:
      return rig::Distortion{{p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11]},
                             p[9] == 0 && p[10] == 0 && p[11] == 0 ? Standard : Full};
    case 8:
      return rig::Distortion{{p[3]}, Fisheye};
    case 9:
      return rig::Distortion{{p[3], p[4]}, Fisheye};
    case 10:
      if (p[6] != 0 || p[7] != 0 || p[10] != 0 || p[11] != 0) return std::nullopt;
      return rig::Distortion{{p[4], p[5], p[8], p[9]}, Fisheye};
    default:
      return std::nullopt;
  }
}

}  // namespace

int colmapParameterCount(int model) {
  return model < 0 || model >= static_cast<int>(kModels.size()) ? 0 : kModels[model].parameters;
}

const char* colmapModelName(int model) {
  return colmapParameterCount(model) == 0 ? "" : kModels[model].name;
}

ColmapCamera toColmap(const rig::Intrinsics& i, std::uint32_t id) {
  ColmapCamera camera;
  camera.id = id;
  camera.width = static_cast<std::uint64_t>(i.width);
  camera.height = static_cast<std::uint64_t>(i.height);
  camera.parameters = {i.fx, i.fy, i.cx + kCentre, i.cy + kCentre};
  camera.model = 1;
  if (!i.hasDistortion()) return camera;
  const rig::Distortion& d = i.distortion;
  camera.parameters.insert(camera.parameters.end(), {d[0], d[1], d[2], d[3]});
  camera.model = d.lens == rig::Lens::Fisheye ? 5 : 4;
  if (d.lens == rig::Lens::Fisheye || (d.lens == rig::Lens::Standard && d[4] == 0)) return camera;
  camera.parameters.insert(camera.parameters.end(), {d[4], d[5], d[6], d[7]});
  camera.model = 6;
  return camera;
}

Result<rig::Intrinsics> fromColmap(const ColmapCamera& camera) {
  const std::vector<double>& p = camera.parameters;
  const auto unusable = [&] {
    return Error::unusable(
        message("COLMAP's camera %1 has the model '%2' or values that Ostraka does not support; "
                "use the model OPENCV instead.",
                camera.id, colmapModelName(camera.model)));
  };
  if (colmapParameterCount(camera.model) == 0 ||
      p.size() != static_cast<std::size_t>(colmapParameterCount(camera.model)) ||
      camera.width > 100'000 || camera.height > 100'000)
    return unusable();
  rig::Intrinsics i;
  i.width = static_cast<int>(camera.width);
  i.height = static_cast<int>(camera.height);
  const std::string name = colmapModelName(camera.model);
  const bool one_focal = name.starts_with("SIMPLE_") || name.starts_with("RADIAL");
  i.fx = p[0];
  i.fy = one_focal ? p[0] : p[1];
  i.cx = p[one_focal ? 1 : 2] - kCentre;
  i.cy = p[one_focal ? 2 : 3] - kCentre;
  const std::optional<rig::Distortion> lens = lensOf(camera.model, p);
  if (!lens) return unusable();
  i.distortion = *lens;
  if (!valid(i)) return unusable();
  return i;
}

ColmapModel toColmap(const std::vector<rig::PosedImage>& images,
                     const std::vector<std::string>& names) {
  ColmapModel model;
  for (std::size_t k = 0; k < images.size(); ++k) {
    const auto id = static_cast<std::uint32_t>(k + 1);
    model.cameras.push_back(toColmap(images[k].intrinsics, id));
    model.images.push_back({id, id, images[k].camera_from_plate, names[k], {}});
  }
  return model;
}

Result<std::vector<rig::PosedImage>> fromColmap(const ColmapModel& model) {
  std::vector<rig::PosedImage> images;
  for (const ColmapImage& one : model.images) {
    const auto camera = std::ranges::find(model.cameras, one.camera, &ColmapCamera::id);
    if (camera == model.cameras.end())
      return Error::unusable(message("COLMAP's model has no camera for the image '%1'.", one.name));
    const Result<rig::Intrinsics> intrinsics = fromColmap(*camera);
    if (!intrinsics) return intrinsics.error();
    rig::PosedImage image;
    image.file = one.name;
    image.intrinsics = *intrinsics;
    image.camera_from_plate = one.camera_from_world;
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace ostraka::colmap
