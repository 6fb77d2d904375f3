#include "pipeline/more_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "base/files.h"
#include "pipeline/review.h"
#include "synthetic_out.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

class MoreCandidates : public ::testing::Test {
 protected:
  MoreCandidates() {
    output_ = fs::temp_directory_path() / "ostraka_more_candidates_test";
    fs::remove_all(output_);
    writeSyntheticOut(output_, {});
    live_ = *LivePairs::open(output_);
  }
  ~MoreCandidates() override { fs::remove_all(output_); }
  std::vector<int> compared(int front) const {
    std::vector<int> backs;
    for (const RegisteredCandidate& c : live_->table().candidates)
      if (c.evidence.front == front) backs.push_back(c.evidence.back);
    return backs;
  }
  fs::path kept() const { return output_ / "work" / "more_candidates.json"; }

  fs::path output_;
  std::shared_ptr<const LivePairs> live_;
  QuietProgress quiet;
};

TEST_F(MoreCandidates, ComeOneByOneUntilEachBackWasShownAndAreKept) {
  std::vector<int> known = compared(2);
  const std::size_t before = known.size();
  ASSERT_LT(before, 4u);
  std::vector<double> rims;
  while (true) {
    const auto next = nextCandidate(*live_, 2, known, quiet, {});
    ASSERT_TRUE(next) << next.error().sentence();
    if (!*next) break;
    EXPECT_EQ((*next)->evidence.front, 2);
    EXPECT_EQ(std::count(known.begin(), known.end(), (*next)->evidence.back), 0);
    known.push_back((*next)->evidence.back);
    rims.push_back((*next)->registration.rim_rms_mm);
  }
  ASSERT_GT(known.size(), before);
  // Another time they come from the disk, in the same order, from whoever opens the batch.
  const std::string bytes = *readFile(kept());
  const auto again = *LivePairs::open(output_);
  std::vector<int> anew(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(before));
  for (std::size_t i = before; i < known.size(); ++i) {
    const auto next = nextCandidate(*again, 2, anew, quiet, {});
    ASSERT_TRUE(next && *next);
    EXPECT_EQ((*next)->evidence.back, known[i]);
    EXPECT_NEAR((*next)->registration.rim_rms_mm, rims[i - before], 1e-6);
    anew.push_back((*next)->evidence.back);
  }
  EXPECT_EQ(*readFile(kept()), bytes);
}

TEST_F(MoreCandidates, OfPairsThatWereComputedAnewAreNotBelieved) {
  const auto first = nextCandidate(*live_, 2, compared(2), quiet, {});
  ASSERT_TRUE(first && *first);
  const auto pairs = output_ / "work" / "pairs" / "candidates.json";
  const std::string old = "no table of candidates";
  ASSERT_TRUE(writeFileAtomically(kept(), old));
  fs::last_write_time(kept(), fs::last_write_time(pairs) - std::chrono::hours(1));
  const auto second = nextCandidate(*live_, 2, compared(2), quiet, {});
  ASSERT_TRUE(second && *second);
  EXPECT_EQ((*second)->evidence.back, (*first)->evidence.back);
  EXPECT_NE(*readFile(kept()), old);
}

TEST_F(MoreCandidates, AreThereForEachDoubtfulFrontOnceTheyWerePrepared) {
  ASSERT_TRUE(prepareCandidates(output_, 3, quiet, {}));
  const std::string bytes = *readFile(kept());
  const Review review = *loadReview(output_);
  for (const ReviewCard& card : review.cards) {
    if (card.state != CardState::Ask) continue;
    std::vector<int> known;
    for (const ReviewCandidate& c : card.candidates) known.push_back(c.back);
    if (known.size() >= 3) continue;
    const auto next = nextCandidate(*live_, card.front, known, quiet, {});
    ASSERT_TRUE(next && *next);
  }
  EXPECT_EQ(*readFile(kept()), bytes);
}

}  // namespace
}  // namespace ostraka::pipeline
