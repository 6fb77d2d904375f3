#pragma once
#include <optional>
#include <span>
#include <vector>

#include "rig/camera.h"

namespace ostraka::rig {

/// Where a photograph belongs when its camera stood still while the plate turned below it.
struct TurntablePlace {
  int ring = -1;  ///< counts the places where a camera stood, the most photographs first; -1: none
  int stop = -1;  ///< counts the ring's photographs in the order of `images`
};

/// Whether the photographs of one side, posed one by one, were taken by cameras at rest over a
/// plate that turned about its normal: seen from each such camera the normal and the height stay as
/// they are, and the places of the camera around the plate lie on a circle. One entry per image;
/// nothing when fewer than four photographs in five belong to rings of kLeastStops at least, as it
/// is when a person walks around a sheet. images: plate frame, mm.
std::optional<std::vector<TurntablePlace>> turntablePlaces(std::span<const PosedImage> images);

inline constexpr std::size_t kLeastStops = 6;

}  // namespace ostraka::rig
