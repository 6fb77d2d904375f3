// What becomes of a batch when a person has decided, on four made-up sherds of which the program
// has two swapped.
#include "decisions/decided_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "cloud/ply.h"
#include "decisions/piece_edits.h"
#include "files/files.h"
#include "review/live_pairs.h"
#include "review/review.h"
#include "tests/core/pipeline/synthetic_out.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;
using batch::Side;

class DecidedPairs : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "ostraka_review_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    out_ = pipeline::writeSyntheticOut(folder_ / "out", {});
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }
  void TearDown() override { fs::remove(out_.output / "decisions.json"); }

  static constexpr const char* kFirst = "0190a0b0-0000-7000-8000-000000000001";
  static constexpr const char* kSecond = "0190a0b0-0000-7000-8000-000000000002";

  static PairDecision pair(int f, int b) {
    PairDecision d;
    d.kind = DecisionKind::Pair;
    d.id = kFirst;
    d.by = "AP";
    d.at = "2026-07-14T09:30:12Z";
    d.scans = {out_.table.fronts[static_cast<std::size_t>(f)],
               out_.table.backs[static_cast<std::size_t>(b)]};
    return d;
  }
  static PairDecision about(DecisionKind kind, const ScanRef& scan) {
    PairDecision d;
    d.kind = kind;
    d.id = kFirst;
    d.by = "AP";
    d.scans = {scan};
    return d;
  }
  static PairTable with(const Decisions& decisions) {
    const Result<PairTable> table =
        assigned(out_.table, settledBy(decisions, out_.table), pairing::AssignOptions{});
    EXPECT_TRUE(table.has_value());
    return table ? *table : PairTable{};
  }
  static int partner(const PairTable& table, int front) {
    for (const SherdPair& p : table.pairs)
      if (p.decision.front == front) return p.decision.back;
    return -1;
  }

  static fs::path folder_;
  static pipeline::SyntheticOut out_;
};

fs::path DecidedPairs::folder_;
pipeline::SyntheticOut DecidedPairs::out_;

TEST_F(DecidedPairs, WithoutDecisionsAreTheProgramsOwn) {
  const PairTable table = with({});
  EXPECT_EQ(partner(table, 0), 1) << "the fixture is swapped";
  EXPECT_EQ(partner(table, 1), 0);
  EXPECT_TRUE(table.pairs[0].decision.ambiguous());
  EXPECT_FALSE(table.pairs[2].decision.ambiguous());
}

TEST_F(DecidedPairs, TheOthersFollowAndTheDisplacedFrontIsShownAgain) {
  const PairTable table = with({pair(0, 0)});
  ASSERT_EQ(table.pairs.size(), 4u);
  EXPECT_EQ(partner(table, 0), 0);
  EXPECT_EQ(partner(table, 1), 1) << "its own partner is the only one left";
  EXPECT_FALSE(table.pairs[0].decision.ambiguous()) << "decided";
  EXPECT_EQ(table.pairs[0].decided_by, "AP");
  EXPECT_TRUE(table.pairs[1].decision.ambiguous()) << "nothing is taken silently";
  EXPECT_EQ(table.pairs[1].decision.doubt, pairing::Doubt::Displaced);
  EXPECT_EQ(partner(table, 2), 2);
}

TEST_F(DecidedPairs, AreAllSettledWhenBothAreConfirmed) {
  PairDecision second = pair(1, 1);
  second.id = kSecond;
  const PairTable table = with({pair(0, 0), second});
  for (const SherdPair& p : table.pairs) EXPECT_FALSE(p.decision.ambiguous());
}

TEST_F(DecidedPairs, KeepTheProgramsOwnScoreAndPose) {
  const PairTable table = with({pair(0, 1)});
  EXPECT_NEAR(*table.pairs[0].decision.score, *with({}).pairs[0].decision.score, 1e-12);
  EXPECT_EQ(table.pairs[0].registration.front_from_back.matrix(),
            out_.table.find(0, 1)->registration.front_from_back.matrix());
}

TEST_F(DecidedPairs, APoseThatNoCandidateHasIsLeftToTheRegistration) {
  PairDecision d = pair(0, 0);
  d.front_from_back = review::movedByHand(out_.front_from_back[0], out_.table.backs[0],
                                          Eigen::Vector3d(0, 0, 0.2), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(with({d}).pairs[0].registration.start, -1);
  d.front_from_back = review::movedByHand(out_.front_from_back[0], out_.table.backs[0],
                                          Eigen::Vector3d(0, 0, 0.002), Eigen::Vector3d(0.1, 0, 0));
  EXPECT_EQ(with({d}).pairs[0].registration.start, 0) << "within 0.5 mm it is the candidate's";
}

TEST_F(DecidedPairs, SetAsideTakesNoPartAndIsNotUnpaired) {
  const PairTable table = with({about(DecisionKind::Aside, out_.table.fronts[2])});
  EXPECT_EQ(partner(table, 2), -1);
  EXPECT_TRUE(table.unpaired_front.empty());
  EXPECT_EQ(table.aside_front, std::vector<int>{2});
  EXPECT_EQ(table.unpaired_back, std::vector<int>{2}) << "its back is nobody's, and says so";
}

TEST_F(DecidedPairs, ADecisionAboutAScanThatIsGoneIsSaidAndChangesNothing) {
  PairDecision d = pair(0, 0);
  d.scans[1].place_mm = Eigen::Vector2d(400, 400);
  const Settled settled = settledBy({d}, out_.table);
  EXPECT_TRUE(settled.pairs.empty());
  ASSERT_EQ(settled.warnings.size(), 1u);
  EXPECT_NE(settled.warnings[0].english().find("b001"), std::string::npos);
}

TEST_F(DecidedPairs, OfTwoAboutOneScanTheLaterHoldsAndTheEarlierIsSaid) {
  PairDecision second = pair(1, 0);
  second.id = kSecond;
  second.at = "2026-07-14T10:01:00Z";
  second.by = "KL";
  const PairTable table = with({pair(0, 0), second});
  EXPECT_EQ(partner(table, 1), 0);
  EXPECT_EQ(partner(table, 0), 1) << "free again, it takes what is left";
  std::set<int> backs;
  for (const SherdPair& p : table.pairs) EXPECT_TRUE(backs.insert(p.decision.back).second);
  const Settled settled = settledBy({pair(0, 0), second}, out_.table);
  ASSERT_EQ(settled.warnings.size(), 1u);
  for (const char* words : {"The decision of 2026-07-14 09:30 UTC by AP",
                            "the later decision of 2026-07-14 10:01 UTC by KL", "withdraw"})
    EXPECT_NE(settled.warnings[0].english().find(words), std::string::npos) << settled.warnings[0];

  PairDecision aside = about(DecisionKind::Aside, out_.table.fronts[0]);
  aside.id = kSecond;
  EXPECT_TRUE(settledBy({pair(0, 0), aside}, out_.table).pairs.empty());
  EXPECT_TRUE(settledBy({aside, pair(0, 0)}, out_.table).aside_front.empty());
}

TEST_F(DecidedPairs, AboutASidePhotographedAgainAreSaidAndChangeNothing) {
  CandidateTable table = out_.table;
  for (ScanRef& scan : table.backs) scan.photographs = "first";
  PairDecision d = pair(0, 0);
  d.scans[1] = table.backs[0];
  EXPECT_EQ(settledBy({d}, table).pairs.size(), 1u);
  for (ScanRef& scan : table.backs) scan.photographs = "second";
  const Settled settled = settledBy({d}, table);
  EXPECT_TRUE(settled.pairs.empty());
  ASSERT_EQ(settled.warnings.size(), 1u);
  EXPECT_NE(settled.warnings[0].english().find("reshot since; decide again"), std::string::npos);
  EXPECT_EQ(settledBy({pair(0, 0)}, table).pairs.size(), 1u) << "of an older program";
}

TEST_F(DecidedPairs, TheReviewShowsTheMostDoubtfulFirstAndTheDisplacedOnTop) {
  const Result<review::Review> before = review::reviewOf(out_.table, {});
  ASSERT_TRUE(before.has_value());
  EXPECT_EQ(before->cards[0].state, review::CardState::Ask);
  EXPECT_EQ(before->cards[1].state, review::CardState::Ask);
  EXPECT_EQ(before->cards[2].state, review::CardState::Sure);
  EXPECT_EQ(before->waiting(), 2);
  EXPECT_EQ(before->cards[0].doubt, pairing::Doubt::OtherPartner);
  EXPECT_EQ(before->cards[0].candidates.size(), 2u);
  EXPECT_NEAR(*before->cards[0].candidates[0].score + *before->cards[0].candidates[1].score, 1,
              1e-2);

  const Result<review::Review> after = review::reviewOf(out_.table, {pair(0, 0)});
  ASSERT_TRUE(after.has_value());
  EXPECT_EQ(after->cards[0].front, 1);
  EXPECT_EQ(after->cards[0].doubt, pairing::Doubt::Displaced);
  EXPECT_EQ(after->ofFront(0)->state, review::CardState::Decided);
  EXPECT_EQ(after->waiting(), 1);
}

TEST_F(DecidedPairs, TheTableOfCandidatesIsReadBackWhole) {
  const Result<CandidateTable> read = readCandidatesOf(out_.output);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  ASSERT_EQ(read->candidates.size(), out_.table.candidates.size());
  const RegisteredCandidate &a = read->candidates[1], &b = out_.table.candidates[1];
  EXPECT_EQ(a.registration.front_from_back.matrix(), b.registration.front_from_back.matrix());
  EXPECT_EQ(a.evidence.log_likelihood, b.evidence.log_likelihood);
  EXPECT_EQ(a.evidence.runner_up_start_log_likelihood, b.evidence.log_likelihood - 1e9);
  EXPECT_EQ(a.starts[1].shift, 120);
  EXPECT_EQ(read->fronts[2].place_mm, out_.table.fronts[2].place_mm);
}

// The fractures settled it when it was computed: the review shows that, not what the person began
// with.
TEST_F(DecidedPairs, ThatWereComputedAreShownAsTheyWereRegistered) {
  PairDecision d = pair(0, 0);
  d.front_from_back = review::movedByHand(out_.front_from_back[0], out_.table.backs[0],
                                          Eigen::Vector3d(0, 0, 0.2), Eigen::Vector3d(1, 0, 0));
  PairTable computed = with({d});
  computed.pairs[0].registration.front_from_back = out_.front_from_back[0];
  computed.pairs[0].registration.fracture_rms_mm = 0.21;
  ASSERT_TRUE(writeFileAtomically(out_.output / "pairs.json",
                                  toJson(computed, out_.table.fronts, out_.table.backs).dump()));
  const Result<CandidateTable> read = readCandidatesOf(out_.output);
  fs::remove(out_.output / "pairs.json");
  ASSERT_TRUE(read.has_value());
  const Result<review::Review> review = review::reviewOf(*read, {d});
  ASSERT_TRUE(review.has_value());
  EXPECT_TRUE(review->ofFront(0)->front_from_back.isApprox(out_.front_from_back[0], 1e-6));
  EXPECT_EQ(review->ofFront(0)->fracture_rms_mm, 0.21);
  d.id = kSecond;  // turned once more since
  EXPECT_TRUE(
      review::reviewOf(*read, {d})->ofFront(0)->front_from_back.isApprox(*d.front_from_back, 1e-6));
}

TEST_F(DecidedPairs, ABatchWithoutCandidatesSaysWhatToDo) {
  const Result<CandidateTable> missing = readCandidatesOf(folder_ / "nothing");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ErrorCode::Missing);
}

TEST_F(DecidedPairs, LiveARegistrationGoesOnFromAPoseMadeByHand) {
  const auto live = review::LivePairs::open(out_.output);
  ASSERT_TRUE(live.has_value()) << live.error().sentence();
  const Eigen::Isometry3d& truth = out_.front_from_back[0];
  const Eigen::Isometry3d off =
      review::movedByHand(truth, out_.table.backs[0], {0, 0, 0.05}, {0.5, 0.3, 0});
  const Result<review::LiveFit> before = (*live)->measured(0, 0, off);
  ASSERT_TRUE(before.has_value()) << before.error().sentence();
  const Result<review::LiveFit> after = (*live)->settled(0, 0, off, {});
  ASSERT_TRUE(after.has_value()) << after.error().sentence();
  EXPECT_LT(after->fracture_rms_mm, before->fracture_rms_mm);
  // 0.1 mm: the registration's own bar on clean scans; these are 24 mm small.
  EXPECT_LT(apart_mm(out_.table.backs[0], after->front_from_back, truth), 0.1);
  EXPECT_GT(apart_mm(out_.table.backs[0], off, truth), 0.7);
}

TEST_F(DecidedPairs, LiveTheStartPointGoesAroundTheOutline) {
  const auto live = review::LivePairs::open(out_.output);
  ASSERT_TRUE(live.has_value());
  const Result<review::LiveFit> a = (*live)->atStartPoint(2, 2, 10),
                                b = (*live)->atStartPoint(2, 2, 210);
  ASSERT_TRUE(a.has_value() && b.has_value());
  EXPECT_EQ(b->shift, 10);
  EXPECT_EQ(a->front_from_back.matrix(), b->front_from_back.matrix());
  const Result<review::LiveFit> next = (*live)->atStartPoint(2, 2, 11);
  const double angle = Eigen::AngleAxisd(Eigen::Matrix3d(a->front_from_back.linear().transpose() *
                                                         next->front_from_back.linear()))
                           .angle();
  EXPECT_NEAR(angle, 2 * 3.14159265 / 200, 0.02) << "one of 200 samples of a roundish outline";
}

TEST_F(DecidedPairs, TheViewLaysBothSidesOnEachOther) {
  const auto live = review::LivePairs::open(out_.output);
  ASSERT_TRUE(live.has_value());
  const Result<review::PairView> view = (*live)->view(2, 2, out_.front_from_back[2]);
  ASSERT_TRUE(view.has_value()) << view.error().sentence();
  EXPECT_EQ(view->front.width, view->frame.width);
  ASSERT_EQ(view->back.rgba.size(), view->front.rgba.size());
  // Pixels that only one side shows: the walls lean, but hardly more than by a pixel or two.
  int both = 0, one = 0;
  for (std::size_t i = 3; i < view->front.rgba.size(); i += 4) {
    const bool f = view->front.rgba[i] > 127, b = view->back.rgba[i] > 127;
    both += f && b;
    one += f != b;
  }
  EXPECT_GT(both, 5000);
  EXPECT_LT(one, both / 5);
  EXPECT_EQ(view->front_turns.size(), 200u);
  EXPECT_NEAR(view->front_turns.back(), 2 * 3.14159265, 1e-6);
  double squares = 0;
  for (std::size_t i = 0; i < 200; ++i)
    squares += std::pow(view->front_turns[i] - view->back_turns[i], 2);
  EXPECT_LT(std::sqrt(squares / 200), 0.6) << "two sides of one sherd";
  EXPECT_GT(view->fracture.front_mm.size(), 300u);
  EXPECT_GT(view->fracture.back_mm.size(), 300u);
}

TEST_F(DecidedPairs, APairThatTheProgramDidNotCompareIsComparedOnDemand) {
  const auto live = review::LivePairs::open(out_.output);
  ASSERT_TRUE(live.has_value());
  EXPECT_EQ(out_.table.find(0, 3), nullptr);
  const Result<RegisteredCandidate> other = (*live)->compared(0, 3, {});
  ASSERT_TRUE(other.has_value()) << other.error().sentence();
  EXPECT_EQ(other->evidence.front, 0);
  EXPECT_EQ(other->evidence.back, 3);
  QuietProgress quiet;
  const Result<std::vector<int>> order = (*live)->likeliestBacks(3, quiet, {});
  ASSERT_TRUE(order.has_value());
  EXPECT_EQ(order->front(), 3) << "its own outline fits best";
  EXPECT_EQ(order->size(), 4u);
}

TEST_F(DecidedPairs, AnIsolatedDecisionIsRegisteredFromItsPose) {
  const Result<PointCloud> front = readPlyCloud(out_.output / "work" / out_.table.front_files[0]);
  const Result<PointCloud> back = readPlyCloud(out_.output / "work" / out_.table.back_files[0]);
  ASSERT_TRUE(front.has_value() && back.has_value());
  const auto whole =
      editedPieces({{"f001", *front, {}, Eigen::Vector3d::UnitZ()}}, Side::Front, {});
  ASSERT_EQ(whole.scans.size(), 1u);
  const auto live = review::LivePairs::open(out_.output);
  scan::Scan f{"f001", *front, {}, Eigen::Vector3d::UnitZ()};
  scan::Scan b{"b001", *back, {}, Eigen::Vector3d::UnitZ()};
  // Fractures as the chain finds them, through the edits of pieces that change nothing.
  PairDecision d = pair(0, 0);
  d.front_from_back =
      review::movedByHand(out_.front_from_back[0], out_.table.backs[0], {0, 0, 0.03}, {0.4, 0, 0});
  QuietProgress quiet;
  const auto held =
      registerDecided(d, f, b, {{}, {}, rig::SheetBend{}, rig::SheetBend{}}, {}, quiet, {});
  ASSERT_TRUE(held.has_value()) << held.error().sentence();
  EXPECT_LT(apart_mm(out_.table.backs[0], held->front_from_back, out_.front_from_back[0]), 0.15);
  d.settle = Settle::AsGiven;
  const auto given =
      registerDecided(d, f, b, {{}, {}, rig::SheetBend{}, rig::SheetBend{}}, {}, quiet, {});
  ASSERT_TRUE(given.has_value());
  EXPECT_EQ(given->front_from_back.matrix(), d.front_from_back->matrix());
  EXPECT_GT(given->uncertainty_mm, 0.3) << "as far as the fractures' own place lies from it";
}

// Two fronts take the first back. Who decides for one of them leaves the other without a back.
TEST_F(DecidedPairs, OfThePapersPairingHaveNoProbability) {
  CandidateTable table = out_.table;
  table.method = pairing::Method::Paper;
  table.candidates.clear();
  for (int f = 0; f < 4; ++f) {
    RegisteredCandidate candidate;
    candidate.evidence.front = f;
    candidate.evidence.back = f == 1 ? 0 : f;
    candidate.starts.emplace_back();
    table.candidates.push_back(candidate);
  }
  const auto free = review::reviewOf(table, {});
  ASSERT_TRUE(free.has_value());
  EXPECT_EQ(free->ofFront(0)->doubt, pairing::Doubt::SharedBack);
  EXPECT_EQ(free->ofFront(1)->doubt, pairing::Doubt::SharedBack);
  EXPECT_EQ(free->ofFront(2)->state, review::CardState::Sure);
  EXPECT_EQ(free->lone_backs, std::vector<int>{1});
  for (const review::ReviewCard& card : free->cards) {
    EXPECT_FALSE(card.score.has_value());
    EXPECT_FALSE(card.candidates.at(0).score.has_value());
  }
  const Result<PairTable> decided =
      assigned(table, settledBy({pair(0, 0)}, table), pairing::AssignOptions{});
  ASSERT_TRUE(decided.has_value());
  EXPECT_FALSE(decided->pairs.at(0).decision.score.has_value());
  EXPECT_FALSE(decided->pairs.at(0).decision.ambiguous());
  EXPECT_EQ(decided->unpaired_front, std::vector<int>{1});
}

}  // namespace
}  // namespace ostraka::decisions
