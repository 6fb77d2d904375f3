#pragma once
#include <vector>

#include "catalogue/records.h"
#include "pipeline/decisions.h"

namespace ostraka::catalogue {

/// For each piece that the catalogue knows the index of the one that it is now, -1 if it is gone.
/// A piece is known by its place, the nearest are matched first; without a place by its name.
/// `edits`: the Join and Split decisions about the photographs of `found`, those that were taken
/// back, too. They move a piece farther than anything else, and its first one keeps its name: what
/// is left over on both sides is the same piece if it has that name, and if one of the two lies
/// where such a decision says.
std::vector<int> samePieces(const std::vector<ScanRecord>& known,
                            const std::vector<ScanRecord>& found, const pipeline::Decisions& edits);

}  // namespace ostraka::catalogue
