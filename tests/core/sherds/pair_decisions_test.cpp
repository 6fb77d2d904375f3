#include <gmock/gmock.h>

#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/numbers.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using testing::ElementsAre;

class Decisions : public catalogue::SmallProject {
 protected:
  Decisions() {
    batch = newBatch({bag4});
    for (int i = 0; i < 3; ++i) {
      front[i] = scan(batch, batch::Side::Front, i + 1);
      back[i] = scan(batch, batch::Side::Back, i + 1);
    }
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Eigen::Vector3d(1, 2, 3);
    for (int i = 0; i < 3; ++i) {
      records::PairDecision d = pair(i, i, records::Verdict::Accept);
      d.front_from_back = pose;
      d.score = 0.9;
      d.ambiguous = i == 2;
      EXPECT_TRUE(PairDecisions(catalogue()).add(d, {}));
    }
  }
  records::PairDecision pair(int f, int b, records::Verdict verdict) {
    records::PairDecision d;
    d.batch = batch;
    if (f >= 0) d.front = front[f];
    if (b >= 0) d.back = back[b];
    d.verdict = verdict;
    return d;
  }
  store::DecisionRow say(int f, int b, records::Verdict verdict) {
    const Result<store::DecisionRow> row =
        PairDecisions(catalogue()).add(pair(f, b, verdict), anna);
    EXPECT_TRUE(row) << row.error().sentence();
    return row ? *row : store::DecisionRow{};
  }
  void withdraw(store::DecisionRow row) {
    records::PairDecision d;
    d.batch = batch;
    d.verdict = records::Verdict::Withdraw;
    d.replaces = row;
    EXPECT_TRUE(PairDecisions(catalogue()).add(d, anna));
  }
  /// "1-2" for front 1 with back 2, "1a" for front 1 set aside
  std::vector<std::string> now() {
    std::vector<std::string> words;
    for (const records::PairDecision& d :
         catalogue::valueIn(PairDecisions(catalogue()).current(batch))) {
      std::string word;
      for (int i = 0; i < 3; ++i)
        if (d.front == front[i]) word += std::to_string(i + 1);
      word += d.verdict == records::Verdict::Accept  ? "-"
              : d.verdict == records::Verdict::Aside ? "a"
                                                     : "r";
      for (int i = 0; i < 3; ++i)
        if (d.back == back[i]) word += std::to_string(i + 1);
      words.push_back(word);
    }
    return words;
  }
  std::vector<std::string> sherds() {
    std::vector<std::string> words;
    for (const records::SherdRecord& s :
         catalogue::valueIn(Sherds(catalogue()).of(*Sherds(catalogue()).rows(batch)))) {
      std::string word;
      for (int i = 0; i < 3; ++i)
        if (s.front == front[i]) word += std::to_string(i + 1);
      word += "-";
      for (int i = 0; i < 3; ++i)
        if (s.back == back[i]) word += std::to_string(i + 1);
      words.push_back(word);
    }
    return words;
  }
  store::BatchRow batch;
  store::ScanRow front[3], back[3];
};

TEST_F(Decisions, OfTheProgramMakeDraftSherdsInTheBagOfTheBatch) {
  EXPECT_THAT(now(), ElementsAre("1-1", "2-2", "3-3"));
  EXPECT_THAT(sherds(), ElementsAre("1-1", "2-2", "3-3"));
  const records::SherdRecord sherd =
      *Sherds(catalogue()).get(Sherds(catalogue()).rows(batch)->front());
  EXPECT_EQ(sherd.state, records::SherdState::Draft);
  EXPECT_EQ(sherd.context, context12);
  EXPECT_EQ(sherd.bag, bag4);
  EXPECT_EQ(catalogue::Batches(catalogue()).scans(batch)->front().state,
            records::ScanState::Paired);
  EXPECT_EQ(catalogue::Batches(catalogue()).scans(batch)->at(2).state, records::ScanState::Open)
      << "front 3 is doubtful";
}

TEST_F(Decisions, AreReadBackWithTheirPose) {
  const records::PairDecision d = PairDecisions(catalogue()).all(batch)->front();
  ASSERT_TRUE(d.front_from_back);
  EXPECT_EQ(d.front_from_back->translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(d.score, 0.9);
  EXPECT_FALSE(d.by);
}

TEST_F(Decisions, APersonsWordStandsAboveTheProgramsAndTheOtherPairBreaks) {
  say(0, 1, records::Verdict::Accept);
  EXPECT_THAT(now(), ElementsAre("1-2", "3-3"));
  EXPECT_THAT(sherds(), ElementsAre("1-2", "3-3")) << "front 2 waits for another back";
  say(1, 0, records::Verdict::Accept);
  EXPECT_THAT(now(), ElementsAre("1-2", "2-1", "3-3"));
  EXPECT_THAT(sherds(), ElementsAre("1-2", "2-1", "3-3"));
}

TEST_F(Decisions, TheHistoryOfASherdNamesItsScans) {
  say(0, 1, records::Verdict::Accept);
  const store::SherdRow first = Sherds(catalogue()).rows(batch)->front();
  const records::HistoryEntry newest = catalogue::History(catalogue()).of(first)->front();
  const std::string number = catalogue::Batches(catalogue()).get(batch)->number;
  EXPECT_EQ(newest.field, "back");
  EXPECT_EQ(newest.old_value, number + " b001");
  EXPECT_EQ(newest.new_value, number + " b002");
}

TEST_F(Decisions, WhatTheProgramSaysLaterChangesNothingThatAPersonSaid) {
  say(0, 1, records::Verdict::Accept);
  EXPECT_TRUE(PairDecisions(catalogue()).add(pair(0, 0, records::Verdict::Accept), {}));
  EXPECT_THAT(now(), ElementsAre("1-2", "3-3"));
}

TEST_F(Decisions, TheLaterWordOfAPersonCounts) {
  say(0, 1, records::Verdict::Accept);
  say(0, 2, records::Verdict::Accept);
  EXPECT_THAT(now(), ElementsAre("1-3", "2-2"));
}

TEST_F(Decisions, ARejectedPairIsNoPairUntilItIsAcceptedAgain) {
  say(0, 0, records::Verdict::Reject);
  EXPECT_THAT(now(), ElementsAre("2-2", "3-3"));
  say(0, 0, records::Verdict::Accept);
  EXPECT_THAT(now(), ElementsAre("1-1", "2-2", "3-3"));
}

TEST_F(Decisions, SetAsideCountsForWhatIsStillFree) {
  say(0, -1, records::Verdict::Aside);
  EXPECT_THAT(now(), testing::UnorderedElementsAre("1a", "2-2", "3-3"));
  EXPECT_EQ(catalogue::Batches(catalogue()).scans(batch)->front().state, records::ScanState::Aside);
  say(1, 1, records::Verdict::Reshoot);
  EXPECT_THAT(now(), testing::UnorderedElementsAre("1a", "2r2", "3-3"));
  say(0, 0, records::Verdict::Accept);
  EXPECT_THAT(now(), testing::UnorderedElementsAre("1-1", "2r2", "3-3"));
}

TEST_F(Decisions, EverythingCanBeTakenBackAndDoneAgain) {
  const store::DecisionRow swapped = say(0, 1, records::Verdict::Accept);
  withdraw(swapped);
  EXPECT_THAT(now(), ElementsAre("1-1", "2-2", "3-3"));
  EXPECT_THAT(sherds(), ElementsAre("1-1", "2-2", "3-3"));
  withdraw(PairDecisions(catalogue()).all(batch)->back().row);
  EXPECT_THAT(now(), ElementsAre("1-2", "3-3"));
  EXPECT_EQ(PairDecisions(catalogue()).all(batch)->size(), 6u) << "nothing is ever removed";
}

TEST_F(Decisions, ANumberStaysWithItsFront) {
  const store::SherdRow sherd = Sherds(catalogue()).rows(batch)->front();
  ASSERT_TRUE(Numbers(catalogue()).assign(std::span(&sherd, 1), anna));
  say(0, 1, records::Verdict::Accept);
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->number, "ARM1-T3-0012-0001");
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->front, front[0]);
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->back, back[1]);
  say(0, -1, records::Verdict::Aside);
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->state, records::SherdState::Numbered);
  EXPECT_FALSE(Sherds(catalogue()).get(sherd)->back);
}

TEST_F(Decisions, WhatWasMadeFromAnotherPairIsForgotten) {
  const store::SherdRow sherd = Sherds(catalogue()).rows(batch)->front();
  records::Measurement length{sherd, "length", {}, 50, {}, "program", {}, "m"};
  ASSERT_TRUE(Measurements(catalogue()).add(length, {}));
  records::Measurement weight{sherd, "weight", {}, 23.4, {}, "scale", {}, ""};
  ASSERT_TRUE(Measurements(catalogue()).add(weight, anna));
  say(0, 1, records::Verdict::Accept);
  EXPECT_EQ(valueOf(sherd, "length_mm"), "");
  EXPECT_EQ(valueOf(sherd, "weight_g"), "23.4") << "weighed by a person: it stays";
}

TEST_F(Decisions, WhatMakesNoSenseIsRefused) {
  records::PairDecision turned = pair(0, 0, records::Verdict::Accept);
  std::swap(turned.front, turned.back);
  EXPECT_FALSE(PairDecisions(catalogue()).add(turned, anna));
  EXPECT_FALSE(PairDecisions(catalogue()).add(pair(0, -1, records::Verdict::Accept), anna));
  EXPECT_FALSE(PairDecisions(catalogue()).add(pair(-1, -1, records::Verdict::Aside), anna));
  records::PairDecision of_program;
  of_program.batch = batch;
  of_program.verdict = records::Verdict::Withdraw;
  of_program.replaces = PairDecisions(catalogue()).all(batch)->front().row;
  EXPECT_FALSE(PairDecisions(catalogue()).add(of_program, anna)) << "reject it instead";
}

TEST_F(Decisions, TheListIsOnlyAddedTo) {
  EXPECT_THROW(catalogue().database().script("UPDATE pair_decision SET note = 'x'"),
               store::SqlFailure);
  EXPECT_THROW(catalogue().database().script("DELETE FROM pair_decision"), store::SqlFailure);
  EXPECT_THROW(catalogue().database().script("DELETE FROM history"), store::SqlFailure);
  EXPECT_THROW(catalogue().database().script("UPDATE history SET why = 'x'"), store::SqlFailure);
}

TEST(VoidReason, IsTranslatedWhereItIsTheProgramsOwn) {
  EXPECT_EQ(voidReason("its front no longer has a back").templateWords(),
            "its front no longer has a back");
  EXPECT_EQ(voidReason("dropped"), "dropped");
  EXPECT_TRUE(voidReason("dropped").templateWords().empty());
}

}  // namespace
}  // namespace ostraka::sherds
