#include "checks/scale_source.h"

#include <cmath>
#include <optional>

namespace ostraka::checks {
namespace {

// As a person types it: 18, not 18.00.
Decimal asTyped(double length_mm) {
  return decimal(length_mm, length_mm == std::round(length_mm) ? 0 : 2);
}

}  // namespace

Message scaleSource(const batch::Batch& batch, bool has_scale) {
  if (!has_scale) return message("Scale: none; lengths in mm are based on a guess.");
  if (!batch.plate)
    return batch.known_lengths.empty() ? message("Scale: the board of board.json.")
                                       : message("Scale: the lengths marked in scale.json.");
  if (batch.plate->typed_marker_mm)
    return message("Scale: markers of %1 mm, as typed at the import.",
                   asTyped(*batch.plate->typed_marker_mm));
  const std::optional<double> side_mm = batch::markerSide(*batch.plate);
  return side_mm ? message("Scale: markers of %1 mm, as in plate.json.", decimal(*side_mm, 2))
                 : message("Scale: the markers that plate.json describes.");
}

}  // namespace ostraka::checks
