// What two persons decided about one scan.
#include <gmock/gmock.h>

#include "base/uuid.h"
#include "intake/piece_decisions.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using namespace catalogue;

class TwoDecisions : public Conflicts {
 protected:
  void decide(upkeep::Project& project, records::Verdict verdict) {
    const std::vector<records::ScanRecord> scans =
        valueIn(Batches(project.catalogue()).scans(batch));
    records::PairDecision d;
    d.batch = batch;
    d.verdict = verdict;
    for (const records::ScanRecord& scan : scans)
      if (scan.index == 1) (scan.side == batch::Side::Front ? d.front : d.back) = scan.row;
    EXPECT_TRUE(sherds::PairDecisions(project.catalogue()).add(d, anna));
  }
  bool accepted() {
    for (const auto& d : valueIn(sherds::PairDecisions(catalogue()).current(batch)))
      if (d.by && d.verdict == records::Verdict::Accept) return true;
    return false;
  }
};

TEST_F(TwoDecisions, ThatAreTheSameNeedNoPerson) {
  decide(*project_, records::Verdict::Accept);
  decide(b_, records::Verdict::Accept);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_TRUE(accepted());
}

TEST_F(TwoDecisions, ThatDifferOnOnePairAreSettledAndNoneGoes) {
  decide(*project_, records::Verdict::Reject);
  decide(b_, records::Verdict::Accept);
  const MergeReport open = merged(*project_, b_);
  Settled settled;
  for (const std::string& id : openIn(open)) settled[id] = take(Take::B);
  ASSERT_FALSE(settled.empty());
  EXPECT_TRUE(settled.begin()->first.starts_with("pair/"));
  const std::size_t before = sherds::PairDecisions(catalogue()).all(batch)->size();
  EXPECT_TRUE(merged(*project_, b_, settled).entered);
  EXPECT_TRUE(accepted());
  EXPECT_EQ(sherds::PairDecisions(catalogue()).all(batch)->size(), before + 2)
      << "B's, and the withdrawal of A's";
  const std::string after = contentIn(*project_);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(contentIn(*project_), after);
}

class TwoPieceDecisions : public Conflicts {
 protected:
  /// These fragments of a side are one sherd.
  void join(upkeep::Project& project, batch::Side side, const std::vector<std::string>& names) {
    intake::PieceDecision d;
    d.batch = batch;
    d.side = side;
    for (const std::string& name : names) d.pieces.push_back({name, {10, 20}});
    d.decision = newId(now_ms += 1);
    ASSERT_TRUE(intake::decidePieces(project.catalogue(), d, anna));
  }
  /// Verdicts of a project with the fragments that they name, oldest first; withdrawals by which of
  /// those before they end.
  static std::vector<std::string> decided(upkeep::Project& project, store::BatchRow batch) {
    std::vector<std::string> all;
    std::map<std::int64_t, std::size_t> at;
    for (const auto& d : valueIn(intake::pieceDecisions(project.catalogue(), batch))) {
      at[d.row.value] = all.size();
      std::string words = d.verdict == intake::PieceVerdict::Withdraw
                              ? "withdraws " + all.at(at.at(d.replaces.value))
                              : "";
      for (const intake::NamedPiece& piece : d.pieces)
        words += (words.empty() ? "" : "+") + piece.name;
      all.push_back(words);
    }
    return all;
  }
  std::string conflict(const std::string& side) {
    return "pieces/" + Batches(catalogue()).get(batch)->id + "/" + side;
  }
};

TEST_F(TwoPieceDecisions, OfWhichOneProjectHasNoneComeToIt) {
  join(b_, batch::Side::Front, {"f001", "f002"});
  EXPECT_THAT(merged(*project_, b_).conflicts, IsEmpty());
  EXPECT_THAT(decided(*project_, batch), ElementsAre("f001+f002"));
  const std::string after = contentIn(*project_);
  merged(*project_, b_);
  EXPECT_EQ(contentIn(*project_), after);
}

TEST_F(TwoPieceDecisions, OnTwoSidesOrOfTheSameFragmentsAreNoConflict) {
  join(*project_, batch::Side::Front, {"f001", "f002"});
  join(b_, batch::Side::Back, {"b002", "b003"});
  join(b_, batch::Side::Front, {"f001", "f002"});
  EXPECT_THAT(merged(*project_, b_).conflicts, IsEmpty());
  EXPECT_THAT(decided(*project_, batch),
              testing::UnorderedElementsAre("f001+f002", "b002+b003", "f001+f002"));
}

TEST_F(TwoPieceDecisions, ThatDifferOnOneSideAreSettledAndTheOthersIsWithdrawnForAllToSee) {
  join(*project_, batch::Side::Front, {"f001", "f002"});
  join(b_, batch::Side::Front, {"f002", "f003"});
  join(b_, batch::Side::Back, {"b001", "b002"});
  settle({{conflict("front"), take(Take::B)}});
  EXPECT_THAT(
      decided(*project_, batch),
      testing::UnorderedElementsAre("f001+f002", "f002+f003", "b001+b002", "withdraws f001+f002"));
}

TEST_F(TwoPieceDecisions, OfBThatLoseAreWithdrawnAndStillListed) {
  join(*project_, batch::Side::Front, {"f001", "f002"});
  join(b_, batch::Side::Front, {"f002", "f003"});
  const MergeReport open = merged(*project_, b_);
  ASSERT_EQ(open.conflicts.size(), 1U);
  EXPECT_EQ(open.conflicts[0].id, conflict("front"));
  settle({{conflict("front"), take(Take::A)}});
  EXPECT_THAT(decided(*project_, batch),
              ElementsAre("f001+f002", "f002+f003", "withdraws f002+f003"));
}

}  // namespace
}  // namespace ostraka::merge
