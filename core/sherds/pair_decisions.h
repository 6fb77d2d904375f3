#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"

namespace ostraka::sherds {

/// Which fronts and backs belong together, as the program and persons decided. Rows are only added.
class PairDecisions : public catalogue::Subject {
 public:
  using catalogue::Subject::Subject;

  Result<std::vector<records::PairDecision>> all(store::BatchRow) const;  ///< oldest first
  /// What counts now, one per pair or lone scan: persons before the program, later before earlier.
  Result<std::vector<records::PairDecision>> current(store::BatchRow) const;
  /// The draft sherds of the batch follow.
  Result<store::DecisionRow> add(const records::PairDecision&, const records::Provenance&);
};

/// For reading back what another catalogue exported: with its id, time and person; sherds and scans
/// do not follow it, and no decisions.json here has it.
Result<store::DecisionRow> restoreDecision(const catalogue::Catalogue& catalogue,
                                           const records::PairDecision& decision);

/// Why a sherd is void, for a person: the program's own reason is translated, a typed one is not.
Message voidReason(const std::string& reason);

}  // namespace ostraka::sherds
