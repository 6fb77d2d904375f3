#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::intake {

using PieceDecisionRow = store::RowOf<struct PieceDecisionTag>;

enum class PieceVerdict {
  Join,     ///< these pieces of one side are one sherd
  Cut,      ///< this piece is two sherds, parted along a line
  Withdraw  ///< what it replaces holds no longer
};

/// A piece as it was called then, and its place on the side's plate: names change when a side is
/// computed anew, places do not.
struct NamedPiece {
  std::string name;
  Eigen::Vector2d place_mm = Eigen::Vector2d::Zero();
};

/// One row of the append-only list beside the pair decisions.
struct PieceDecision {
  PieceDecisionRow row;
  std::string decision;  ///< its id in the batch's decisions.json
  store::BatchRow batch;
  batch::Side side = batch::Side::Front;
  PieceVerdict verdict = PieceVerdict::Join;
  std::vector<NamedPiece> pieces;            ///< Join: two or more. Cut: one
  std::array<Eigen::Vector2d, 2> cut_mm = {  ///< Cut: the line, on the side's plate
      Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  store::PersonRow by;
  PieceDecisionRow replaces;  ///< Withdraw
  std::string note;
  std::int64_t at_ms = 0;
};

/// Adds a row; the scans follow when the batch is computed again. Errors: refusals as sentences
/// (no person, a wrong number of pieces, a withdrawal of what is not in this batch).
Result<PieceDecisionRow> decidePieces(catalogue::Catalogue& catalogue,
                                      const PieceDecision& decision,
                                      const records::Provenance& provenance);
/// All of a batch, oldest first.
Result<std::vector<PieceDecision>> pieceDecisions(const catalogue::Catalogue& catalogue,
                                                  store::BatchRow batch);

}  // namespace ostraka::intake
