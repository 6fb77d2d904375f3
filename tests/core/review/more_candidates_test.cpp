#include "review/more_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/json.h"
#include "review/review.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/pipeline/synthetic_out.h"

namespace ostraka::review {
namespace {

namespace fs = std::filesystem;

class MoreCandidates : public ::testing::Test {
 protected:
  MoreCandidates() {
    pipeline::writeSyntheticOut(output_, {});
    live_ = *LivePairs::open(output_);
  }
  std::vector<int> compared(int front) const {
    std::vector<int> backs;
    for (const decisions::RegisteredCandidate& c : live_->table().candidates)
      if (c.evidence.front == front) backs.push_back(c.evidence.back);
    return backs;
  }
  fs::path kept() const { return output_ / "work" / "more_candidates.json"; }

  TemporaryFolder temporary_;
  fs::path output_ = temporary_.path();
  std::shared_ptr<const LivePairs> live_;
  QuietProgress quiet;
};

TEST_F(MoreCandidates, ComeOneByOneUntilEachBackWasShownAndAreKept) {
  std::vector<int> known = compared(2);
  const std::size_t before = known.size();
  ASSERT_LT(before, 4u);
  std::vector<double> fractures;
  while (true) {
    const auto next = nextCandidate(*live_, 2, known, quiet, {});
    ASSERT_TRUE(next) << next.error().sentence();
    if (!*next) break;
    EXPECT_EQ((*next)->evidence.front, 2);
    EXPECT_EQ(std::count(known.begin(), known.end(), (*next)->evidence.back), 0);
    known.push_back((*next)->evidence.back);
    fractures.push_back((*next)->registration.fracture_rms_mm);
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
    EXPECT_NEAR((*next)->registration.fracture_rms_mm, fractures[i - before], 1e-6);
    anew.push_back((*next)->evidence.back);
  }
  EXPECT_EQ(*readFile(kept()), bytes);
}

// What is kept is altered, so that a candidate from the disk differs from one found anew.
TEST_F(MoreCandidates, AreBelievedUntilThePairsAreComputedAnew) {
  const auto found = nextCandidate(*live_, 2, compared(2), quiet, {});
  ASSERT_TRUE(found && *found);
  nlohmann::json text = *readJson(kept());
  ASSERT_FALSE(text["candidates"].empty());
  for (nlohmann::json& candidate : text["candidates"]) candidate["fracture_rms_mm"] = 9.5;
  ASSERT_TRUE(writeFileAtomically(kept(), text.dump()));
  const auto from_disk = nextCandidate(*live_, 2, compared(2), quiet, {});
  ASSERT_TRUE(from_disk && *from_disk);
  EXPECT_EQ((*from_disk)->registration.fracture_rms_mm, 9.5);

  const fs::path pairs = output_ / "work" / "pairs" / "candidates.json";
  nlohmann::json other = *readJson(pairs);
  ASSERT_FALSE(other["candidates"].empty());
  nlohmann::json& likelihood = other["candidates"][0]["log_likelihood"];
  likelihood = likelihood.get<double>() + 1;
  ASSERT_TRUE(writeFileAtomically(pairs, other.dump()));
  const auto recomputed = *LivePairs::open(output_);
  const auto anew = nextCandidate(*recomputed, 2, compared(2), quiet, {});
  ASSERT_TRUE(anew && *anew);
  EXPECT_EQ((*anew)->evidence.back, (*found)->evidence.back);
  EXPECT_NEAR((*anew)->registration.fracture_rms_mm, (*found)->registration.fracture_rms_mm, 1e-6);
}

TEST_F(MoreCandidates, ThatCannotBeReadAreFoundAnew) {
  const auto found = nextCandidate(*live_, 2, compared(2), quiet, {});
  ASSERT_TRUE(found && *found);
  ASSERT_TRUE(writeFileAtomically(kept(), "no table of candidates"));
  const auto anew = nextCandidate(*live_, 2, compared(2), quiet, {});
  ASSERT_TRUE(anew && *anew);
  EXPECT_EQ((*anew)->evidence.back, (*found)->evidence.back);
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
}  // namespace ostraka::review
