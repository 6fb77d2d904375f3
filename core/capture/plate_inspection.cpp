#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "base/plate_order.h"
#include "batch/photograph.h"
#include "capture/shot_checks.h"
#include "capture/silhouettes.h"
#include "rig/edge_width.h"
#include "rig/plate_markers.h"

namespace ostraka::capture {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr int kQuickWidth_px = 960;

// Most of the time goes into the markers. A smaller picture shows nearly all of them as well; only
// when it does not, as with small markers or a camera that sees the plate from afar, all of it
// counts.
Result<std::vector<rig::SeenMarker>> markersOf(const cv::Mat& work, const batch::Plate& plate) {
  if (work.cols > kQuickWidth_px * 5 / 4) {
    cv::Mat small;
    cv::resize(work, small, {kQuickWidth_px, work.rows * kQuickWidth_px / work.cols}, 0, 0,
               cv::INTER_AREA);
    Result<std::vector<rig::SeenMarker>> seen = rig::findPlateMarkers(small, plate);
    if (!seen) return seen;
    if (4 * seen->size() >= 3 * plate.markers.size()) {
      const double scale = static_cast<double>(work.cols) / small.cols;
      for (rig::SeenMarker& marker : *seen)
        for (Eigen::Vector2d& corner : marker.corners)
          corner = ((corner.array() + 0.5) * scale - 0.5).matrix();
      return seen;
    }
  }
  return rig::findPlateMarkers(work, plate);
}

std::optional<Eigen::Matrix3d> planeOf(const std::vector<rig::SeenMarker>& seen,
                                       const batch::Plate& plate) {
  if (static_cast<int>(seen.size()) < kLeastMarkers) return std::nullopt;
  std::map<int, const batch::Marker*> markers;
  for (const batch::Marker& m : plate.markers) markers[m.id] = &m;
  std::vector<cv::Point2d> on_plate, in_picture;
  for (const rig::SeenMarker& s : seen)
    for (std::size_t c = 0; c < 4; ++c) {
      on_plate.emplace_back(markers[s.id]->corners[c].x(), markers[s.id]->corners[c].y());
      in_picture.emplace_back(s.corners[c].x(), s.corners[c].y());
    }
  cv::Mat used;
  const cv::Mat h = cv::findHomography(on_plate, in_picture, cv::RANSAC, 4.0, used);
  if (h.empty() || cv::countNonZero(used) < 4 * kLeastMarkers) return std::nullopt;
  Eigen::Matrix3d result;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) result(r, c) = h.at<double>(r, c);
  return result;
}

// Median width of the markers' black-to-paper edges, in pixels of the whole picture.
double sharpnessOf(const cv::Mat& picture, const std::vector<rig::SeenMarker>& seen,
                   double whole_per_work) {
  cv::Mat1b grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  std::vector<double> widths;
  for (const rig::SeenMarker& marker : seen) {
    std::array<Eigen::Vector2d, 4> corners;
    for (std::size_t c = 0; c < 4; ++c)
      corners[c] = ((marker.corners[c].array() + 0.5) * whole_per_work - 0.5).matrix();
    const std::vector<double> found = rig::edgeWidths(grey, corners);
    widths.insert(widths.end(), found.begin(), found.end());
  }
  return rig::typicalWidth(std::move(widths));
}

void measureLight(const cv::Mat& picture, const cv::Mat1b& sherds, PlateInspection& inspection) {
  std::int64_t all = 0, dark = 0, bright = 0;
  for (int y = 0; y < picture.rows; ++y) {
    const auto* row = picture.ptr<cv::Vec3b>(y);
    for (int x = 0; x < picture.cols; ++x) {
      if (!sherds(y, x)) continue;
      ++all;
      dark += row[x][0] + row[x][1] + row[x][2] < 3 * 13;
      bright += std::max({row[x][0], row[x][1], row[x][2]}) >= 253;
    }
  }
  if (all == 0) return;
  inspection.dark_share = static_cast<double>(dark) / static_cast<double>(all);
  inspection.bright_share = static_cast<double>(bright) / static_cast<double>(all);
}

std::vector<PlateMark> marksOf(const std::vector<rig::SeenMarker>& seen, double whole_per_work) {
  std::vector<PlateMark> marks;
  for (const rig::SeenMarker& marker : seen) {
    PlateMark mark{marker.id, {}, true};
    for (std::size_t c = 0; c < 4; ++c)
      mark.corners_px[c] =
          ((marker.corners[c].array() + 0.5) * whole_per_work - 0.5).cast<float>().matrix();
    marks.push_back(mark);
  }
  return marks;
}

Eigen::Vector2f projected(const Eigen::Matrix3d& h, const Eigen::Vector2d& p) {
  const Eigen::Vector3d q = h * Eigen::Vector3d(p.x(), p.y(), 1);
  return (q.head<2>() / q.z()).cast<float>();
}

// Where a marker that is not seen should be, as far as it lies within the picture.
void addHidden(const batch::Plate& plate, const Eigen::Matrix3d& pixel_from_plate,
               PlateInspection& inspection) {
  const auto within = [&](const Eigen::Vector2f& p) {
    return p.x() >= 0 && p.y() >= 0 && p.x() < static_cast<float>(inspection.width) &&
           p.y() < static_cast<float>(inspection.height);
  };
  for (const batch::Marker& marker : plate.markers) {
    const auto same = [&](const PlateMark& mark) { return mark.id == marker.id; };
    if (std::any_of(inspection.marks.begin(), inspection.marks.end(), same)) continue;
    PlateMark mark{marker.id, {}, false};
    for (std::size_t c = 0; c < 4; ++c)
      mark.corners_px[c] = projected(pixel_from_plate, marker.corners[c].head<2>());
    if (std::all_of(mark.corners_px.begin(), mark.corners_px.end(), within))
      inspection.marks.push_back(mark);
  }
}

PlateMap findSherds(const cv::Mat& picture, const Eigen::Matrix3d& pixel_from_plate,
                    const batch::Plate& plate, const InspectionOptions& options,
                    double whole_per_work, PlateInspection& inspection) {
  PlateMap map = mapPlate(picture, pixel_from_plate, freeRadius_mm(plate));
  std::vector<MapPiece> pieces = piecesOf(map, options.smallest_sherd_mm);
  std::sort(pieces.begin(), pieces.end(), [](const MapPiece& a, const MapPiece& b) {
    return comesBefore(a.centre_mm, b.centre_mm);
  });
  cv::Mat1b sherds(picture.size(), uchar{0});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    SeenSherd sherd{{}, pieces[i].centre_mm, pieces[i].cut_off};
    std::vector<cv::Point> outline;
    for (const cv::Point& p : pieces[i].outline) {
      const Eigen::Vector2f pixel = projected(pixel_from_plate, map.plate_mm(p.x, p.y));
      outline.emplace_back(cvRound(pixel.x()), cvRound(pixel.y()));
      sherd.outline_px.push_back(pixel * static_cast<float>(whole_per_work));
    }
    cv::fillPoly(sherds, std::vector<std::vector<cv::Point>>{outline}, 255);
    inspection.sherds.push_back(std::move(sherd));
    if (options.too_close_mm <= 0) continue;
    if (mayBeSeveral(pieces[i]))
      inspection.too_close.emplace_back(static_cast<int>(i), static_cast<int>(i));
    for (std::size_t k = 0; k < i; ++k)
      if (gapBetween_mm(pieces[k], pieces[i]) < options.too_close_mm)
        inspection.too_close.emplace_back(static_cast<int>(k), static_cast<int>(i));
  }
  measureLight(picture, sherds, inspection);
  return map;
}

}  // namespace

int markersNeeded(int on_plate) {
  return std::max(kLeastMarkers, (on_plate + 1) / 2);
}

Result<PlateInspection> inspectPlate(std::string_view picture, const batch::Plate& plate,
                                     const InspectionOptions& options) {
  Result<MappedInspection> mapped = inspectAndMap(picture, plate, options);
  if (!mapped) return mapped.error();
  return std::move(mapped->inspection);
}

Result<MappedInspection> inspectAndMap(std::string_view picture, const batch::Plate& plate,
                                       const InspectionOptions& options) {
  const Result<cv::Mat> whole = batch::decodePhotograph(picture, {});
  if (!whole) return whole.error();
  MappedInspection mapped;
  PlateInspection& inspection = mapped.inspection;
  inspection.width = whole->cols;
  inspection.height = whole->rows;
  inspection.markers_on_plate = static_cast<int>(plate.markers.size());
  cv::Mat work = *whole;
  if (whole->cols > options.work_width_px)
    cv::resize(
        *whole, work,
        {options.work_width_px, std::max(1, whole->rows * options.work_width_px / whole->cols)}, 0,
        0, cv::INTER_AREA);
  const double whole_per_work = static_cast<double>(whole->cols) / work.cols;
  const auto seen = markersOf(work, plate);
  if (!seen) return seen.error();
  inspection.markers_seen = static_cast<int>(seen->size());
  inspection.marks = marksOf(*seen, whole_per_work);
  inspection.sharpness = sharpnessOf(*whole, *seen, whole_per_work);
  const std::optional<Eigen::Matrix3d> plane = planeOf(*seen, plate);
  if (!plane) return mapped;
  mapped.map = findSherds(work, *plane, plate, options, whole_per_work, inspection);
  inspection.pixel_from_plate =
      Eigen::Vector3d(whole_per_work, whole_per_work, 1).asDiagonal() * *plane;
  addHidden(plate, *inspection.pixel_from_plate, inspection);
  return mapped;
}

std::optional<double> turnBetween_deg(const PlateInspection& before, const PlateInspection& after) {
  if (!before.pixel_from_plate || !after.pixel_from_plate) return std::nullopt;
  if (before.width != after.width || before.height != after.height) return std::nullopt;
  // Where the plate's points were that are now where its points are: a turn about the axis.
  const Eigen::Matrix3d before_from_after =
      before.pixel_from_plate->inverse() * *after.pixel_from_plate;
  double across = 0, along = 0;
  for (int k = 0; k < 36; ++k) {
    const double angle = 2 * std::numbers::pi * k / 36;
    const Eigen::Vector2d p = 100 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector3d q = before_from_after * Eigen::Vector3d(p.x(), p.y(), 1);
    const Eigen::Vector2d r = q.head<2>() / q.z();
    across += p.x() * r.y() - p.y() * r.x();
    along += p.dot(r);
  }
  if (!std::isfinite(across) || !std::isfinite(along)) return std::nullopt;
  return std::atan2(across, along) * kDegrees;
}

}  // namespace ostraka::capture
