#include "ui/pairs/reviewed_batch.h"

#include <algorithm>

#include "ui/pairs/free_words.h"

namespace ostraka::ui {
namespace {

using review::CardState;
using review::ReviewCandidate;
using review::ReviewCard;

constexpr int kWantedCandidates = 3;

}  // namespace

Result<void> ReviewedBatch::open(OpenedBatch batch) {
  close();
  live_ = std::move(batch.live);
  decisions_ = std::move(batch.decisions);
  followed_ = std::move(batch.followed);
  if (const auto alone = review::reviewOf(table(), {})) program_ = *alone;
  const Result<review::Review> review = review::reviewOf(table(), decisions::standing(decisions_));
  if (!review) return review.error();
  review_ = *review;
  return {};
}

bool ReviewedBatch::isIn(const std::filesystem::path& output) const {
  return isOpen() && live_->output() == output;
}

std::vector<ReviewRow> ReviewedBatch::rows() const {
  if (!isOpen()) return {};
  std::vector<ReviewRow> rows = rowsOf(review_);
  markPieces(rows, table(), decisions_, followed_);
  return rows;
}

QString ReviewedBatch::nameOf(const Trial& trial) const {
  return ui::nameOf(trial.front >= 0 ? front(trial.front) : back(trial.back));
}

Result<void> ReviewedBatch::add(const decisions::PairDecision& decision) {
  decisions_.push_back(decision);
  const Result<review::Review> review = review::reviewOf(table(), decisions::standing(decisions_));
  if (!review) return review.error();
  review_ = *review;
  return {};
}

bool ReviewedBatch::wantsComputing() const {
  return isOpen() && !review::onlyConfirm(table(), decisions::changedSince(decisions_, followed_));
}

int ReviewedBatch::holderOf(int back) const {
  const ReviewCard* holder = review_.ofBack(back);
  return holder == nullptr ? -1 : holder->front;
}

Trial ReviewedBatch::standing(const ReviewCard& card) const {
  Trial trial;
  trial.front = card.front;
  const CardStory story = storyOf(card);
  if (card.back >= 0) {
    trial.back = card.back;
    trial.front_from_back = card.front_from_back;
    if (story.by_hand) trial.made = Made::ByHand;
  } else if (story.next && card.state == CardState::Alone) {
    trial.back = story.next->back;
    trial.front_from_back = story.next->front_from_back;
  }
  return trial;
}

QString ReviewedBatch::wordsOf(const ReviewRow& row) const {
  if (const QString change = pieceSentence(row); !change.isEmpty()) return change;
  const ReviewCard* card = review_.ofFront(row.front);
  return card == nullptr ? loneBackSentence(row) : doubtSentence(*card, table(), storyOf(*card));
}

CardStory ReviewedBatch::storyOf(const ReviewCard& card) const {
  CardStory story;
  for (const decisions::PairDecision& d : decisions_)
    if (d.id == card.decision && d.kind == decisions::DecisionKind::Pair)
      story.by_hand = d.settle == decisions::Settle::AsGiven;
  const ReviewCard* own = program_.ofFront(card.front);
  const int lost = own == nullptr ? -1 : own->back;
  const ReviewCard* holder = review_.ofBack(lost);
  if (holder != nullptr && holder->front != card.front && holder->state == CardState::Decided) {
    story.lost_back = lost;
    story.lost_to = holder->front;
  }
  const auto& free = review_.lone_backs;
  for (const ReviewCandidate& c : candidatesOf(card.front))
    if (!story.next && std::find(free.begin(), free.end(), c.back) != free.end()) story.next = c;
  return story;
}

std::vector<ReviewCandidate> ReviewedBatch::candidatesOf(int front) const {
  std::vector<ReviewCandidate> all;
  const ReviewCard* of = review_.ofFront(front);
  if (of != nullptr) all = of->candidates;
  const auto more = more_.find(front);
  if (more == more_.end()) return all;
  for (const ReviewCandidate& c : more->second) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const ReviewCandidate& o) { return o.back == c.back; });
    if (known) continue;
    all.push_back(c);
    if (of != nullptr && !of->score) all.back().score.reset();
  }
  return all;
}

bool ReviewedBatch::wantsMore(int front, bool in_hand) const {
  const ReviewCard* card = review_.ofFront(front);
  if (card == nullptr || complete_.contains(front)) return false;
  const bool doubtful = card->state == CardState::Ask || card->state == CardState::Alone;
  return (doubtful || in_hand) && static_cast<int>(candidatesOf(front).size()) < kWantedCandidates;
}

void ReviewedBatch::addCandidate(int front, const ReviewCandidate& candidate) {
  more_[front].push_back(candidate);
}

}  // namespace ostraka::ui
