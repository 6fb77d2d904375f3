#pragma once
#include <QString>
#include <vector>

#include "review/review.h"

namespace ostraka::ui {

/// What becomes of a row's pieces when the batch is computed.
enum class PieceChange { None, Joined, Cut };

/// One row of the review's list: a front's card, or a back that no front holds.
struct ReviewRow {
  int front = -1, back = -1;  ///< back: the front's partner, -1 when it has none
  review::CardState state = review::CardState::Sure;
  PieceChange change = PieceChange::None;
  QString changed_by = {}, joined_with = {};  ///< a person; IDs of the other pieces

  bool isLoneBack() const { return front < 0; }
  bool wantsPerson() const {
    return state == review::CardState::Ask || state == review::CardState::Alone;
  }
  /// Rows are the same row as long as they are about the same front, or about the same lone back.
  bool isAbout(int a_front, int a_back) const {
    return front == a_front && (front >= 0 || back == a_back);
  }
};

/// What wants a person first: doubtful fronts, then backs that are nobody's, then the rest.
std::vector<ReviewRow> rowsOf(const review::Review& review);

/// Names the rows whose pieces were joined or cut since the pairs were computed.
void markPieces(std::vector<ReviewRow>& rows, const decisions::CandidateTable& table,
                const decisions::Decisions& all, const decisions::Decisions& followed);

QString rowName(const ReviewRow& row, const decisions::CandidateTable& table);
QString rowWord(const ReviewRow& row);
/// Whole sentence: why a lone back wants a person, or what was decided about it.
QString loneBackSentence(const ReviewRow& row);
/// Whole sentence: what was done to its pieces. Empty: nothing.
QString pieceSentence(const ReviewRow& row);

}  // namespace ostraka::ui
