#include "ui/review/review_rows.h"

#include <algorithm>

#include "ui/review/free_words.h"
#include "ui/review/review_words.h"

namespace ostraka::ui {
namespace {

using pipeline::CardState;

}  // namespace

std::vector<ReviewRow> rowsOf(const pipeline::Review& review) {
  std::vector<ReviewRow> rows;
  for (const pipeline::ReviewCard& card : review.cards)
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

ReviewFigures figuresOf(const pipeline::Review& review) {
  ReviewFigures figures;
  for (const pipeline::ReviewCard& card : review.cards) {
    figures.sherds += card.back >= 0 ? 1 : 0;
    figures.sure += card.state == CardState::Sure ? 1 : 0;
    figures.decided += card.state == CardState::Decided ? 1 : 0;
  }
  figures.ask = review.waiting();
  return figures;
}

QString rowName(const ReviewRow& row, const pipeline::CandidateTable& table) {
  const QString front = idOf(table.fronts, row.front), back = idOf(table.backs, row.back);
  if (row.isLoneBack()) return back;
  return row.back < 0 ? front : tr("%1 – %2").arg(front, back);
}

QString rowWord(const ReviewRow& row) {
  return row.isLoneBack() && row.state == CardState::Alone ? tr("no front") : stateWord(row.state);
}

QString loneBackSentence(const ReviewRow& row) {
  switch (row.state) {
    case CardState::Aside:
      return tr("This back is set aside. Drag it onto a front to use it after all.");
    case CardState::Reshoot:
      return tr("This back is to be shot again.");
    default:
      return tr(
          "No front holds this back. Drag it onto its front, join it to another, or set it "
          "aside.");
  }
}

}  // namespace ostraka::ui
