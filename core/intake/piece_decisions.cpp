#include "intake/piece_decisions.h"

#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/uuid.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "records/records.h"
#include "records/words.h"
#include "store/database.h"
#include "store/statement.h"

namespace ostraka::records {

template <>
struct Words<intake::PieceVerdict> {
  static constexpr std::array<const char*, 3> all = {"join", "cut", "withdraw"};
};

}  // namespace ostraka::records

namespace ostraka::intake {

namespace {

using nlohmann::json;

json pairOf(const Eigen::Vector2d& point) {
  return json::array({point.x(), point.y()});
}

Eigen::Vector2d pointFrom(const json& pair) {
  return {numberIn(pair.at(0), "place_mm"), numberIn(pair.at(1), "place_mm")};
}

std::string piecesText(const PieceDecision& d) {
  json pieces = json::array();
  for (const NamedPiece& piece : d.pieces)
    pieces.push_back({{"name", piece.name}, {"place_mm", pairOf(piece.place_mm)}});
  return pieces.dump();
}

std::string cutText(const PieceDecision& d) {
  json cut = json::array();
  if (d.verdict == PieceVerdict::Cut)
    for (const Eigen::Vector2d& point : d.cut_mm) cut.push_back(pairOf(point));
  return cut.dump();
}

// What this file wrote; a text that was changed from outside leaves the fields empty.
void readTexts(PieceDecision& d, const std::string& pieces, const std::string& cut) {
  d.pieces.clear();
  d.cut_mm = PieceDecision().cut_mm;
  try {
    for (const json& piece : jsonOrDiscarded(pieces))
      d.pieces.push_back({piece.at("name").get<std::string>(), pointFrom(piece.at("place_mm"))});
    const json line = jsonOrDiscarded(cut);
    if (line.size() == 2) d.cut_mm = {pointFrom(line[0]), pointFrom(line[1])};
  } catch (const json::exception&) {
    d.pieces.clear();
  }
}

void check(store::Database& database, const PieceDecision& d,
           const records::Provenance& provenance) {
  if (!provenance.person)
    store::refuse(message("A decision needs the name of the person who makes it."));
  if (d.verdict == PieceVerdict::Join && d.pieces.size() < 2)
    store::refuse(message("A merge needs two or more fragments."));
  if (d.verdict == PieceVerdict::Cut && d.pieces.size() != 1)
    store::refuse(message("A split needs exactly one fragment."));
  if (d.verdict != PieceVerdict::Withdraw) return;
  store::Statement row =
      database.sql("SELECT 1 FROM piece_decision WHERE row = ? AND batch = ?", d.replaces, d.batch);
  if (!row.next()) store::refuse(message("The decision to undo is not in this batch."));
}

}  // namespace

Result<PieceDecisionRow> decidePieces(catalogue::Catalogue& catalogue, const PieceDecision& d,
                                      const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    check(database, d, provenance);
    database.run(
        "INSERT INTO piece_decision (id, decision, at, person, batch, side, verdict, pieces, "
        "cut_mm, "
        "replaces, note) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        newId(catalogue.now()), d.decision, catalogue.now(), provenance.person, d.batch,
        records::wordOf(d.side), records::wordOf(d.verdict), piecesText(d), cutText(d), d.replaces,
        d.note);
    return PieceDecisionRow{database.lastRow()};
  });
}

Result<std::vector<PieceDecision>> pieceDecisions(const catalogue::Catalogue& catalogue,
                                                  store::BatchRow batch) {
  return catalogue.database().asResult([&] {
    std::vector<PieceDecision> all;
    store::Statement rows = catalogue.database().sql(
        "SELECT row, decision, batch, side, verdict, pieces, cut_mm, person, replaces, note, at "
        "FROM "
        "piece_decision WHERE batch = ? ORDER BY row",
        batch);
    std::string side, verdict, pieces, cut;
    for (PieceDecision d; rows.read(d.row, d.decision, d.batch, side, verdict, pieces, cut, d.by,
                                    d.replaces, d.note, d.at_ms);) {
      d.side = records::fromWord<batch::Side>(side);
      d.verdict = records::fromWord<PieceVerdict>(verdict);
      readTexts(d, pieces, cut);
      all.push_back(d);
    }
    return all;
  });
}

}  // namespace ostraka::intake
