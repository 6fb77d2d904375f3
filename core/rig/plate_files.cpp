#include <nlohmann/json.hpp>

#include "base/json.h"
#include "rig/plate_print.h"

namespace ostraka::rig {

Result<void> writePlate(const std::filesystem::path& file, const batch::Plate& plate) {
  nlohmann::ordered_json markers = nlohmann::ordered_json::array();
  for (const batch::Marker& m : plate.markers) {
    nlohmann::ordered_json corners = nlohmann::ordered_json::array();
    for (const Eigen::Vector3d& c : m.corners) corners.push_back({c.x(), c.y(), c.z()});
    markers.push_back({{"id", m.id}, {"corners", corners}});
  }
  return writeJson(file, {{"unit", "mm"},
                          {"dictionary", plate.dictionary},
                          {"diameter", plate.diameter_mm},
                          {"markers", markers}});
}

Result<void> writeBoard(const std::filesystem::path& file, const batch::Board& board) {
  return writeJson(file, {{"dictionary", board.dictionary},
                          {"squares_x", board.squares_x},
                          {"squares_y", board.squares_y},
                          {"square_mm", board.square_mm},
                          {"marker_mm", board.marker_mm}});
}

}  // namespace ostraka::rig
