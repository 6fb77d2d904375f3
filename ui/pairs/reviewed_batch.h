#pragma once
#include <map>
#include <set>
#include <vector>

#include "ui/pairs/review_rows.h"
#include "ui/pairs/review_words.h"
#include "ui/pairs/review_work.h"

namespace ostraka::ui {

/// A batch under review: what the program found, what people decided, and how things stand by now.
/// Indices are those of its candidate table's fronts and backs.
class ReviewedBatch {
 public:
  /// Where the decisions cannot be read together the batch is open without any card.
  Result<void> open(OpenedBatch batch);
  void close() { *this = {}; }
  bool isOpen() const { return live_ != nullptr; }
  bool isIn(const std::filesystem::path& output) const;

  const LivePairsPtr& live() const { return live_; }
  const decisions::CandidateTable& table() const { return live_->table(); }
  const review::Review& review() const { return review_; }
  const decisions::Decisions& decisions() const { return decisions_; }
  const decisions::ScanRef& front(int i) const { return table().fronts.at(std::size_t(i)); }
  const decisions::ScanRef& back(int i) const { return table().backs.at(std::size_t(i)); }
  std::vector<ReviewRow> rows() const;
  QString nameOf(const Trial& trial) const;  ///< of its front, or of the lone back

  /// A decision that stands in the file by now.
  Result<void> add(const decisions::PairDecision& decision);
  /// Pairs or pieces were changed, not only confirmed.
  bool wantsComputing() const;
  int holderOf(int back) const;  ///< the front that holds this back now, -1: none
  /// What is shown of a card at first: as it was decided, or its best back that is nobody's.
  Trial standing(const review::ReviewCard& card) const;
  /// Whole sentence about a row.
  QString wordsOf(const ReviewRow& row) const;

  /// The program's, and those compared on demand.
  std::vector<review::ReviewCandidate> candidatesOf(int front) const;
  /// It waits for a person, or is in hand, and more of its candidates may be found.
  bool wantsMore(int front, bool in_hand) const;
  void addCandidate(int front, const review::ReviewCandidate& candidate);
  void addNoMore(int front) { complete_.insert(front); }

 private:
  CardStory storyOf(const review::ReviewCard& card) const;

  LivePairsPtr live_;
  decisions::Decisions decisions_, followed_;  ///< all, and those that the results follow
  review::Review review_, program_;            ///< as things stand, and without any decision
  std::map<int, std::vector<review::ReviewCandidate>> more_;  ///< by front, compared on demand
  std::set<int> complete_;  ///< fronts for which there are no more
};

}  // namespace ostraka::ui
