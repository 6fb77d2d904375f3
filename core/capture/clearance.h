#pragma once
#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "capture/shot_checks.h"

namespace ostraka::capture {

struct PlateMap;
struct MapPiece;

struct ClearanceOptions {
  double gap_mm = 12;              ///< between two sherds: a finger's width
  double usual_extent_mm = 50;     ///< of a sherd, while none lies on the plate
  double smallest_extent_mm = 25;  ///< fingers do not lay smaller ones closer
};

/// Room for more sherds on the plate.
struct Clearance {
  double extent_mm = 0;                 ///< of a further sherd: the lower median of those there
  std::vector<Eigen::Vector2d> places;  ///< middles of discs of that extent, on the plate, mm
};
/// Places are laid close to what is there already, one after the other: about as many as a person
/// lays, not the most that fit. What the picture does not show is not free. About 5 ms.
Clearance clearance(const PlateMap& map, const std::vector<MapPiece>& pieces,
                    const ClearanceOptions& options);

struct InspectionWithClearance {
  PlateInspection inspection;
  Clearance room;  ///< without places where the plate's place is not seen
};
/// inspectPlate, and how many more have room. Errors: as inspectPlate.
Result<InspectionWithClearance> lookForRoom(std::string_view picture, const batch::Plate& plate,
                                            const InspectionOptions& inspection,
                                            const ClearanceOptions& room);

}  // namespace ostraka::capture
