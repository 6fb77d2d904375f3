#pragma once
#include <map>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"

/// For reading back what another catalogue exported: rows keep the ids that they had there.
namespace ostraka::catalogue {

/// The ids of a batch's rows.
struct BatchIds {
  std::map<PhotographRow, std::string> photographs;
  std::map<ScanRow, std::string> scans;
  std::map<DecisionRow, std::string> decisions;
};
Result<BatchIds> idsOf(const Catalogue& catalogue, BatchRow batch);

/// As save() adds it, with the id that it had. Errors: as save(), an id that is there already.
Result<PhotographRow> restorePhotograph(Catalogue& catalogue, const PhotographRecord& photograph,
                                        const std::string& id, const Provenance& provenance);
/// Likewise, with its state.
Result<ScanRow> restoreScan(Catalogue& catalogue, const ScanRecord& scan, const std::string& id,
                            const Provenance& provenance);
/// With its time and person; sherds and scans do not follow it.
Result<DecisionRow> restoreDecision(Catalogue& catalogue, const PairDecision& decision,
                                    const std::string& id);
/// A decision about pieces as its row says it, with ids in place of rows.
struct PieceRow {
  std::string id, by, side, verdict, pieces_json, cut_json, replaces, note;
  std::int64_t at_ms = 0;
};
Result<std::vector<PieceRow>> pieceRows(const Catalogue& catalogue, BatchRow batch);
/// by: who that person is here.
Result<void> restorePieceRow(Catalogue& catalogue, BatchRow batch, PersonRow by,
                             const PieceRow& row);
/// What a sherd was made from.
Result<void> restoreScans(Catalogue& catalogue, SherdRow sherd, ScanRow front, ScanRow back);

}  // namespace ostraka::catalogue
