#include "review/review.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/message.h"
#include "decisions/mask_strokes.h"
#include "files/json_numbers.h"

namespace ostraka::review {
namespace {

using pairing::Doubt;
using registration::FailedCheck;
using registration::Registration;

// The figure that a failed check is about.
double valueOf(const Registration& r) {
  switch (r.failed_check) {
    case FailedCheck::FacesCross:
      return r.crossing_share;
    case FailedCheck::NoSharedFracture:
      return r.fracture_overlap;
    case FailedCheck::FractureMisfits:
      return r.fracture_rms_mm;
    case FailedCheck::FractureLoose:
      return r.uncertainty_mm;
    case FailedCheck::RivalPlace:
      return r.runner_up_mm;
    default:
      return 0;
  }
}

// P(this back | front) from by how much the best assignment falls when the pair is forced; a front
// that stays alone in it may also stay so.
std::vector<std::optional<double>> chancesOf(const decisions::CandidateTable& table,
                                             const decisions::PairTable& free,
                                             const pairing::AssignOptions& options) {
  if (table.method == pairing::Method::Paper)  // states none
    return std::vector<std::optional<double>>(table.candidates.size());
  std::vector<pairing::Evidence> evidence;
  for (const decisions::RegisteredCandidate& c : table.candidates) evidence.push_back(c.evidence);
  const Result<std::vector<double>> regret =
      pairing::regrets(evidence, static_cast<int>(table.fronts.size()),
                       static_cast<int>(table.backs.size()), options.lone_log_likelihood);
  std::vector<std::optional<double>> chances(evidence.size(), 0.0);
  if (!regret) return chances;
  std::vector<double> totals(table.fronts.size(), 0);
  for (const int f : free.unpaired_front) totals[static_cast<std::size_t>(f)] = 1;
  for (std::size_t i = 0; i < evidence.size(); ++i)
    totals[static_cast<std::size_t>(evidence[i].front)] += std::exp(-(*regret)[i]);
  for (std::size_t i = 0; i < evidence.size(); ++i)
    chances[i] = std::exp(-(*regret)[i]) / totals[static_cast<std::size_t>(evidence[i].front)];
  // The assignment's own figure knows more (other poses of the same pair, staying alone).
  for (const decisions::SherdPair& pair : free.pairs)
    for (std::size_t i = 0; i < evidence.size(); ++i)
      if (evidence[i].front == pair.decision.front && evidence[i].back == pair.decision.back)
        chances[i] = pair.decision.score;
  return chances;
}

void nameRival(ReviewCard& card, const decisions::SherdPair& pair,
               const decisions::CandidateTable& table) {
  if (pair.decision.alternatives.empty()) return;
  const pairing::Alternative& rival = pair.decision.alternatives.front();
  if (rival.front == card.front)
    card.rival_back = rival.back;
  else
    card.rival_front = rival.front;
  if (const decisions::RegisteredCandidate* c = table.find(rival.front, rival.back))
    card.rival_fracture_rms_mm = c->registration.fracture_rms_mm;
}

void pairUp(ReviewCard& card, const decisions::SherdPair& pair,
            const decisions::CandidateTable& table) {
  card.back = pair.decision.back;
  card.score = pair.decision.score;
  card.margin = pair.decision.margin;
  card.front_from_back = pair.registration.front_from_back;
  card.fracture_rms_mm = pair.registration.fracture_rms_mm;
  card.decision = pair.decided;
  card.decided_by = pair.decided_by;
  card.decided_at = pair.decided_at;
  card.state = !pair.decided.empty()       ? CardState::Decided
               : pair.decision.ambiguous() ? CardState::Ask
                                           : CardState::Sure;
  card.doubt = pair.decision.doubt;
  if (card.doubt == Doubt::SelfCheck) {
    card.failed_check = pair.registration.failed_check;
    card.check_value = valueOf(pair.registration);
  }
  nameRival(card, pair, table);
  for (std::size_t i = 0; i < card.candidates.size(); ++i)
    if (card.candidates[i].back == card.back) card.candidate = static_cast<int>(i);
}

int rankOf(const ReviewCard& card) {
  if (card.state == CardState::Ask && card.doubt == Doubt::Displaced) return 0;
  switch (card.state) {
    case CardState::Ask:
      return 1;
    case CardState::Alone:
      return 2;
    case CardState::Sure:
      return 3;
    case CardState::Decided:
      return 4;
    default:
      return 5;
  }
}

bool among(const std::vector<int>& list, int i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

// Who set a front aside, for the card.
void nameDecision(ReviewCard& card, const decisions::CandidateTable& table,
                  const decisions::Decisions& standing, decisions::DecisionKind kind) {
  for (const decisions::PairDecision& d : standing) {
    if (d.kind != kind) continue;
    for (const decisions::ScanRef& ref : d.scans)
      if (ref.side == batch::Side::Front && decisions::resolved(ref, table.fronts) == card.front) {
        card.decision = d.id;
        card.decided_by = d.by;
        card.decided_at = d.at;
      }
  }
}

}  // namespace

ReviewCandidate candidateOf(const decisions::RegisteredCandidate& c) {
  ReviewCandidate out;
  static_cast<Registration&>(out) = c.registration;
  out.back = c.evidence.back;
  out.contour_rms_mm = c.start().contour_rms_mm;
  out.shift = c.start().shift;
  for (const pairing::StartPose& start : c.starts) out.shifts.push_back(start.shift);
  std::sort(out.shifts.begin(), out.shifts.end());
  out.check_value = valueOf(out);
  return out;
}

int Review::waiting() const {
  const auto wanting = std::ranges::count_if(cards, [](const ReviewCard& card) {
    return card.state == CardState::Ask || card.state == CardState::Alone;
  });
  return static_cast<int>(wanting) + static_cast<int>(lone_backs.size());
}

int Review::toReshoot() const {
  const auto fronts = std::ranges::count_if(
      cards, [](const ReviewCard& card) { return card.state == CardState::Reshoot; });
  return static_cast<int>(
      std::max<std::ptrdiff_t>(fronts, static_cast<std::ptrdiff_t>(reshoot_backs.size())));
}

const ReviewCard* Review::ofFront(int front) const {
  for (const ReviewCard& card : cards)
    if (card.front == front) return &card;
  return nullptr;
}

const ReviewCard* Review::ofBack(int back) const {
  for (const ReviewCard& card : cards)
    if (back >= 0 && card.back == back) return &card;
  return nullptr;
}

Result<Review> reviewOf(const decisions::CandidateTable& table,
                        const decisions::Decisions& standing) {
  pairing::AssignOptions options;
  options.max_alternatives = static_cast<int>(table.fronts.size() + table.backs.size());
  const decisions::Settled settled = decisions::settledBy(standing, table);
  const Result<decisions::PairTable> free = decisions::assigned(table, options);
  if (!free) return free.error();
  const Result<decisions::PairTable> pairs = decisions::assigned(table, settled, options);
  if (!pairs) return pairs.error();
  const std::vector<std::optional<double>> chances = chancesOf(table, *free, options);

  Review review;
  review.warnings = settled.warnings;
  review.lone_backs = pairs->unpaired_back;
  review.aside_backs = pairs->aside_back;
  review.reshoot_backs = pairs->reshoot_back;
  for (std::size_t f = 0; f < table.fronts.size(); ++f) {
    ReviewCard card;
    card.front = static_cast<int>(f);
    card.number = decisions::sherdNumber(table.fronts[f].id);
    if (table.method == pairing::Method::Paper) card.score = card.margin = std::nullopt;
    for (std::size_t i = 0; i < table.candidates.size(); ++i) {
      if (table.candidates[i].evidence.front != card.front) continue;
      card.candidates.push_back(candidateOf(table.candidates[i]));
      card.candidates.back().score = chances[i];
    }
    std::ranges::stable_sort(card.candidates, std::greater(), &ReviewCandidate::score);
    card.state = CardState::Alone;
    for (const decisions::SherdPair& pair : pairs->pairs)
      if (pair.decision.front == card.front) pairUp(card, pair, table);
    if (among(pairs->aside_front, card.front)) card.state = CardState::Aside;
    if (among(pairs->reshoot_front, card.front)) card.state = CardState::Reshoot;
    if (card.state == CardState::Aside)
      nameDecision(card, table, standing, decisions::DecisionKind::Aside);
    if (card.state == CardState::Reshoot)
      nameDecision(card, table, standing, decisions::DecisionKind::Reshoot);
    review.cards.push_back(std::move(card));
  }
  std::ranges::stable_sort(review.cards, [](const ReviewCard& a, const ReviewCard& b) {
    const int x = rankOf(a), y = rankOf(b);
    if (x != y) return x < y;
    return x == 1 && a.margin < b.margin;
  });
  return review;
}

bool onlyConfirm(const decisions::CandidateTable& table, const decisions::Decisions& decisions) {
  if (decisions.empty()) return true;
  const Result<Review> free = reviewOf(table, {});
  if (!free) return false;
  return std::ranges::all_of(decisions, [&](const decisions::PairDecision& d) {
    if (d.kind != decisions::DecisionKind::Pair || d.settle == decisions::Settle::AsGiven)
      return false;
    const ReviewCard* card = free->ofFront(decisions::resolved(d.scans.at(0), table.fronts));
    if (card == nullptr || card->back != decisions::resolved(d.scans.at(1), table.backs))
      return false;
    return !d.front_from_back || d.front_from_back->isApprox(card->front_from_back, 1e-6);
  });
}

Result<void> computedToItsEnd(const std::filesystem::path& output) {
  std::error_code failed;
  if (std::filesystem::exists(output / "report.json", failed)) return {};
  return Error::missing(
      message("The batch is not fully processed; let the queue process it, then review its pairs."),
      output.string());
}

ReviewCounts countsOf(const Review& review) {
  ReviewCounts counts;
  for (const ReviewCard& card : review.cards) {
    counts.sherds += card.back >= 0 ? 1 : 0;
    counts.sure += card.state == CardState::Sure ? 1 : 0;
    counts.decided += card.state == CardState::Decided ? 1 : 0;
  }
  counts.ask = review.waiting();
  counts.reshoot = review.toReshoot();
  return counts;
}

bool wantsComputing(const std::filesystem::path& output) {
  if (decisions::masksWantComputing(output)) return true;
  const Result<decisions::Decisions> decisions = decisions::readDecisions(output);
  const Result<decisions::CandidateTable> table = decisions::readCandidatesOf(output);
  if (!decisions || !table) return false;
  return !onlyConfirm(*table,
                      decisions::changedSince(*decisions, decisions::followed(*decisions, output)));
}

Result<Review> loadReview(const std::filesystem::path& output) {
  const Result<decisions::CandidateTable> table = decisions::readCandidatesOf(output);
  if (!table) return table.error();
  const Result<decisions::Decisions> decisions = decisions::readDecisions(output);
  if (!decisions) return decisions.error();
  return reviewOf(*table, decisions::standing(*decisions));
}

}  // namespace ostraka::review
