#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "decisions/decided_pairs.h"

namespace ostraka::review {

/// What a card of the review asks of a person.
enum class CardState {
  Ask,      ///< a pair that the program is not sure of
  Alone,    ///< no back was found
  Sure,     ///< the program's own, without doubt
  Decided,  ///< a person's word
  Aside,
  Reshoot
};

/// One back that may belong to a front, with its fractures compared.
struct ReviewCandidate : registration::Registration {
  int back = 0;
  std::optional<double> score = 0;  ///< probability by the program, 0..1; none: it states none
  double contour_rms_mm = 0;
  int shift = 0;            ///< start point on the back's contour, of 200
  std::vector<int> shifts;  ///< the good start points, rising
  double check_value = 0;   ///< what the failed check is about, in the unit of its field
};

/// One front: what was found for it, what was decided, why it is doubtful.
struct ReviewCard {
  int front = 0;
  std::string number;  ///< of the sherd: "03"
  CardState state = CardState::Sure;
  int back = -1;  ///< its partner as things stand
  int candidate =
      -1;  ///< index of that partner below; -1: no fractures were compared by the program
  std::optional<double> score = 0, margin = 0;  ///< none: the program states none
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();  ///< as things stand
  std::vector<ReviewCandidate> candidates;                            ///< likeliest first

  pairing::Doubt doubt = pairing::Doubt::None;
  registration::FailedCheck failed_check =
      registration::FailedCheck::None;  ///< with Doubt::SelfCheck
  double check_value = 0;
  /// With Doubt::OtherPartner the rival: a back for this front, or a front for its back.
  int rival_back = -1, rival_front = -1;
  double fracture_rms_mm = 0, rival_fracture_rms_mm = 0;

  std::string decision;  ///< its id; empty: none
  std::string decided_by, decided_at;
};

/// What the review of a batch shows: the cards most doubtful first, and the rest.
struct Review {
  std::vector<ReviewCard> cards;
  std::vector<int> lone_backs;                  ///< nobody's
  std::vector<int> aside_backs, reshoot_backs;  ///< by a person
  std::vector<Message> warnings;                ///< about decisions that cannot be applied

  int waiting() const;    ///< cards that want a person, and backs that are nobody's
  int toReshoot() const;  ///< sherds of which a person wants new photographs
  const ReviewCard* ofFront(int front) const;
  const ReviewCard* ofBack(int back) const;  ///< the card that holds this back
};

/// What a card shows of a candidate; its score is the review's to give.
ReviewCandidate candidateOf(const decisions::RegisteredCandidate& candidate);

/// How many sherds of a review are in which state.
struct ReviewCounts {
  int sherds = 0;   ///< fronts with a back
  int sure = 0;     ///< the program's word
  int decided = 0;  ///< a person's word
  int ask = 0;      ///< wants a person: doubtful pairs, and scans without a partner
  int reshoot = 0;  ///< to be photographed again, says a person
};
ReviewCounts countsOf(const Review& review);

/// Milliseconds, for 60 sherds too. Errors: those of assigned().
Result<Review> reviewOf(const decisions::CandidateTable& table,
                        const decisions::Decisions& standing);

/// These decisions say no more than the program does without any: nothing is to be computed for
/// them.
bool onlyConfirm(const decisions::CandidateTable& table, const decisions::Decisions& decisions);
/// Missing while a batch is computed, and where that was stopped: its scans may be new already
/// where its table is not, and a card would show another one's sherd.
Result<void> computedToItsEnd(const std::filesystem::path& output);

/// The decisions of OUT, or strokes on its masks, say other things than its results followed: they
/// were made while it was computed, or since. False where it cannot be known.
bool wantsComputing(const std::filesystem::path& output);

/// Both, and the decisions, for who asks once.
Result<Review> loadReview(const std::filesystem::path& output);

}  // namespace ostraka::review
