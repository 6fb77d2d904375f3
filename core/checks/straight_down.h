#pragma once
#include <optional>
#include <span>

#include "base/message.h"
#include "rig/camera.h"

namespace ostraka::checks {

/// What a person hears of photographs by hand over a sheet of which none is tilted by 15 degrees:
/// they do not tell a lens's focal length from its distance, and heights go with the distance.
std::optional<Message> straightDown(std::span<const rig::PosedImage> images);

}  // namespace ostraka::checks
