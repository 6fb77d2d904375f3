// Joins and cuts move the means of pieces, and each computation names pieces anew: what an edit
// made is known by where it lies.
#include "intake/edited_pieces.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace ostraka::intake {
namespace {

using decisions::DecisionKind;
using decisions::kSamePiece_mm;
using Places = std::vector<Eigen::Vector2d>;

constexpr double kCrumb = 0.1;  // of a piece's points

bool isAmong(const Places& places, const Eigen::Vector2d& place_mm) {
  return std::ranges::any_of(
      places, [&](const Eigen::Vector2d& one) { return (one - place_mm).norm() < kSamePiece_mm; });
}

// Above 0 on the left of the line.
double acrossCut(const decisions::PairDecision& split, const Eigen::Vector2d& place_mm) {
  const Eigen::Vector2d along = split.cut_mm[1] - split.cut_mm[0];
  const Eigen::Vector2d to = place_mm - split.cut_mm[0];
  return along.x() * to.y() - along.y() * to.x();
}

}  // namespace

std::optional<Eigen::Vector2d> placeOf(const records::ScanRecord& scan) {
  if (!scan.plate_x_mm || !scan.plate_y_mm) return std::nullopt;
  return Eigen::Vector2d(*scan.plate_x_mm, *scan.plate_y_mm);
}

Places joinedPlaces(const decisions::PairDecision& join, const decisions::Decisions& edits) {
  Places places;
  for (const decisions::ScanRef& ref : join.scans) places.push_back(ref.place_mm);
  for (bool grew = true; grew;) {
    grew = false;
    for (const decisions::PairDecision& other : edits) {
      if (other.kind != DecisionKind::Join || other.scans.front().side != join.scans.front().side)
        continue;
      const auto has = [&](const decisions::ScanRef& ref) { return isAmong(places, ref.place_mm); };
      if (std::none_of(other.scans.begin(), other.scans.end(), has)) continue;
      for (const decisions::ScanRef& ref : other.scans)
        if (!has(ref)) {
          places.push_back(ref.place_mm);
          grew = true;
        }
    }
  }
  return places;
}

bool liesBetween(const Eigen::Vector2d& place_mm, const Places& parts_mm) {
  std::vector<cv::Point2f> parts, hull;
  for (const Eigen::Vector2d& part : parts_mm)
    parts.emplace_back(static_cast<float>(part.x()), static_cast<float>(part.y()));
  cv::convexHull(parts, hull);
  const cv::Point2f at(static_cast<float>(place_mm.x()), static_cast<float>(place_mm.y()));
  return cv::pointPolygonTest(hull, at, true) > -kSamePiece_mm;
}

std::optional<std::pair<std::size_t, std::size_t>> halvesOf(
    const decisions::PairDecision& split, const std::vector<records::ScanRecord>& scans) {
  const decisions::ScanRef& cut = split.scans.front();
  struct Piece {
    std::size_t index;
    Eigen::Vector2d place_mm;
  };
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < scans.size(); ++i)
    if (const auto place = placeOf(scans[i]);
        place && scans[i].isThere() && scans[i].side == cut.side)
      pieces.push_back({i, *place});
  std::optional<std::pair<std::size_t, std::size_t>> halves;
  double least_mm = std::numeric_limits<double>::infinity();
  for (const Piece& left : pieces)
    for (const Piece& right : pieces) {
      if (!(acrossCut(split, left.place_mm) > 0 && acrossCut(split, right.place_mm) < 0)) continue;
      const double n = scans[left.index].points.value_or(1);
      const double m = scans[right.index].points.value_or(1);
      const Eigen::Vector2d whole_mm = (n * left.place_mm + m * right.place_mm) / (n + m);
      const double apart_mm = (left.place_mm - right.place_mm).norm();
      if (apart_mm >= least_mm || (whole_mm - cut.place_mm).norm() >= kSamePiece_mm) continue;
      least_mm = apart_mm;
      halves = {left.index, right.index};
    }
  if (!halves) return halves;
  // Of any two pieces the mean may lie there; but where it is whole they are none of its halves. A
  // crumb between them is not it.
  const double together =
      scans[halves->first].points.value_or(0) + scans[halves->second].points.value_or(0);
  for (const Piece& piece : pieces)
    if (piece.index != halves->first && piece.index != halves->second &&
        (piece.place_mm - cut.place_mm).norm() < kSamePiece_mm &&
        scans[piece.index].points.value_or(1) >= kCrumb * together)
      return std::nullopt;
  return halves;
}

std::vector<store::ScanRow> madeBy(const decisions::PairDecision& edit,
                                   const decisions::Decisions& edits,
                                   const std::vector<records::ScanRecord>& scans) {
  if (edit.kind == DecisionKind::Split) {
    const auto halves = halvesOf(edit, scans);
    if (!halves) return {};
    return {scans[halves->first].row, scans[halves->second].row};
  }
  // The largest between the parts; of two that lie at parts' places neither is it.
  const Places parts = joinedPlaces(edit, edits);
  const records::ScanRecord* whole = nullptr;
  int at_parts = 0;
  for (const records::ScanRecord& scan : scans) {
    const auto place = placeOf(scan);
    if (!place || !scan.isThere() || scan.side != edit.scans.front().side) continue;
    at_parts += isAmong(parts, *place) ? 1 : 0;
    if (liesBetween(*place, parts) &&
        (whole == nullptr || scan.points.value_or(0) > whole->points.value_or(0)))
      whole = &scan;
  }
  return whole == nullptr || at_parts > 1 ? std::vector<store::ScanRow>() : std::vector{whole->row};
}

}  // namespace ostraka::intake
