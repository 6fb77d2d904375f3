#include "checks/straight_down.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ostraka::checks {

std::optional<Message> straightDown(std::span<const rig::PosedImage> images) {
  const double least = std::cos(15 * std::numbers::pi / 180);
  const bool all = std::all_of(images.begin(), images.end(), [&](const rig::PosedImage& image) {
    return -image.camera_from_plate.linear()(2, 2) > least;
  });
  if (images.empty() || !all) return std::nullopt;
  return message(
      "All photographs look at the sheet from straight above, so heights and wall thicknesses are "
      "uncertain and broken edges are hardly seen. Add photographs from the side, tilted by 30 to "
      "60 degrees.");
}

}  // namespace ostraka::checks
