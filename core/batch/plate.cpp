#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/limits.h"
#include "base/message.h"
#include "batch/batch.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::batch {
namespace {

constexpr double kMost_mm = limits::kPlateReach_mm.most;
constexpr int kMostSquares = limits::kBoardSquares.most;
constexpr int kMostId = 1'000'000;         // beyond every dictionary
constexpr double kLeastOverlap_mm = 0.01;  // markers may touch
constexpr double kSameSide = 0.1;          // as far as sides differ that were found in photographs

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool isLine(const Marker& marker) {
  const Eigen::Vector3d diagonal = marker.corners[2] - marker.corners[0];
  const Eigen::Vector3d other = marker.corners[3] - marker.corners[1];
  return !(diagonal.cross(other).norm() > 0.1);  // mm2
}

// Of the corners at which the edge turns left, seen from above; none of a marker as it is printed,
// whose corners go round clockwise.
int leftTurns(const Marker& marker) {
  int turns = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const Eigen::Vector2d at = marker.corners[c].head<2>();
    const Eigen::Vector2d before = marker.corners[(c + 3) % 4].head<2>();
    const Eigen::Vector2d after = marker.corners[(c + 1) % 4].head<2>();
    turns += cross(at - before, after - at) >= 0 ? 1 : 0;
  }
  return turns;
}

// Empty, or what is wrong with the marker's corners.
Message wrongCorners(const Marker& marker) {
  if (isLine(marker)) return message("Marker %1 of the plate has no valid corners.", marker.id);
  const int turns = leftTurns(marker);
  if (turns == 4)
    return message(
        "Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen from above; "
        "create the plate file again.",
        marker.id);
  if (turns > 0)
    return message(
        "Marker %1 of the plate is not convex; list its corners in order along its edge.",
        marker.id);
  return {};
}

// Convex quadrilaterals that no line along an edge of either separates.
bool overlap(const Marker& a, const Marker& b) {
  for (const Marker* of : {&a, &b})
    for (std::size_t c = 0; c < 4; ++c) {
      const Eigen::Vector2d edge =
          (of->corners[(c + 1) % 4] - of->corners[c]).head<2>().normalized();
      const auto across = [&edge](const Marker& marker) {
        Eigen::Vector4d at;
        for (Eigen::Index k = 0; k < 4; ++k)
          at[k] = cross(edge, marker.corners[static_cast<std::size_t>(k)].head<2>());
        return at;
      };
      const Eigen::Vector4d at = across(a), bt = across(b);
      if (std::min(at.maxCoeff(), bt.maxCoeff()) - std::max(at.minCoeff(), bt.minCoeff()) <
          kLeastOverlap_mm)
        return false;
    }
  return true;
}

Marker markerFromJson(const nlohmann::json& value) {
  Marker marker;
  marker.id = wholeAt(value, "id", 0, kMostId);
  const nlohmann::json& corners = value.at("corners");
  for (int c = 0; c < 4; ++c)
    for (int k = 0; k < 3; ++k)
      marker.corners[c][k] = numberIn(corners.at(c).at(k), "corners", -kMost_mm, kMost_mm);
  return marker;
}

Result<void> checkMarkers(const std::vector<Marker>& markers, const std::filesystem::path& file) {
  if (markers.empty()) return Error::unusable(message("The plate file lists no markers."), file);
  std::set<int> ids;
  for (const Marker& marker : markers) {
    if (Message wrong = wrongCorners(marker); !wrong.empty())
      return Error::unusable(std::move(wrong), file);
    if (!ids.insert(marker.id).second)
      return Error::unusable(message("Marker %1 occurs twice on the plate.", marker.id), file);
  }
  for (std::size_t i = 0; i < markers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (overlap(markers[i], markers[k]))
        return Error::unusable(
            message("The markers %1 and %2 of the plate overlap; create the plate file again.",
                    markers[k].id, markers[i].id),
            file);
  return {};
}

// Of the circle about the plate's middle that holds all markers: what is known to be plate.
double markedDiameter(const Plate& plate) {
  double radius = 0;
  for (const Marker& marker : plate.markers)
    for (const Eigen::Vector3d& corner : marker.corners)
      radius = std::max(radius, corner.head<2>().norm());
  return 2 * radius;
}

// The paper's extent where the file does not say it: around the markers, with as much margin as
// there is between neighbours, which is what printers leave at least.
Eigen::AlignedBox2d markedSheet(const Plate& plate) {
  Eigen::AlignedBox2d box;
  double gap = std::numeric_limits<double>::max();
  for (const Marker& marker : plate.markers)
    for (const Eigen::Vector3d& corner : marker.corners) {
      box.extend(corner.head<2>());
      for (const Marker& other : plate.markers)
        for (const Eigen::Vector3d& to : other.corners)
          if (&other != &marker) gap = std::min(gap, (to - corner).norm());
    }
  if (plate.markers.size() < 2) gap = 0;
  box.min().array() -= gap;
  box.max().array() += gap;
  return box;
}

Eigen::AlignedBox2d sheetFromJson(const nlohmann::json& size) {
  const Eigen::Vector2d half(0.5 * numberIn(size.at(0), "sheet", 1, 2 * kMost_mm),
                             0.5 * numberIn(size.at(1), "sheet", 1, 2 * kMost_mm));
  return {-half, half};
}

// The names differ between our boards and those of others.
double lengthFromJson(const nlohmann::json& value, const char* ours, const char* theirs) {
  return numberAt(value, value.contains(ours) ? ours : theirs, 0.01, kMost_mm);
}

}  // namespace

Result<Plate> readPlate(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  Plate plate;
  try {
    if (json->value("unit", "mm") != "mm")
      return Error::unusable(message("The plate's unit must be mm; create the plate file again."),
                             file);
    plate.dictionary = json->at("dictionary").get<std::string>();
    for (const nlohmann::json& value : json->at("markers")) {
      if (plate.markers.size() >= limits::kPlateMarkers.most)
        return Error::unusable(message("The plate file lists more than 1024 markers."), file);
      plate.markers.push_back(markerFromJson(value));
    }
    plate.diameter_mm =
        json->contains("diameter") ? numberAt(*json, "diameter", 1, 2 * kMost_mm) : 0;
    if (json->contains("sheet")) plate.sheet = sheetFromJson(json->at("sheet"));
    if (json->contains("typed_marker_mm"))
      plate.typed_marker_mm = numberAt(*json, "typed_marker_mm", 0.01, kMost_mm);
    plate.round = plate.diameter_mm > 0 && !plate.sheet;
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(
        refused,
        message("The plate file needs 'dictionary' and 'markers', each with an id and four "
                "corners of three numbers; 'diameter', if given, is a number in mm, "
                "'sheet' the paper's width and height."),
        file);
  }
  if (Result<void> good = checkMarkers(plate.markers, file); !good) return good.error();
  if (plate.diameter_mm == 0) plate.diameter_mm = markedDiameter(plate);
  return plate;
}

Plate asSheet(Plate plate) {
  if (plate.sheet) return plate;
  if (plate.round) {
    const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * plate.diameter_mm);
    plate.sheet = Eigen::AlignedBox2d(-half, half);
    return plate;
  }
  const Eigen::AlignedBox2d box = markedSheet(plate);
  const Eigen::Vector2d middle = box.center();
  for (Marker& marker : plate.markers)
    for (Eigen::Vector3d& corner : marker.corners) corner.head<2>() -= middle;
  plate.sheet = Eigen::AlignedBox2d(box.min() - middle, box.max() - middle);
  plate.diameter_mm = markedDiameter(plate);
  return plate;
}

double sideOf(const Marker& marker) {
  double around = 0;
  for (std::size_t c = 0; c < 4; ++c)
    around += (marker.corners[(c + 1) % 4] - marker.corners[c]).norm();
  return around / 4;
}

std::optional<double> markerSide(const Plate& plate) {
  double least = std::numeric_limits<double>::max(), most = 0, sum = 0;
  for (const Marker& marker : plate.markers) {
    const double side = sideOf(marker);
    least = std::min(least, side);
    most = std::max(most, side);
    sum += side;
  }
  if (plate.markers.empty() || most > (1 + kSameSide) * least) return {};
  return sum / static_cast<double>(plate.markers.size());
}

Plate withMarkerSide(Plate plate, double side_mm) {
  // What was typed before is what the markers' mean stands for.
  const double factor = side_mm / plate.typed_marker_mm.value_or(*markerSide(plate));
  for (Marker& marker : plate.markers)
    for (Eigen::Vector3d& corner : marker.corners) corner *= factor;
  plate.diameter_mm *= factor;
  if (plate.sheet)
    plate.sheet = Eigen::AlignedBox2d(plate.sheet->min() * factor, plate.sheet->max() * factor);
  plate.typed_marker_mm = side_mm;
  return plate;
}

Result<Board> readBoard(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  Board board;
  try {
    board.dictionary = json->at("dictionary").get<std::string>();
    board.squares_x = wholeAt(*json, "squares_x", 2, kMostSquares);
    board.squares_y = wholeAt(*json, "squares_y", 2, kMostSquares);
    board.square_mm = lengthFromJson(*json, "square_mm", "square_length");
    board.marker_mm = lengthFromJson(*json, "marker_mm", "marker_length");
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(
        refused,
        message("The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and "
                "'marker_mm'."),
        file);
  }
  if (!(board.marker_mm < board.square_mm))
    return Error::unusable(message("The board's markers must be smaller than its squares; correct "
                                   "'marker_mm' or 'square_mm'."),
                           file);
  return board;
}

}  // namespace ostraka::batch
