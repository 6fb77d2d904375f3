#include "catalogue/review_decisions.h"

#include <algorithm>

#include "base/text.h"
#include "catalogue/catalogue.h"
#include "catalogue/piece_decisions.h"

namespace ostraka::catalogue {
namespace {

using pipeline::DecisionKind;

// Rows that stand for a decision say its number in the file, so that a withdrawal finds them, and
// its moment: a file on another computer, or one begun anew, counts from 1 as well.
std::string markOf(int number, const std::string& at) {
  return "decision " + std::to_string(number) + (at.empty() ? "" : " of " + at);
}

std::string marked(const pipeline::PairDecision& d) {
  return markOf(d.number, d.at) + (d.note.empty() ? "" : ": " + d.note);
}

bool begins(const std::string& note, const std::string& mark) {
  return note == mark || note.rfind(mark + ":", 0) == 0;
}

// An earlier program wrote the number only; a decision is entered after it was taken.
bool marksEarlierWay(const std::string& note, std::int64_t entered_ms, int number,
                     const std::string& at) {
  return begins(note, markOf(number, {})) && (at.empty() || utcDay(entered_ms) >= at.substr(0, 10));
}

// The rows of this decision, of pairs or of pieces.
template <class Row>
std::vector<Row> rowsOf(const std::vector<Row>& all, int number, const std::string& at) {
  std::vector<Row> exactly, earlier_way;
  for (const Row& row : all) {
    if (!row.by || row.verdict == decltype(row.verdict)::Withdraw) continue;
    if (begins(row.note, markOf(number, at)))
      exactly.push_back(row);
    else if (marksEarlierWay(row.note, row.at_ms, number, at))
      earlier_way.push_back(row);
  }
  return exactly.empty() ? earlier_way : exactly;
}

template <class Row>
Row takenBack(const Row& earlier, const std::string& note) {
  Row back = earlier;
  back.row = {};
  back.verdict = decltype(back.verdict)::Withdraw;
  back.replaces = earlier.row;
  back.note = note;
  return back;
}

Result<void> withdraw(Catalogue& catalogue, BatchRow batch, const pipeline::PairDecision& decision,
                      const Act& act) {
  const auto all = catalogue.decisions(batch);
  if (!all) return all.error();
  const auto pieces = pieceDecisions(catalogue, batch);
  if (!pieces) return pieces.error();
  for (std::size_t i = 0; i < decision.replaces.size(); ++i) {
    const int number = decision.replaces[i];
    const std::string at =
        i < decision.replaced_at.size() ? decision.replaced_at[i] : std::string();
    for (const PairDecision& row : rowsOf(*all, number, at))
      if (const auto done = catalogue.decide(takenBack(row, marked(decision)), act); !done)
        return done.error();
    for (const PieceDecision& row : rowsOf(*pieces, number, at))
      if (const auto done = decidePieces(catalogue, takenBack(row, marked(decision)), act); !done)
        return done.error();
  }
  return {};
}

// By its place, as the results are; by its name where no place is known.
const ScanRecord* scanOf(const std::vector<ScanRecord>& scans, const pipeline::ScanRef& ref) {
  std::vector<const ScanRecord*> there;
  std::vector<pipeline::ScanRef> places;
  for (const ScanRecord& scan : scans) {
    if (!scan.isThere() || !scan.plate_x_mm || !scan.plate_y_mm) continue;
    there.push_back(&scan);
    places.push_back({scan.side, scan.name, {*scan.plate_x_mm, *scan.plate_y_mm}, {}});
  }
  if (const int nearest = resolved(ref, places); nearest >= 0)
    return there[static_cast<std::size_t>(nearest)];
  const auto named = std::find_if(scans.begin(), scans.end(), [&](const ScanRecord& s) {
    return s.side == ref.side && s.name == ref.id && !(s.plate_x_mm && s.plate_y_mm);
  });
  return named == scans.end() ? nullptr : &*named;
}

// Pieces are kept by name and place: their scans come and go with each computation.
Result<void> enterPieces(Catalogue& catalogue, BatchRow batch,
                         const pipeline::PairDecision& decision, const Act& act) {
  PieceDecision row;
  row.batch = batch;
  row.side = decision.scans.empty() ? batch::Side::Front : decision.scans.front().side;
  row.verdict = decision.kind == DecisionKind::Join ? PieceVerdict::Join : PieceVerdict::Cut;
  for (const pipeline::ScanRef& ref : decision.scans) row.pieces.push_back({ref.id, ref.place_mm});
  row.cut_mm = decision.cut_mm;
  row.note = marked(decision);
  const auto entered = decidePieces(catalogue, row, act);
  return entered ? Result<void>() : Result<void>(entered.error());
}

}  // namespace

Result<void> enterDecision(Catalogue& catalogue, const std::string& batch_number,
                           const pipeline::PairDecision& decision) {
  return catalogue.together([&]() -> Result<void> {
    const auto batch = catalogue.batchByNumber(batch_number);
    if (!batch) return batch.error();
    const auto person = catalogue.personByInitials(decision.by, {});
    if (!person) return person.error();
    const Act act{*person, "window", decision.note};
    if (decision.kind == DecisionKind::Withdraw)
      return withdraw(catalogue, batch->row, decision, act);
    if (decision.kind == DecisionKind::Join || decision.kind == DecisionKind::Split)
      return enterPieces(catalogue, batch->row, decision, act);
    const auto scans = catalogue.scans(batch->row);
    if (!scans) return scans.error();
    PairDecision row;
    row.batch = batch->row;
    row.front_from_back = decision.front_from_back;
    row.note = marked(decision);
    row.verdict = decision.kind == DecisionKind::Pair    ? Verdict::Accept
                  : decision.kind == DecisionKind::Aside ? Verdict::Aside
                                                         : Verdict::Reshoot;
    for (const pipeline::ScanRef& ref : decision.scans) {
      const ScanRecord* scan = scanOf(*scans, ref);
      if (scan == nullptr)
        return Error{ErrorCode::Missing,
                     "The decision is saved with the batch, but " + ref.id +
                         " is not in the catalogue yet; it is entered with the next results.",
                     batch_number};
      (ref.side == batch::Side::Front ? row.front : row.back) = scan->row;
      if (decision.kind == DecisionKind::Pair) continue;
      if (const auto entered = catalogue.decide(row, act); !entered) return entered.error();
      row.front = row.back = {};
    }
    if (decision.kind != DecisionKind::Pair) return {};
    const auto entered = catalogue.decide(row, act);
    return entered ? Result<void>() : Result<void>(entered.error());
  });
}

Result<int> enterStanding(Catalogue& catalogue, const std::string& batch_number,
                          const std::filesystem::path& output) {
  const Result<pipeline::Decisions> all = pipeline::readDecisions(output);
  if (!all) return all.error();
  const auto batch = catalogue.batchByNumber(batch_number);
  if (!batch) return batch.error();
  const auto pairs = catalogue.decisions(batch->row);
  if (!pairs) return pairs.error();
  const auto pieces = pieceDecisions(catalogue, batch->row);
  if (!pieces) return pieces.error();
  int entered = 0;
  for (const pipeline::PairDecision& d : pipeline::standing(*all)) {
    if (!rowsOf(*pairs, d.number, d.at).empty() || !rowsOf(*pieces, d.number, d.at).empty())
      continue;
    const Result<void> done = enterDecision(catalogue, batch_number, d);
    if (!done && done.error().code != ErrorCode::Missing) return done.error();
    entered += done ? 1 : 0;
  }
  return entered;
}

Result<void> settleBatch(Catalogue& catalogue, const std::string& batch_number,
                         const std::string& person, bool nothing_to_do) {
  const auto batch = catalogue.batchByNumber(batch_number);
  if (!batch) return batch.error();
  if (batch->state != BatchState::Review && batch->state != BatchState::Done) return {};
  const BatchState state =
      nothing_to_do && batch->scale_doubts.empty() ? BatchState::Done : BatchState::Review;
  if (state == batch->state) return {};
  const auto row = catalogue.personByInitials(person, {});
  if (!row) return row.error();
  return catalogue.setBatchState(batch->row, state, {*row, "window", {}});
}

Result<void> queueAgain(Catalogue& catalogue, const std::string& batch_number,
                        const std::string& person) {
  const auto batch = catalogue.batchByNumber(batch_number);
  if (!batch) return batch.error();
  Act act;
  if (!person.empty()) {
    const auto row = catalogue.personByInitials(person, {});
    if (!row) return row.error();
    act.person = *row;
  }
  return catalogue.setBatchState(batch->row, BatchState::Queued, act);
}

}  // namespace ostraka::catalogue
