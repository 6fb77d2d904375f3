#include "texture/light_frames.h"

#include <cmath>

#include "rig/turntable.h"

namespace ostraka::texture {

std::optional<std::vector<Eigen::Matrix3d>> lightFrames(const std::vector<rig::PosedImage>& images,
                                                        const rig::Rig& rig) {
  std::vector<Eigen::Matrix3d> frames(images.size(), Eigen::Matrix3d::Identity());
  if (!rig.cameras.empty()) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const rig::RigCamera* camera = rig.find(images[i].camera);
      if (camera == nullptr) return std::nullopt;
      frames[i] =
          camera->camera_from_turntable.linear().transpose() * images[i].camera_from_plate.linear();
    }
    return frames;
  }
  std::vector<bool> turned;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    std::vector<rig::PosedImage> of_side;
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < images.size(); ++i)
      if (images[i].side == side) of_side.push_back(images[i]), at.push_back(i);
    if (of_side.empty()) continue;
    const auto places = rig::turntablePlaces(of_side);
    turned.push_back(places.has_value());
    if (!places) continue;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if ((*places)[k].ring != 0) return std::nullopt;
      const Eigen::Vector3d across = of_side[k].camera_from_plate.linear().row(0);
      const Eigen::AngleAxisd back(-std::atan2(across.y(), across.x()), Eigen::Vector3d::UnitZ());
      frames[at[k]] = back.toRotationMatrix();
    }
  }
  if (turned.size() == 2 && turned[0] != turned[1]) return std::nullopt;
  return frames;
}

}  // namespace ostraka::texture
