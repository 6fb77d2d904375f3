#include "capture/clearance.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "base/median.h"
#include "capture/silhouettes.h"

namespace ostraka::capture {
namespace {

constexpr double kStep_mm = 2;  // counting room needs no finer grid
constexpr std::size_t kMost = 60;
constexpr double kGap_mm = 12;             // between two sherds: a finger's width
constexpr double kUsualExtent_mm = 50;     // of a sherd, while none lies on the plate
constexpr double kSmallestExtent_mm = 25;  // fingers do not lay smaller ones closer

double extentOf(const std::vector<MapPiece>& pieces) {
  std::vector<double> extents;
  for (const MapPiece& piece : pieces)
    if (!piece.cut_off) extents.push_back(piece.extent_mm);
  if (extents.empty()) return kUsualExtent_mm;
  return std::max(rankedAt(std::move(extents), 0.5), kSmallestExtent_mm);
}

}  // namespace

Clearance clearance(const PlateMap& map, const std::vector<MapPiece>& pieces) {
  Clearance room;
  room.extent_mm = extentOf(pieces);
  if (map.radius_mm <= 0 || map.seen.empty()) return room;
  // 255 where a sherd may lie, on a grid of its own with a border that may not.
  const int half = static_cast<int>(map.radius_mm / kStep_mm) + 1;
  const auto plate_mm = [&](int column, int row) {
    return Eigen::Vector2d((column - half) * kStep_mm, (half - row) * kStep_mm);
  };
  cv::Mat1b free(2 * half + 1, 2 * half + 1, uchar{0});
  for (int row = 0; row < free.rows; ++row)
    for (int column = 0; column < free.cols; ++column) {
      const Eigen::Vector2d p = plate_mm(column, row);
      if (p.norm() >= map.radius_mm) continue;
      const int x = static_cast<int>((p.x() + map.radius_mm) / PlateMap::kPixelMm),
                y = static_cast<int>((map.radius_mm - p.y()) / PlateMap::kPixelMm);
      if (x < 0 || y < 0 || x >= map.seen.cols || y >= map.seen.rows) continue;
      free(row, column) = map.seen(y, x) != 0 && map.sherd(y, x) == 0 ? 255 : 0;
    }
  // From sherds a gap is kept, from the plate's edge none.
  cv::Mat1b lying(free.size(), uchar{255});
  for (const MapPiece& piece : pieces) {
    std::vector<cv::Point> outline;
    for (const cv::Point& p : piece.outline) {
      const Eigen::Vector2d at = map.plate_mm(p.x, p.y);
      outline.emplace_back(cvRound(at.x() / kStep_mm) + half, half - cvRound(at.y() / kStep_mm));
    }
    cv::fillPoly(lying, std::vector<std::vector<cv::Point>>{outline}, 0);
  }
  const double radius = room.extent_mm / 2;
  while (room.places.size() < kMost) {
    cv::Mat1f to_edge, to_sherd;
    cv::distanceTransform(free, to_edge, cv::DIST_L2, cv::DIST_MASK_5);
    cv::distanceTransform(lying, to_sherd, cv::DIST_L2, cv::DIST_MASK_5);
    // The place that has least room to spare.
    cv::Point best(-1, -1);
    double least = 1e9;
    for (int row = 0; row < free.rows; ++row)
      for (int column = 0; column < free.cols; ++column) {
        const double edge = to_edge(row, column) * kStep_mm - radius,
                     sherd = to_sherd(row, column) * kStep_mm - radius - kGap_mm;
        if (edge < 0 || sherd < 0) continue;
        const double spare = edge + std::min(sherd, 4 * map.radius_mm);
        if (spare < least) {
          least = spare;
          best = {column, row};
        }
      }
    if (best.x < 0) return room;
    room.places.push_back(plate_mm(best.x, best.y));
    cv::circle(lying, best, cvRound(radius / kStep_mm), 0, cv::FILLED);
  }
  return room;
}

Result<InspectionWithClearance> lookForRoom(std::string_view picture, const batch::Plate& plate,
                                            const InspectionOptions& inspection) {
  Result<MappedInspection> mapped = inspectAndMap(picture, plate, inspection);
  if (!mapped) return mapped.error();
  InspectionWithClearance seen{std::move(mapped->inspection), {}};
  if (seen.inspection.pixel_from_plate)
    seen.room = clearance(mapped->map, piecesOf(mapped->map, inspection.smallest_sherd_mm));
  return seen;
}

}  // namespace ostraka::capture
