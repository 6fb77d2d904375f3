#include <string>

#include "decisions/decided_pairs.h"
#include "decisions/piece_edits.h"
#include "must.h"
#include "targets.h"

namespace ostraka::fuzz {

void decisions(std::string_view bytes) {
  const Result<decisions::Decisions> read = decisions::parseDecisions(bytes, "fuzz.json");
  mustNameItself(read);
  if (!read) return;
  const decisions::Decisions holding = decisions::standing(*read);
  must(holding.size() <= read->size(), "nothing stands that was not said");
  decisions::CandidateTable table;
  table.fronts = {{batch::Side::Front, "f001", {0, 0}}, {batch::Side::Front, "f002", {50, 0}}};
  table.backs = {{batch::Side::Back, "b001", {0, 0}}, {batch::Side::Back, "b002", {50, 0}}};
  const decisions::Settled settled = decisions::settledBy(holding, table);
  must(settled.pairs.size() <= 2, "no scan is paired twice");
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    must(decisions::editedPieces({}, side, holding).scans.empty(), "of no scan no piece is made");
    (void)decisions::hasEdits(holding, side);
  }
  const Result<decisions::Decisions> again =
      decisions::parseDecisions(decisions::textOf(*read), "again.json");
  must(again.has_value() && again->size() == read->size(), "what was read is written and read");
}

}  // namespace ostraka::fuzz
