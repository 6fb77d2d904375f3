#include "ui/review/catalogue_entry.h"

#include <algorithm>

#include "catalogue/catalogue.h"
#include "catalogue/piece_decisions.h"

namespace ostraka::ui {
namespace {

using catalogue::Catalogue;
using pipeline::DecisionKind;

// Rows that stand for a decision say its number in the file, so that a withdrawal finds them.
std::string marked(int number, const std::string& note) {
  return "decision " + std::to_string(number) + (note.empty() ? "" : ": " + note);
}

bool isMarked(const std::string& note, int number) {
  const std::string mark = marked(number, {});
  return note == mark || note.rfind(mark + ":", 0) == 0;
}

Result<void> withdraw(Catalogue& catalogue, catalogue::BatchRow batch,
                      const pipeline::PairDecision& decision, const catalogue::Act& act) {
  const auto all = catalogue.decisions(batch);
  if (!all) return all.error();
  for (const catalogue::PairDecision& earlier : *all) {
    const bool meant = std::any_of(decision.replaces.begin(), decision.replaces.end(),
                                   [&](int number) { return isMarked(earlier.note, number); });
    if (!meant || !earlier.by || earlier.verdict == catalogue::Verdict::Withdraw) continue;
    catalogue::PairDecision back = earlier;
    back.row = {};
    back.verdict = catalogue::Verdict::Withdraw;
    back.replaces = earlier.row;
    back.note = marked(decision.number, decision.note);
    if (const auto row = catalogue.decide(back, act); !row) return row.error();
  }
  const auto pieces = catalogue::pieceDecisions(catalogue, batch);
  if (!pieces) return pieces.error();
  for (const catalogue::PieceDecision& earlier : *pieces) {
    const bool meant = std::any_of(decision.replaces.begin(), decision.replaces.end(),
                                   [&](int number) { return isMarked(earlier.note, number); });
    if (!meant || earlier.verdict == catalogue::PieceVerdict::Withdraw) continue;
    catalogue::PieceDecision back = earlier;
    back.verdict = catalogue::PieceVerdict::Withdraw;
    back.replaces = earlier.row;
    back.note = marked(decision.number, decision.note);
    if (const auto row = catalogue::decidePieces(catalogue, back, act); !row) return row.error();
  }
  return {};
}

// Pieces are kept by name and place: their scans come and go with each computation.
Result<void> enterPieces(Catalogue& catalogue, catalogue::BatchRow batch,
                         const pipeline::PairDecision& decision, const catalogue::Act& act) {
  catalogue::PieceDecision row;
  row.batch = batch;
  row.side = decision.scans.empty() ? batch::Side::Front : decision.scans.front().side;
  row.verdict = decision.kind == DecisionKind::Join ? catalogue::PieceVerdict::Join
                                                    : catalogue::PieceVerdict::Cut;
  for (const pipeline::ScanRef& ref : decision.scans) row.pieces.push_back({ref.id, ref.place_mm});
  row.cut_mm = decision.cut_mm;
  row.note = marked(decision.number, decision.note);
  const auto entered = catalogue::decidePieces(catalogue, row, act);
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
    const catalogue::Act act{*person, "window", decision.note};
    if (decision.kind == DecisionKind::Withdraw)
      return withdraw(catalogue, batch->row, decision, act);
    if (decision.kind == DecisionKind::Join || decision.kind == DecisionKind::Split)
      return enterPieces(catalogue, batch->row, decision, act);
    const auto scans = catalogue.scans(batch->row);
    if (!scans) return scans.error();
    catalogue::PairDecision row;
    row.batch = batch->row;
    row.front_from_back = decision.front_from_back;
    row.note = marked(decision.number, decision.note);
    row.verdict = decision.kind == DecisionKind::Pair    ? catalogue::Verdict::Accept
                  : decision.kind == DecisionKind::Aside ? catalogue::Verdict::Aside
                                                         : catalogue::Verdict::Reshoot;
    for (const pipeline::ScanRef& ref : decision.scans) {
      const auto scan = std::find_if(scans->begin(), scans->end(), [&](const auto& s) {
        return s.side == ref.side && s.name == ref.id;
      });
      if (scan == scans->end())
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

Result<void> settleBatch(Catalogue& catalogue, const std::string& batch_number,
                         const std::string& person, bool nothing_to_do) {
  using catalogue::BatchState;
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
  catalogue::Act act;
  if (!person.empty()) {
    const auto row = catalogue.personByInitials(person, {});
    if (!row) return row.error();
    act.person = *row;
  }
  return catalogue.setBatchState(batch->row, catalogue::BatchState::Queued, act);
}

}  // namespace ostraka::ui
