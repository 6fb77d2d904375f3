#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/json.h"
#include "batch/batch.h"

namespace ostraka::batch {
namespace {

constexpr double kMaxMm = 10'000;  // a plate of 20 m is a mistake in the unit
constexpr std::size_t kMaxMarkers = 1024;

bool usable(const Marker& marker) {
  for (const Eigen::Vector3d& corner : marker.corners)
    if (!corner.allFinite() || corner.cwiseAbs().maxCoeff() > kMaxMm) return false;
  const Eigen::Vector3d diagonal = marker.corners[2] - marker.corners[0];
  const Eigen::Vector3d other = marker.corners[3] - marker.corners[1];
  return marker.id >= 0 && diagonal.cross(other).norm() > 0.1;  // mm2: not a line
}

Marker markerFromJson(const nlohmann::json& value) {
  Marker marker;
  marker.id = value.at("id").get<int>();
  const nlohmann::json& corners = value.at("corners");
  for (int c = 0; c < 4; ++c)
    for (int k = 0; k < 3; ++k) marker.corners[c][k] = corners.at(c).at(k).get<double>();
  return marker;
}

// Of the circle about the plate's middle that holds all markers: what is known to be plate.
double markedDiameter(const Plate& plate) {
  double radius = 0;
  for (const Marker& marker : plate.markers)
    for (const Eigen::Vector3d& corner : marker.corners)
      radius = std::max(radius, corner.head<2>().norm());
  return 2 * radius;
}

// The names differ between our boards and those of others.
double lengthFromJson(const nlohmann::json& value, const char* ours, const char* theirs) {
  return value.at(value.contains(ours) ? ours : theirs).get<double>();
}

}  // namespace

Result<Plate> readPlate(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  Plate plate;
  try {
    if (json->value("unit", "mm") != "mm")
      return Error::unusable("The plate's unit must be mm; print the plate's file again.", file);
    plate.dictionary = json->at("dictionary").get<std::string>();
    for (const nlohmann::json& value : json->at("markers")) {
      if (plate.markers.size() >= kMaxMarkers)
        return Error::unusable("The plate names more than 1024 markers.", file);
      plate.markers.push_back(markerFromJson(value));
    }
    plate.diameter_mm =
        json->contains("diameter") ? json->at("diameter").get<double>() : markedDiameter(plate);
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(
        "The plate needs 'dictionary' and 'markers' with an id and four corners of three numbers "
        "each; 'diameter', where it is given, is a number in mm.",
        file);
  }
  if (plate.markers.empty()) return Error::unusable("The plate names no marker.", file);
  std::set<int> ids;
  for (const Marker& marker : plate.markers) {
    const std::string name = "Marker " + std::to_string(marker.id);
    if (!usable(marker)) return Error::unusable(name + " of the plate has no valid corners.", file);
    if (!ids.insert(marker.id).second)
      return Error::unusable(name + " stands twice on the plate.", file);
  }
  if (!(plate.diameter_mm > 0 && plate.diameter_mm <= 2 * kMaxMm))
    return Error::unusable("The plate's diameter is no length in mm.", file);
  return plate;
}

Result<Board> readBoard(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  Board board;
  try {
    board.dictionary = json->at("dictionary").get<std::string>();
    board.squares_x = json->at("squares_x").get<int>();
    board.squares_y = json->at("squares_y").get<int>();
    board.square_mm = lengthFromJson(*json, "square_mm", "square_length");
    board.marker_mm = lengthFromJson(*json, "marker_mm", "marker_length");
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(
        "The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and "
        "'marker_mm'.",
        file);
  }
  const bool squares = board.squares_x >= 2 && board.squares_y >= 2 && board.squares_x <= 100 &&
                       board.squares_y <= 100;
  if (!squares || !(board.marker_mm > 0 && board.marker_mm < board.square_mm) ||
      !(board.square_mm <= kMaxMm))
    return Error::unusable("The board's squares and markers have no valid number or size.", file);
  return board;
}

}  // namespace ostraka::batch
