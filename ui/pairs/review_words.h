#pragma once
#include <QString>
#include <optional>

#include "review/live_pairs.h"
#include "review/review.h"
#include "ui/look/state_colours.h"
#include "ui/pairs/trial.h"

/// The review's codes and values in words.
namespace ostraka::ui {

/// What a card's sentence tells besides the card.
struct CardStory {
  bool by_hand = false;  ///< the pose that was decided was given by hand
  int lost_back = -1,
      lost_to = -1;  ///< the program's own back, and the front that a person gave it
  std::optional<review::ReviewCandidate> next = {};  ///< the best back that is nobody's
};
/// Whole sentence: why this card wants a person, or what was decided.
QString doubtSentence(const review::ReviewCard& card, const decisions::CandidateTable& table,
                      const CardStory& story);
/// The same about what is tried instead of that. score: the program's for these two. fit: of this
/// pose, or null while it is measured.
QString triedSentence(const Trial& trial, std::optional<double> score, const review::LiveFit* fit,
                      const review::ReviewCard& card, const decisions::CandidateTable& table);
QString madeWord(Made made);  ///< two or three words
QString hardlyMeetSentence(const review::LiveFit& fit);
/// One or two words for the state; goes along with the colour.
QString stateWord(review::CardState state);
State stateColour(review::CardState state);
QString percent(double share);  ///< "71 %", "under 1 %"
/// Of a candidate; none where the pairing states no probability.
QString scoreWords(std::optional<double> score);
QString mm(double value, int digits = 2);
/// What the registration's own check says of a pose; empty when nothing.
QString failedCheckSentence(registration::FailedCheck failed_check, double value);

}  // namespace ostraka::ui
