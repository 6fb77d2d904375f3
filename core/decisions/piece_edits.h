#pragma once
#include <string>
#include <vector>

#include "base/message.h"
#include "decisions/decisions.h"
#include "scan/scan.h"

namespace ostraka::decisions {

struct EditedPieces {
  std::vector<scan::Scan> scans;
  std::vector<Message> warnings;  ///< edits that could not be done, whole sentences
};

/// The Join and Split decisions among `standing` that are about this side, in their order. A joined
/// piece keeps the first one's id; of a split piece the part on the left of the line from a to b
/// keeps the id, the other gets the next free number. Fractures are found anew. photographs: as in
/// ScanRef, of this side.
EditedPieces editedPieces(std::vector<scan::Scan> scans, batch::Side side,
                          const Decisions& standing, const std::string& photographs = {});

/// True when such decisions exist for this side.
bool hasEdits(const Decisions& standing, batch::Side side);

}  // namespace ostraka::decisions
