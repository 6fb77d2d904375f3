#pragma once
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "decisions/decisions.h"
#include "records/records.h"

namespace ostraka::intake {

/// Where a scan lies on its side's plate, mm; nothing where that is not known.
std::optional<Eigen::Vector2d> placeOf(const records::ScanRecord& scan);

/// The places of all pieces that the Joins among `edits` make one with those of `join`.
std::vector<Eigen::Vector2d> joinedPlaces(const decisions::PairDecision& join,
                                          const decisions::Decisions& edits);

/// A joined piece's mean lies between those of its parts: within kSamePiece_mm of their hull.
bool liesBetween(const Eigen::Vector2d& place_mm, const std::vector<Eigen::Vector2d>& parts_mm);

/// Indices of the two scans that are the halves of this Split: on either side of its line, with the
/// mean of the piece that was cut. Nothing where it is whole, or gone.
std::optional<std::pair<std::size_t, std::size_t>> halvesOf(
    const decisions::PairDecision& split, const std::vector<records::ScanRecord>& scans);

/// The pieces that this Join or Split made, as far as `scans` were computed with it.
std::vector<store::ScanRow> madeBy(const decisions::PairDecision& edit,
                                   const decisions::Decisions& edits,
                                   const std::vector<records::ScanRecord>& scans);

}  // namespace ostraka::intake
