#include <nlohmann/json.hpp>

#include "files/json.h"
#include "rig/plate_print.h"

namespace ostraka::rig {

Result<void> writePlate(const std::filesystem::path& file, const batch::Plate& plate) {
  nlohmann::ordered_json markers = nlohmann::ordered_json::array();
  for (const batch::Marker& m : plate.markers) {
    nlohmann::ordered_json corners = nlohmann::ordered_json::array();
    for (const Eigen::Vector3d& c : m.corners) corners.push_back({c.x(), c.y(), c.z()});
    markers.push_back({{"id", m.id}, {"corners", corners}});
  }
  nlohmann::ordered_json all{{"unit", "mm"}, {"dictionary", plate.dictionary}};
  if (plate.sheet)  // about the origin, as it is read
    all["sheet"] = {plate.sheet->sizes().x(), plate.sheet->sizes().y()};
  else
    all["diameter"] = plate.diameter_mm;
  all["markers"] = markers;
  return writeJson(file, all);
}

Result<void> writeBoard(const std::filesystem::path& file, const batch::Board& board) {
  return writeJson(file, {{"dictionary", board.dictionary},
                          {"squares_x", board.squares_x},
                          {"squares_y", board.squares_y},
                          {"square_mm", board.square_mm},
                          {"marker_mm", board.marker_mm}});
}

}  // namespace ostraka::rig
