#pragma once
#include <Eigen/Core>
#include <map>
#include <vector>

#include "decisions/decisions.h"
#include "records/records.h"

namespace ostraka::intake {

/// For each piece that the catalogue knows the index of the one that it is now, -1 if it is gone.
/// A piece is known by its place, the nearest are matched first; without a place by its name.
/// `edits`: the Join and Split decisions about the photographs of `found`, those that were taken
/// back, too. They move a piece farther than anything else: of what is left over, the first part of
/// a join is the same piece as the joined one. A piece that was cut goes on as the half that lies
/// nearest to `typed_mm`, where the number of its sherd was typed, or else as the larger one; and
/// what is whole again is the piece that was known first.
std::vector<int> samePieces(const std::vector<records::ScanRecord>& known,
                            const std::vector<records::ScanRecord>& found,
                            const decisions::Decisions& edits,
                            const std::map<store::ScanRow, Eigen::Vector2d>& typed_mm = {});

}  // namespace ostraka::intake
