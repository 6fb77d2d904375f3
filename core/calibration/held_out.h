#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch.h"
#include "calibration/bundle_adjustment.h"
#include "calibration/calibrate.h"

namespace ostraka::calibration {

constexpr double kMostScaleError = 0.003;  ///< of a held-out distance

/// A marker's corners, plate frame, mm, nearest to all rays through the places where they were
/// seen; `corners` holds this marker's only, four per view. Nothing from fewer than two views.
std::optional<std::array<Eigen::Vector3d, 4>> cornersInSpace(
    const RigState& state, const std::vector<PlateCorner>& corners);

std::vector<PlateCorner> ofMarker(const std::vector<PlateCorner>& corners, std::size_t marker);

/// Four of the markers that were seen, a quarter of a turn apart, as indices of plate.markers;
/// none where fewer than eight were seen in two photographs or more.
std::vector<std::size_t> markersToHoldOut(const batch::Plate& plate,
                                          const std::vector<PlateCorner>& corners);

/// Distances between opposite ones of these markers.
std::vector<HeldOutDistance> heldOutDistances(const batch::Plate& plate,
                                              const std::vector<std::size_t>& held_out,
                                              const RigState& state,
                                              const std::vector<PlateCorner>& corners);

/// words: of its markers (%1, %2), of its length as measured and expected in mm (%3, %4), and of
/// the error in mm and percent (%5, %6).
Message said(Template<6> words, const HeldOutDistance& distance);
/// The sentence when it is off by more than kMostScaleError, with what to do.
std::optional<Message> scaleDoubt(const HeldOutDistance& distance);

/// How far camera `index` of `now` stands from where `known` has it, seen from camera `reference`:
/// the turntable's frame is free in height and turn, so only cameras among each other compare.
struct Move {
  double moved_mm = 0, turned_rad = 0;
};
Move moveAgainst(const RigState& known, const RigState& now, std::size_t index,
                 std::size_t reference);
Message sentence(const Move& move, int camera, int reference);

}  // namespace ostraka::calibration
