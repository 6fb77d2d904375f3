#include "intake/review_decisions.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue/catalogue.h"
#include "catalogue/places.h"
#include "decisions/decided_pairs.h"
#include "intake/edited_pieces.h"
#include "intake/piece_decisions.h"
#include "records/sherd.h"
#include "review/review.h"
#include "sherds/kept_models.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "upkeep/project.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using decisions::DecisionKind;
using store::valueOrThrow;

// The rows of this decision, of pairs or of pieces, that were not taken back.
template <class Row>
std::vector<Row> rowsOf(const std::vector<Row>& all, const std::string& id) {
  using Kind = decltype(Row::verdict);
  std::vector<Row> rows;
  for (const Row& row : all)
    if (row.verdict != Kind::Withdraw && row.decision == id) rows.push_back(row);
  std::erase_if(rows, [&](const Row& row) {
    return std::ranges::any_of(all, [&](const Row& other) {
      return other.verdict == Kind::Withdraw && other.replaces == row.row;
    });
  });
  return rows;
}

template <class Row>
Row takenBack(const Row& earlier, const std::string& by_decision, const std::string& note) {
  Row back = earlier;
  back.row = {};
  back.decision = by_decision;
  back.verdict = decltype(back.verdict)::Withdraw;
  back.replaces = earlier.row;
  back.note = note;
  return back;
}

void withdraw(catalogue::Catalogue& catalogue, store::BatchRow batch,
              const decisions::PairDecision& decision, const records::Provenance& provenance) {
  const auto all = valueOrThrow(sherds::PairDecisions(catalogue).all(batch));
  const auto pieces = valueOrThrow(pieceDecisions(catalogue, batch));
  for (const std::string& id : decision.replaces) {
    for (const records::PairDecision& row : rowsOf(all, id))
      valueOrThrow(sherds::PairDecisions(catalogue).add(takenBack(row, decision.id, decision.note),
                                                        provenance));
    for (const PieceDecision& row : rowsOf(pieces, id))
      valueOrThrow(decidePieces(catalogue, takenBack(row, decision.id, decision.note), provenance));
  }
}

// By its place, as the results are; by its name where no place is known.
const records::ScanRecord* scanOf(const std::vector<records::ScanRecord>& scans,
                                  const decisions::ScanRef& ref) {
  std::vector<const records::ScanRecord*> there;
  std::vector<decisions::ScanRef> places;
  for (const records::ScanRecord& scan : scans) {
    if (!scan.isThere() || !scan.plate_x_mm || !scan.plate_y_mm) continue;
    there.push_back(&scan);
    places.push_back({scan.side, scan.name, {*scan.plate_x_mm, *scan.plate_y_mm}, {}});
  }
  if (const int nearest = resolved(ref, places); nearest >= 0)
    return there[static_cast<std::size_t>(nearest)];
  const auto named = std::ranges::find_if(scans, [&](const records::ScanRecord& s) {
    return s.side == ref.side && s.name == ref.id && !(s.plate_x_mm && s.plate_y_mm);
  });
  return named == scans.end() ? nullptr : &*named;
}

// What the program calls the results: none where there is no such table.
using Table = std::optional<decisions::CandidateTable>;

Result<Table> tableOf(const fs::path& output) {
  Result<decisions::CandidateTable> read = decisions::readCandidatesOf(output);
  if (read) return Table(std::move(*read));
  return read.error().code == ErrorCode::Missing ? Result<Table>(Table()) : read.error();
}

// The scan that is meant in these results, as the chain understood it.
const records::ScanRecord* scanIn(const Table& table, const std::vector<records::ScanRecord>& scans,
                                  const decisions::ScanRef& ref) {
  if (!table) return scanOf(scans, ref);
  const auto& side = ref.side == batch::Side::Front ? table->fronts : table->backs;
  const int index = resolved(ref, side);
  return index < 0 ? nullptr : scanOf(scans, side[static_cast<std::size_t>(index)]);
}

// A pair needs both scans; of several that are set aside each has a row. Empty: no effect.
std::vector<records::PairDecision> rowsFor(store::BatchRow batch,
                                           const decisions::PairDecision& decision,
                                           const Table& table,
                                           const std::vector<records::ScanRecord>& scans) {
  std::vector<records::PairDecision> rows;
  records::PairDecision row;
  row.batch = batch;
  row.front_from_back = decision.front_from_back;
  row.decision = decision.id;
  row.note = decision.note;
  row.verdict = decision.kind == DecisionKind::Pair    ? records::Verdict::Accept
                : decision.kind == DecisionKind::Aside ? records::Verdict::Aside
                                                       : records::Verdict::Reshoot;
  for (const decisions::ScanRef& ref : decision.scans) {
    const records::ScanRecord* scan = scanIn(table, scans, ref);
    if (scan == nullptr) continue;
    (ref.side == batch::Side::Front ? row.front : row.back) = scan->row;
    if (decision.kind == DecisionKind::Pair) continue;
    rows.push_back(row);
    row.front = row.back = {};
  }
  if (row.front && row.back) rows.push_back(row);
  return rows;
}

// Pieces are kept by name and place: their scans come and go with each computation.
Result<PieceDecisionRow> enterPieces(catalogue::Catalogue& catalogue, store::BatchRow batch,
                                     const decisions::PairDecision& decision,
                                     const records::Provenance& provenance) {
  PieceDecision row;
  row.batch = batch;
  row.side = decision.scans.empty() ? batch::Side::Front : decision.scans.front().side;
  row.verdict = decision.kind == DecisionKind::Join ? PieceVerdict::Join : PieceVerdict::Cut;
  for (const decisions::ScanRef& ref : decision.scans) row.pieces.push_back({ref.id, ref.place_mm});
  row.cut_mm = decision.cut_mm;
  row.decision = decision.id;
  row.note = decision.note;
  return decidePieces(catalogue, row, provenance);
}

bool isOfPieces(const decisions::PairDecision& d) {
  return d.kind == DecisionKind::Join || d.kind == DecisionKind::Split;
}

// It stands, and has no effect since its side was photographed again.
bool isOfOtherPhotographs(const decisions::PairDecision& d,
                          const decisions::CandidateTable& table) {
  if (d.scans.empty()) return false;
  const decisions::ScanRef& ref = d.scans.front();
  const std::vector<decisions::ScanRef>& now =
      ref.side == batch::Side::Front ? table.fronts : table.backs;
  return !now.empty() && !now.front().photographs.empty() && !ref.photographs.empty() &&
         now.front().photographs != ref.photographs;
}

// Brings what the catalogue holds of one decisions.json in line with it.
class Following {
 public:
  Following(catalogue::Catalogue& catalogue, store::BatchRow batch, const decisions::Decisions& all,
            const Table& table)
      : catalogue_(catalogue), batch_(batch), all_(all), standing_(decisions::standing(all)) {
    want(table, valueOrThrow(catalogue::Batches(catalogue).scans(batch)));
  }

  /// How many were added.
  int rows() {
    pieces();
    const std::vector<records::PairDecision> held =
        valueOrThrow(sherds::PairDecisions(catalogue_).all(batch_));
    for (const Wanted& wanted : wanted_)
      if (!isAmong(rowsOf(held, wanted.of->id), wanted.row))
        count(sherds::PairDecisions(catalogue_).add(wanted.row, actOf(*wanted.of)));
    std::map<store::DecisionRow, const decisions::PairDecision*> stale;
    for (const decisions::PairDecision& d : all_)
      for (const records::PairDecision& row : rowsOf(held, d.id))
        if (!isWanted(d, row)) stale[row.row] = &d;
    while (takeBack(stale)) {
    }
    return added_;
  }

 private:
  struct Wanted {
    const decisions::PairDecision* of;
    records::PairDecision row;
  };

  // As the chain does it: of two that are about one scan the later holds.
  void want(const Table& table, const std::vector<records::ScanRecord>& scans) {
    std::set<store::ScanRow> claimed;
    for (auto d = standing_.rbegin(); d != standing_.rend(); ++d) {
      if (isOfPieces(*d)) continue;
      const std::vector<records::PairDecision> rows = rowsFor(batch_, *d, table, scans);
      const bool free = std::ranges::none_of(rows, [&](const records::PairDecision& row) {
        return claimed.contains(row.front) || claimed.contains(row.back);
      });
      for (const records::PairDecision& row : rows)
        for (const store::ScanRow scan : {row.front, row.back})
          if (scan) claimed.insert(scan);
      for (std::size_t i = rows.size(); free && i-- > 0;) wanted_.push_back({&*d, rows[i]});
    }
    std::reverse(wanted_.begin(), wanted_.end());
  }

  static bool isAmong(const std::vector<records::PairDecision>& rows,
                      const records::PairDecision& row) {
    return std::ranges::any_of(rows, [&](const records::PairDecision& other) {
      return other.verdict == row.verdict && other.front == row.front && other.back == row.back;
    });
  }
  bool isWanted(const decisions::PairDecision& d, const records::PairDecision& row) const {
    return std::ranges::any_of(wanted_, [&](const Wanted& wanted) {
      return wanted.of->id == d.id && isAmong({wanted.row}, row);
    });
  }

  // Of what holds no more those rows that count; one that a later row is above of does no harm,
  // and counts again where that is taken back. What was below may count then.
  bool takeBack(std::map<store::DecisionRow, const decisions::PairDecision*>& stale) {
    bool any = false;
    for (const records::PairDecision& counts :
         valueOrThrow(sherds::PairDecisions(catalogue_).current(batch_))) {
      const auto found = stale.find(counts.row);
      if (found == stale.end()) continue;
      const End end = endOf(*found->second, counts.by);
      count(sherds::PairDecisions(catalogue_)
                .add(takenBack(counts, end.decision, end.note), end.provenance));
      stale.erase(found);
      any = true;
    }
    return any;
  }

  // Where the pieces of a join are now is asked by the chain alone.
  void pieces() {
    const std::vector<PieceDecision> held = valueOrThrow(pieceDecisions(catalogue_, batch_));
    for (const decisions::PairDecision& d : all_) {
      if (!isOfPieces(d)) continue;
      const std::vector<PieceDecision> rows = rowsOf(held, d.id);
      const bool holds = std::ranges::any_of(
          standing_, [&](const decisions::PairDecision& s) { return s.id == d.id; });
      if (holds && rows.empty()) count(enterPieces(catalogue_, batch_, d, actOf(d)));
      if (holds) continue;
      for (const PieceDecision& row : rows) {
        const End end = endOf(d, row.by);
        count(decidePieces(catalogue_, takenBack(row, end.decision, end.note), end.provenance));
      }
    }
  }

  records::Provenance actOf(const decisions::PairDecision& d) {
    return {valueOrThrow(catalogue::People(catalogue_).byInitials(d.by, {})), "window", d.note};
  }
  // Who took it back, and by which decision; nobody did where its scans are gone.
  struct End {
    records::Provenance provenance;
    std::string decision, note;
  };
  End endOf(const decisions::PairDecision& d, store::PersonRow by) {
    for (auto end = all_.rbegin(); end != all_.rend(); ++end)
      if (end->kind == DecisionKind::Withdraw &&
          std::find(end->replaces.begin(), end->replaces.end(), d.id) != end->replaces.end())
        return {actOf(*end), end->id, end->note};
    return {{by, "process", {}}, {}, "It does not hold for the current results."};
  }
  template <class T>
  void count(const Result<T>& row) {
    if (!row) throw store::Refused(row.error());
    ++added_;
  }

  catalogue::Catalogue& catalogue_;
  store::BatchRow batch_;
  const decisions::Decisions& all_;
  decisions::Decisions standing_;
  std::vector<Wanted> wanted_;
  int added_ = 0;
};

}  // namespace

Result<void> enterDecision(catalogue::Catalogue& catalogue, const std::string& batch_number,
                           const decisions::PairDecision& decision, const fs::path& output) {
  const bool finds_scans = decision.kind != DecisionKind::Withdraw && !isOfPieces(decision);
  const Result<Table> table = finds_scans ? tableOf(output) : Table();
  if (!table) return table.error();
  return catalogue.database().inTransaction([&] {
    const store::BatchRow batch =
        valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number)).row;
    const records::Provenance provenance{
        valueOrThrow(catalogue::People(catalogue).byInitials(decision.by, {})), "window",
        decision.note};
    if (decision.kind == DecisionKind::Withdraw)
      return withdraw(catalogue, batch, decision, provenance);
    if (isOfPieces(decision)) {
      valueOrThrow(enterPieces(catalogue, batch, decision, provenance));
      return;
    }
    const auto missing = [&](Message what) {
      throw store::Refused({ErrorCode::Missing, std::move(what), batch_number});
    };
    if (*table)  // of earlier photographs, or about a piece that is gone
      if (const auto meant = decisions::settledBy({decision}, **table); !meant.warnings.empty())
        missing(meant.warnings.front());
    const auto scans = valueOrThrow(catalogue::Batches(catalogue).scans(batch));
    for (const decisions::ScanRef& ref : decision.scans)
      if (scanIn(*table, scans, ref) == nullptr)
        missing(
            message("The decision is saved with the batch, but %1 is not in the catalogue "
                    "yet; it is added with the next results.",
                    ref.id));
    for (const records::PairDecision& row : rowsFor(batch, decision, *table, scans))
      valueOrThrow(sherds::PairDecisions(catalogue).add(row, provenance));
  });
}

Result<int> followDecisions(catalogue::Catalogue& catalogue, const std::string& batch_number,
                            const fs::path& output) {
  const Result<decisions::Decisions> all = decisions::readDecisions(output);
  if (!all) return all.error();
  const Result<Table> table = tableOf(output);
  if (!table) return table.error();
  const auto batch = catalogue::Batches(catalogue).byNumber(batch_number);
  if (!batch) return batch.error();
  return catalogue.database().inTransaction(
      [&] { return Following(catalogue, batch->row, *all, *table).rows(); });
}

Result<int> catchUp(const fs::path& project, const std::string& batch_number,
                    const fs::path& output) {
  if (!review::computedToItsEnd(output)) return 0;
  Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(project);
  if (!catalogue) return catalogue.error();
  const Result<records::BatchRecord> batch = catalogue::Batches(*catalogue).byNumber(batch_number);
  if (!batch) return 0;  // nothing of it is entered
  const bool computed =
      batch->state == records::BatchState::Review || batch->state == records::BatchState::Done;
  if (!computed) return 0;  // what computes it enters them with its results
  return followDecisions(*catalogue, batch_number, output);
}

Result<std::set<store::ScanRow>> piecesTakenBack(const catalogue::Catalogue& catalogue,
                                                 store::BatchRow batch, const fs::path& output) {
  const auto all = decisions::readDecisions(output);
  if (!all) return all.error();
  const auto scans = catalogue::Batches(catalogue).scans(batch);
  if (!scans) return scans.error();
  const decisions::Decisions hold = decisions::standing(*all);
  std::set<store::ScanRow> pieces;
  decisions::Decisions computed_with = decisions::followed(*all, output);
  if (const Result<decisions::CandidateTable> table = decisions::readCandidatesOf(output))
    std::erase_if(computed_with, [&](const auto& d) { return isOfOtherPhotographs(d, *table); });
  for (const decisions::PairDecision& d : computed_with)
    if (isOfPieces(d) && !d.scans.empty() && !decisions::containedIn(hold, d))
      for (const store::ScanRow scan : madeBy(d, computed_with, *scans)) pieces.insert(scan);
  return pieces;
}

Result<void> forgetModelsOf(catalogue::Catalogue& catalogue, store::BatchRow batch,
                            const std::set<store::ScanRow>& pieces,
                            const records::Provenance& provenance) {
  if (pieces.empty()) return {};
  return catalogue.database().inTransaction([&] {
    const sherds::Sherds all(catalogue);
    for (const records::SherdRecord& sherd : valueOrThrow(all.of(valueOrThrow(all.rows(batch)))))
      if (pieces.contains(sherd.front) || pieces.contains(sherd.back))
        sherds::forgetModel(catalogue, sherd.row, provenance);
  });
}

Result<void> forgetPiecesOf(catalogue::Catalogue& catalogue, const std::string& batch_number,
                            const decisions::PairDecision& withdrawal, const fs::path& output) {
  return catalogue.database().asResult([&] {
    const auto batch = valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number)).row;
    const auto pieces = valueOrThrow(piecesTakenBack(catalogue, batch, output));
    const auto person = valueOrThrow(catalogue::People(catalogue).byInitials(withdrawal.by, {}));
    valueOrThrow(forgetModelsOf(catalogue, batch, pieces, {person, "window", withdrawal.note}));
  });
}

}  // namespace ostraka::intake
