#pragma once
#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "capture/shot_checks.h"

namespace ostraka::capture {

struct PlateMap;
struct MapPiece;

/// Room for more sherds on the plate.
struct Clearance {
  double extent_mm = 0;                 ///< of a further sherd: the lower median of those there
  std::vector<Eigen::Vector2d> places;  ///< middles of discs of that extent, on the plate, mm
};
/// Places are laid close to what is there already, one after the other: about as many as a person
/// lays, not the most that fit. What the picture does not show is not free. About 5 ms.
Clearance clearance(const PlateMap& map, const std::vector<MapPiece>& pieces);

struct InspectionWithClearance {
  PlateInspection inspection;
  Clearance room;  ///< without places where the plate's place is not seen
};
/// inspectPlate, and how many more have room. Errors: as inspectPlate.
Result<InspectionWithClearance> lookForRoom(std::string_view picture, const batch::Plate& plate,
                                            const InspectionOptions& inspection);

}  // namespace ostraka::capture
