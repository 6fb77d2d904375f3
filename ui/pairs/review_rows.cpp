#include "ui/pairs/review_rows.h"

#include <QStringList>
#include <algorithm>

#include "ui/pairs/free_words.h"
#include "ui/pairs/review_words.h"

namespace ostraka::ui {
namespace {

using review::CardState;

}  // namespace

std::vector<ReviewRow> rowsOf(const review::Review& review) {
  std::vector<ReviewRow> rows;
  for (const review::ReviewCard& card : review.cards)
    rows.push_back({card.front, card.back, card.state});
  const auto settled = std::find_if(rows.begin(), rows.end(),
                                    [](const ReviewRow& row) { return !row.wantsPerson(); });
  std::vector<ReviewRow> lone;
  for (const int back : review.lone_backs) lone.push_back({-1, back, CardState::Alone});
  rows.insert(settled, lone.begin(), lone.end());
  for (const int back : review.aside_backs) rows.push_back({-1, back, CardState::Aside});
  for (const int back : review.reshoot_backs) rows.push_back({-1, back, CardState::Reshoot});
  return rows;
}

QString rowName(const ReviewRow& row, const decisions::CandidateTable& table) {
  const QString front = nameOf(table.fronts, row.front), back = nameOf(table.backs, row.back);
  if (row.isLoneBack()) return back;
  return row.back < 0 ? front : tr("%1 – %2").arg(front, back);
}

void markPieces(std::vector<ReviewRow>& rows, const decisions::CandidateTable& table,
                const decisions::Decisions& all, const decisions::Decisions& followed) {
  for (const decisions::PairDecision& d : decisions::standing(all)) {
    const bool join = d.kind == decisions::DecisionKind::Join;
    if (!join && d.kind != decisions::DecisionKind::Split) continue;
    if (decisions::containedIn(followed, d)) continue;
    for (ReviewRow& row : rows) {
      bool here = false;
      QStringList others;
      for (const decisions::ScanRef& ref : d.scans) {
        const bool front = ref.side == batch::Side::Front;
        const int scan = decisions::resolved(ref, front ? table.fronts : table.backs);
        const bool mine = scan >= 0 && scan == (front ? row.front : row.back);
        here = here || mine;
        if (!mine) others << nameOf(ref);
      }
      if (!here) continue;
      row.change = join ? PieceChange::Joined : PieceChange::Cut;
      row.changed_by = QString::fromStdString(d.by);
      row.joined_with = others.join(QStringLiteral(", "));
    }
  }
}

QString pieceSentence(const ReviewRow& row) {
  switch (row.change) {
    case PieceChange::Joined:
      return tr("Merged with %1 by %2. It is one fragment once the batch is reprocessed.")
          .arg(row.joined_with, row.changed_by);
    case PieceChange::Cut:
      return tr("Split by %1. Its fragments appear when the batch is reprocessed.")
          .arg(row.changed_by);
    case PieceChange::None:
      break;
  }
  return {};
}

QString rowWord(const ReviewRow& row) {
  if (row.change == PieceChange::Joined) return tr("Merged");
  if (row.change == PieceChange::Cut) return tr("Split");
  return row.isLoneBack() && row.state == CardState::Alone ? tr("No front") : stateWord(row.state);
}

QString loneBackSentence(const ReviewRow& row) {
  switch (row.state) {
    case CardState::Aside:
      return tr("This back is set aside. Drag it onto a front to use it after all.");
    case CardState::Reshoot:
      return tr("This back is to be reshot.");
    default:
      return tr(
          "No front holds this back. Drag it onto its front, merge it with another, or set it "
          "aside.");
  }
}

}  // namespace ostraka::ui
