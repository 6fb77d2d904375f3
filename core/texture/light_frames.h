#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rig/camera.h"
#include "rig/rig.h"

namespace ostraka::texture {

/// For each image over a plate the turn of the plate's directions to where the lights stand still,
/// z up: to a rig's turntable; below a camera at rest so that x runs along its pictures' rows; by
/// hand to the plate itself, which lies still with the sherds and is not moved between the sides.
/// Nothing where this cannot be said: a camera that stood in several places while a plate turned
/// does not tell how these lie to each other. rig: empty without one.
std::optional<std::vector<Eigen::Matrix3d>> lightFrames(const std::vector<rig::PosedImage>& images,
                                                        const rig::Rig& rig);

}  // namespace ostraka::texture
