#include "metadata/restored_rows.h"

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/batches.h"
#include "records/words.h"
#include "store/database.h"

namespace ostraka::metadata {
namespace {

template <class Row>
std::map<Row, std::string> idsIn(store::Database& database, const char* query,
                                 store::BatchRow batch) {
  std::map<Row, std::string> ids;
  store::Statement rows = database.sql(query, batch);
  Row row;
  std::string id;
  while (rows.read(row, id)) ids[row] = id;
  return ids;
}

const std::string& wellFormed(const std::string& id) {
  if (!isUuid(id)) store::refuse(message("A uuid of the export is not well formed."), id);
  return id;
}

}  // namespace

Result<BatchIds> idsOf(const catalogue::Catalogue& catalogue, store::BatchRow batch) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    return BatchIds{
        idsIn<store::PhotographRow>(database, "SELECT row, id FROM photograph WHERE batch = ?",
                                    batch),
        idsIn<store::ScanRow>(database, "SELECT row, id FROM scan WHERE batch = ?", batch),
        idsIn<store::DecisionRow>(database, "SELECT row, id FROM pair_decision WHERE batch = ?",
                                  batch)};
  });
}

Result<store::PhotographRow> restorePhotograph(const catalogue::Catalogue& catalogue,
                                               const records::PhotographRecord& photograph,
                                               const std::string& id,
                                               const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    const store::PhotographRow row =
        store::valueOrThrow(catalogue::Batches(catalogue).save(photograph, provenance));
    database.run("UPDATE photograph SET id = ? WHERE row = ?", wellFormed(id), row);
    return row;
  });
}

Result<store::ScanRow> restoreScan(const catalogue::Catalogue& catalogue,
                                   const records::ScanRecord& scan, const std::string& id,
                                   const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    const store::ScanRow row =
        store::valueOrThrow(catalogue::Batches(catalogue).save(scan, provenance));
    database.run("UPDATE scan SET id = ?, state = ? WHERE row = ?", wellFormed(id),
                 records::wordOf(scan.state), row);
    return row;
  });
}

Result<std::vector<PieceRow>> pieceRows(const catalogue::Catalogue& catalogue,
                                        store::BatchRow batch) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    std::vector<PieceRow> all;
    store::Statement rows = database.sql(
        "SELECT d.id, d.decision, p.id, d.side, d.verdict, d.pieces, d.cut_mm, r.id, d.note, d.at "
        "FROM "
        "piece_decision d LEFT JOIN person p ON p.row = d.person LEFT JOIN piece_decision r ON "
        "r.row = d.replaces WHERE d.batch = ? ORDER BY d.row",
        batch);
    for (PieceRow row; rows.read(row.id, row.decision, row.by, row.side, row.verdict,
                                 row.pieces_json, row.cut_json, row.replaces, row.note, row.at_ms);)
      all.push_back(row);
    return all;
  });
}

Result<void> restorePieceRow(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                             store::PersonRow by, const PieceRow& row) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    database.run(
        "INSERT INTO piece_decision (id, decision, came_alone, at, person, batch, side, verdict, "
        "pieces, cut_mm, "
        "replaces, note) VALUES (?, ?, 1, ?, ?, ?, ?, ?, ?, ?, (SELECT row FROM piece_decision "
        "WHERE "
        "id = ?), ?)",
        wellFormed(row.id), row.decision.empty() ? row.decision : wellFormed(row.decision),
        row.at_ms, by, batch, row.side, row.verdict, row.pieces_json, row.cut_json, row.replaces,
        row.note);
  });
}

Result<void> restoreScans(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                          store::ScanRow front, store::ScanRow back) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    database.run("UPDATE sherd SET front = ?, back = ? WHERE row = ?", front, back, sherd);
  });
}

}  // namespace ostraka::metadata
