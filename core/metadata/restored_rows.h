#pragma once
#include <map>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/records.h"

/// For reading back what another catalogue exported: rows keep the ids that they had there.
namespace ostraka::metadata {

/// The ids of a batch's rows.
struct BatchIds {
  std::map<store::PhotographRow, std::string> photographs;
  std::map<store::ScanRow, std::string> scans;
  std::map<store::DecisionRow, std::string> decisions;
};
Result<BatchIds> idsOf(const catalogue::Catalogue& catalogue, store::BatchRow batch);

/// As save() adds it, with the id that it had. Errors: as save(), an id that is there already.
Result<store::PhotographRow> restorePhotograph(const catalogue::Catalogue& catalogue,
                                               const records::PhotographRecord& photograph,
                                               const std::string& id,
                                               const records::Provenance& provenance);
/// Likewise, with its state.
Result<store::ScanRow> restoreScan(const catalogue::Catalogue& catalogue,
                                   const records::ScanRecord& scan, const std::string& id,
                                   const records::Provenance& provenance);
/// A decision about pieces as its row says it, with ids in place of rows.
struct PieceRow {
  std::string id, decision, by, side, verdict, pieces_json, cut_json, replaces, note;
  std::int64_t at_ms = 0;
};
Result<std::vector<PieceRow>> pieceRows(const catalogue::Catalogue& catalogue,
                                        store::BatchRow batch);
/// by: who that person is here. No decisions.json here has it, as of restoreDecision.
Result<void> restorePieceRow(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                             store::PersonRow by, const PieceRow& row);
/// What a sherd was made from.
Result<void> restoreScans(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                          store::ScanRow front, store::ScanRow back);

}  // namespace ostraka::metadata
