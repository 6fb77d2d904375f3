// A person's decisions in the catalogue: rows are only added, and what counts follows.
#include "intake/review_decisions.h"

#include <nlohmann/json.hpp>

#include "catalogue/batches.h"
#include "catalogue/places.h"
#include "decisions/candidate_table.h"
#include "files/files.h"
#include "intake/piece_decisions.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

using decisions::DecisionKind;

class ReviewDecisions : public catalogue::SmallProject {
 protected:
  ReviewDecisions() : batch(newBatch({bag4})) {
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      records::ScanRecord scan;
      scan.batch = batch;
      scan.side = side;
      scan.index = 1;
      scan.name = side == batch::Side::Front ? "f001" : "b001";
      scan.path = "results/B0001/scans/" + scan.name + ".ply";
      EXPECT_TRUE(catalogue::Batches(catalogue()).save(scan, {}));
    }
  }
  static std::string idOf(int number) {
    return "0190a0b0-0000-7000-8000-00000000000" + std::to_string(number);
  }
  static decisions::PairDecision decision(DecisionKind kind, int number) {
    decisions::PairDecision d;
    d.kind = kind;
    d.id = idOf(number);
    d.by = "AP";
    d.scans = {{batch::Side::Front, "f001", {0, 0}}, {batch::Side::Back, "b001", {0, 0}}};
    return d;
  }
  Result<void> enter(const decisions::PairDecision& d) {
    return enterDecision(catalogue(), "B0001", d, project_->resultsFolder("B0001"));
  }
  store::BatchRow batch;
};

TEST_F(ReviewDecisions, APairCountsAndItsWithdrawalTakesItBack) {
  const std::size_t persons = catalogue::People(catalogue()).all()->size();
  const Result<void> entered = enter(decision(DecisionKind::Pair, 1));
  ASSERT_TRUE(entered) << entered.error().sentence();
  ASSERT_EQ(sherds::PairDecisions(catalogue()).current(batch)->size(), 1u);
  EXPECT_EQ(sherds::PairDecisions(catalogue()).current(batch)->front().verdict,
            records::Verdict::Accept);
  decisions::PairDecision back = decision(DecisionKind::Withdraw, 2);
  back.replaces = {idOf(1)};
  ASSERT_TRUE(enter(back));
  EXPECT_TRUE(sherds::PairDecisions(catalogue()).current(batch)->empty());
  EXPECT_EQ(sherds::PairDecisions(catalogue()).all(batch)->size(), 2u);
  EXPECT_EQ(catalogue::People(catalogue()).all()->size(), persons) << "AP was there";
}

TEST_F(ReviewDecisions, InitialsInOtherCapitalsAreTheSamePerson) {
  decisions::PairDecision typed = decision(DecisionKind::Aside, 2);
  typed.by = "ap";
  const Result<void> entered = enter(typed);
  ASSERT_TRUE(entered) << entered.error().sentence();
  for (const records::PairDecision& row :
       catalogue::valueIn(sherds::PairDecisions(catalogue()).all(batch)))
    EXPECT_EQ(row.by, anna.person);
}

TEST_F(ReviewDecisions, EachScanSetAsideHasARow) {
  ASSERT_TRUE(enter(decision(DecisionKind::Aside, 1)));
  EXPECT_EQ(sherds::PairDecisions(catalogue()).all(batch)->size(), 2u);
}

TEST_F(ReviewDecisions, JoinsAndCutsAreKeptAndTakenBack) {
  decisions::PairDecision join = decision(DecisionKind::Join, 2);
  join.scans[0] = {batch::Side::Back, "b002", {5, 6}};
  ASSERT_TRUE(enter(join));
  decisions::PairDecision back = join;
  back.kind = DecisionKind::Withdraw;
  back.id = idOf(3);
  back.replaces = {join.id};
  ASSERT_TRUE(enter(back));
  const auto kept = pieceDecisions(catalogue(), batch);
  ASSERT_EQ(kept->size(), 2u);
  EXPECT_EQ(kept->at(0).side, batch::Side::Back);
  EXPECT_EQ(kept->at(0).pieces.at(0).name, "b002");
  EXPECT_EQ(kept->at(1).verdict, PieceVerdict::Withdraw);
  EXPECT_EQ(kept->at(1).replaces, kept->at(0).row);
  EXPECT_TRUE(sherds::PairDecisions(catalogue()).all(batch)->empty());
}

TEST_F(ReviewDecisions, AScanThatIsNotEnteredIsSaid) {
  decisions::PairDecision d = decision(DecisionKind::Pair, 1);
  d.scans[1].id = "b009";
  const Result<void> refused = enter(d);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().english().find("b009"), std::string::npos);
  EXPECT_FALSE(enterDecision(catalogue(), "B0077", d, project_->resultsFolder("B0077")));
}

// The pieces were numbered anew between the decision and its entry.
TEST_F(ReviewDecisions, AScanIsKnownByItsPlace) {
  std::vector<records::ScanRecord> scans =
      catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch));
  records::ScanRecord other = scans.front();
  for (records::ScanRecord& scan : scans) {
    scan.plate_x_mm = 40;
    scan.plate_y_mm = 0;
    ASSERT_TRUE(catalogue::Batches(catalogue()).save(scan, {}));
  }
  other.row = {};
  other.id.clear();
  other.index = 2;
  other.name = "f002";
  other.plate_x_mm = other.plate_y_mm = 0;
  const store::ScanRow meant = *catalogue::Batches(catalogue()).save(other, {});
  decisions::PairDecision d = decision(DecisionKind::Aside, 1);
  d.scans = {{batch::Side::Front, "f001", {3, 1}}};
  ASSERT_TRUE(enter(d));
  EXPECT_EQ(sherds::PairDecisions(catalogue()).all(batch)->front().front, meant);
  // Another piece has its old name by now, and none lies where it lay.
  d.id = idOf(2);
  d.scans = {{batch::Side::Front, "f001", {90, 90}}};
  EXPECT_FALSE(enter(d));
}

TEST_F(ReviewDecisions, WhatWasDecidedWithoutTheCatalogueIsEnteredOnce) {
  const std::filesystem::path output = project_->resultsFolder("B0001");
  std::filesystem::create_directories(output);
  const auto append = [&](DecisionKind kind, std::vector<decisions::ScanRef> scans) {
    decisions::PairDecision d;
    d.kind = kind;
    d.by = "AP";
    d.scans = std::move(scans);
    const auto written = decisions::appendDecision(output, d);
    EXPECT_TRUE(written) << (written ? "" : written.error().sentence());
    return *written;
  };
  const decisions::ScanRef front{batch::Side::Front, "f001", {0, 0}},
      back{batch::Side::Back, "b001", {0, 0}};
  ASSERT_TRUE(enter(append(DecisionKind::Aside, {front})));
  append(DecisionKind::Pair, {front, back});
  append(DecisionKind::Aside, {{batch::Side::Front, "f007", {90, 90}}});
  EXPECT_EQ(*followDecisions(catalogue(), "B0001", output), 1) << "f007 is gone";
  EXPECT_EQ(*followDecisions(catalogue(), "B0001", output), 0);
  ASSERT_EQ(sherds::PairDecisions(catalogue()).current(batch)->size(), 1u);
  const records::PairDecision now = sherds::PairDecisions(catalogue()).current(batch)->front();
  EXPECT_EQ(now.verdict, records::Verdict::Accept);
  EXPECT_EQ(now.by, anna.person);
}

// Rows that came with another computer's export, or of a results folder that was moved away.
TEST_F(ReviewDecisions, ADecisionOfAnotherFileIsNotMistakenForOneOfThisFile) {
  const std::filesystem::path output = project_->resultsFolder("B0001");
  std::filesystem::create_directories(output);
  const decisions::PairDecision elsewhere = decision(DecisionKind::Pair, 1);
  ASSERT_TRUE(enter(elsewhere));
  const auto here = decisions::appendDecision(output, decision(DecisionKind::Pair, 0));
  ASSERT_TRUE(here);
  EXPECT_EQ(*followDecisions(catalogue(), "B0001", output), 1) << "it is not there already";
  decisions::PairDecision back = decision(DecisionKind::Withdraw, 0);
  back.replaces = {here->id};
  ASSERT_TRUE(enter(*decisions::appendDecision(output, back)));
  ASSERT_EQ(sherds::PairDecisions(catalogue()).current(batch)->size(), 1u)
      << "the other's word stands";
  EXPECT_EQ(sherds::PairDecisions(catalogue()).current(batch)->front().decision, elsewhere.id);
}

// Two fronts and two backs with their places, and decisions.json beside the table of these results.
class ResultsOfDecisions : public ReviewDecisions {
 protected:
  ResultsOfDecisions() : output(project_->resultsFolder("B0001")) {
    std::filesystem::create_directories(output);
    for (int i = 1; i <= 2; ++i)
      for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
        records::ScanRecord record;
        for (const records::ScanRecord& there :
             catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
          if (there.side == side && there.index == i) record = there;
        record.batch = batch;
        record.side = side;
        record.index = i;
        record.name = nameOf(side, i);
        record.path = "results/B0001/scans/" + record.name + ".ply";
        record.plate_x_mm = 40 * i;
        record.plate_y_mm = 0;
        rows[{side, i}] = *catalogue::Batches(catalogue()).save(record, {});
      }
    computed("first", {40, 80});
  }
  static std::string nameOf(batch::Side side, int i) {
    return (side == batch::Side::Front ? "f00" : "b00") + std::to_string(i);
  }
  // The chain's results: pieces of both sides at these places, in photographs of this name.
  void computed(const std::string& photographs, const std::vector<double>& at_mm) {
    decisions::CandidateTable table;
    for (std::size_t i = 0; i < at_mm.size(); ++i) {
      const int n = static_cast<int>(i) + 1;
      table.fronts.push_back(
          {batch::Side::Front, nameOf(batch::Side::Front, n), {at_mm[i], 0}, {}});
      table.backs.push_back({batch::Side::Back, nameOf(batch::Side::Back, n), {at_mm[i], 0}, {}});
      table.fronts.back().photographs = table.backs.back().photographs = photographs;
    }
    ASSERT_TRUE(writeFileAtomically(output / "work/pairs/candidates.json",
                                    decisions::toJson(table).dump()));
  }
  decisions::PairDecision taken(DecisionKind kind, std::vector<decisions::ScanRef> scans,
                                std::vector<std::string> replaces = {}) {
    decisions::PairDecision d;
    d.kind = kind;
    d.by = "AP";
    d.scans = std::move(scans);
    d.replaces = std::move(replaces);
    return catalogue::valueIn(decisions::appendDecision(output, d));
  }
  static decisions::ScanRef front(int i) {
    return {batch::Side::Front, nameOf(batch::Side::Front, i), {40.0 * i, 0}, "first"};
  }
  static decisions::ScanRef back(int i) {
    return {batch::Side::Back, nameOf(batch::Side::Back, i), {40.0 * i, 0}, "first"};
  }
  // The i-th front by its new number and place.
  store::ScanRow moved(int i, int number, double x_mm) {
    for (records::ScanRecord scan :
         catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
      if (scan.row == rows[{batch::Side::Front, i}]) {
        scan.index = 10 + number;  // out of the way of the other
        scan.name = nameOf(batch::Side::Front, number);
        scan.plate_x_mm = x_mm;
        return *catalogue::Batches(catalogue()).save(scan, {});
      }
    return {};
  }
  int follow() { return catalogue::valueIn(followDecisions(catalogue(), "B0001", output)); }
  /// "f1-b2 f2": what counts, fronts first.
  std::string counting() {
    std::string text;
    for (const records::PairDecision& d :
         catalogue::valueIn(sherds::PairDecisions(catalogue()).current(batch))) {
      text += text.empty() ? "" : " ";
      for (const auto& [key, row] : rows)
        if (key.first == batch::Side::Front && row == d.front)
          text += "f" + std::to_string(key.second);
      for (const auto& [key, row] : rows)
        if (key.first == batch::Side::Back && row == d.back)
          text += "-b" + std::to_string(key.second);
    }
    return text;
  }
  std::filesystem::path output;
  std::map<std::pair<batch::Side, int>, store::ScanRow> rows;
};

TEST_F(ResultsOfDecisions, AWithdrawalThatTheCatalogueMissedIsEntered) {
  const decisions::PairDecision pair = taken(DecisionKind::Pair, {front(1), back(2)});
  ASSERT_TRUE(enter(pair));
  const decisions::PairDecision withdrawal = taken(DecisionKind::Withdraw, {}, {pair.id});
  EXPECT_EQ(follow(), 1);
  EXPECT_EQ(counting(), "");
  const records::PairDecision end =
      catalogue::valueIn(sherds::PairDecisions(catalogue()).all(batch)).back();
  EXPECT_EQ(end.by, anna.person);
  EXPECT_EQ(end.decision, withdrawal.id);
  EXPECT_EQ(follow(), 0);
  EXPECT_EQ(sherds::PairDecisions(catalogue()).all(batch)->size(), 2U) << "nothing is deleted";
}

TEST_F(ResultsOfDecisions, WhatWasSaidOfEarlierPhotographsDoesNotCount) {
  ASSERT_TRUE(enter(taken(DecisionKind::Pair, {front(1), back(2)})));
  taken(DecisionKind::Aside, {front(2)});  // the catalogue was busy
  computed("second", {40, 80});
  follow();
  EXPECT_EQ(counting(), "");
  EXPECT_EQ(follow(), 0);
  computed("first", {40, 80});  // the photographs were put back
  EXPECT_EQ(follow(), 2);
  EXPECT_EQ(counting(), "f1-b2 f2");
}

TEST_F(ResultsOfDecisions, WhatWasSaidOfAPieceThatIsGoneDoesNotCount) {
  ASSERT_TRUE(enter(taken(DecisionKind::Pair, {front(1), back(1)})));
  ASSERT_TRUE(enter(taken(DecisionKind::Aside, {front(2), back(2)})));
  computed("first", {55, 80});
  EXPECT_EQ(follow(), 1);
  EXPECT_EQ(counting(), "-b2 f2");
}

// Taken back, photographed again, done again: at its places other sherds lie by now.
TEST_F(ResultsOfDecisions, WhatIsDoneAgainAfterTheBacksWerePhotographedAgainPairsNobody) {
  const decisions::PairDecision pair = taken(DecisionKind::Pair, {front(1), back(2)});
  ASSERT_TRUE(enter(pair));
  ASSERT_TRUE(enter(taken(DecisionKind::Withdraw, {}, {pair.id})));
  computed("second", {40, 80});
  const Result<void> again = enter(taken(DecisionKind::Pair, pair.scans));
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().what.english().find("reshot"), std::string::npos);
  EXPECT_EQ(counting(), "");
  EXPECT_EQ(follow(), 0) << "the chain says the same";
  decisions::ScanRef now = back(2);
  now.photographs = "second";
  decisions::ScanRef with = front(1);
  with.photographs = "second";
  EXPECT_TRUE(enter(taken(DecisionKind::Pair, {with, now})));
  EXPECT_EQ(counting(), "f1-b2");
}

// The program ended between the file and the catalogue.
TEST_F(ResultsOfDecisions, WhatTheCatalogueMissedIsEnteredWhenTheBatchIsOpened) {
  const auto caught = [this] {
    return catalogue::valueIn(catchUp(project_->folder(), "B0001", output));
  };
  taken(DecisionKind::Pair, {front(1), back(1)});
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Review, {}));
  EXPECT_EQ(caught(), 0) << "its results are not whole";
  ASSERT_TRUE(writeFileAtomically(output / "report.json", "{}"));
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Flipped, {}));
  EXPECT_EQ(caught(), 0) << "its back is being photographed again";
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Review, {}));
  EXPECT_EQ(caught(), 1);
  EXPECT_EQ(counting(), "f1-b1");
  EXPECT_EQ(caught(), 0);
  EXPECT_EQ(catalogue::valueIn(catchUp(project_->folder(), "B0077", output)), 0)
      << "not in the catalogue";
}

TEST_F(ResultsOfDecisions, WhatALaterDecisionStandsAboveCountsAgainWhenThatIsTakenBack) {
  ASSERT_TRUE(enter(taken(DecisionKind::Pair, {front(1), back(1)})));
  const decisions::PairDecision later = taken(DecisionKind::Pair, {front(1), back(2)});
  ASSERT_TRUE(enter(later));
  EXPECT_EQ(follow(), 0);
  EXPECT_EQ(counting(), "f1-b2");
  ASSERT_TRUE(enter(taken(DecisionKind::Withdraw, {}, {later.id})));
  EXPECT_EQ(counting(), "f1-b1");
  EXPECT_EQ(follow(), 0);
  // One that replaced only a part of an earlier one frees the rest of it.
  ASSERT_TRUE(enter(taken(DecisionKind::Aside, {front(1), front(2)})));
  ASSERT_TRUE(enter(taken(DecisionKind::Pair, {front(1), back(1)})));
  EXPECT_EQ(follow(), 1);
  EXPECT_EQ(counting(), "f1-b1");
}

TEST_F(ResultsOfDecisions, WhatWasDecidedInTheCatalogueStays) {
  records::PairDecision own;
  own.batch = batch;
  own.front = rows.at({batch::Side::Front, 1});
  own.back = rows.at({batch::Side::Back, 2});
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(own, anna));
  own.decision = ReviewDecisions::idOf(1);  // of another computer's file
  own.front = rows.at({batch::Side::Front, 2});
  own.back = rows.at({batch::Side::Back, 1});
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(own, anna));
  const decisions::PairDecision reshoot = taken(DecisionKind::Reshoot, {front(1)});
  taken(DecisionKind::Withdraw, {}, {reshoot.id});
  const records::Provenance other{
      *catalogue::People(catalogue()).byInitials("MH", anna), "import", {}};
  own.decision = ReviewDecisions::idOf(2);  // likewise, of another person
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(own, other));
  computed("second", {300, 400});
  EXPECT_EQ(follow(), 0);
  EXPECT_EQ(counting(), "f1-b2 f2-b1");
}

TEST_F(ResultsOfDecisions, JoinsThatWereTakenBackAreTakenBack) {
  const decisions::PairDecision join = taken(DecisionKind::Join, {front(1), front(2)});
  EXPECT_EQ(follow(), 1);
  computed("first", {60});
  EXPECT_EQ(follow(), 0) << "its pieces are one now";
  taken(DecisionKind::Withdraw, {}, {join.id});
  EXPECT_EQ(follow(), 1);
  EXPECT_EQ(pieceDecisions(catalogue(), batch)->back().verdict, PieceVerdict::Withdraw);
}

TEST_F(ResultsOfDecisions, AJoinThatWasComputedAndTakenBackLeavesNoModelOfIt) {
  const decisions::PairDecision join = taken(DecisionKind::Join, {front(1), front(2)});
  records::SherdRecord whole;
  whole.context = context12;
  whole.batch = batch;
  whole.front = rows[{batch::Side::Front, 1}];
  whole.back = rows[{batch::Side::Back, 1}];
  const store::SherdRow sherd = catalogue::valueIn(sherds::Sherds(catalogue()).add(whole, anna));
  ASSERT_TRUE(sherds::Sherds(catalogue()).setModel(sherd, "models/B0001/1/model.ply", ""));
  const decisions::PairDecision back = taken(DecisionKind::Withdraw, {}, {join.id});
  ASSERT_TRUE(forgetPiecesOf(catalogue(), "B0001", back, output));
  EXPECT_FALSE(sherds::Sherds(catalogue()).get(sherd)->model_path.empty())
      << "the join was never computed";
  ASSERT_TRUE(writeFileAtomically(
      output / "report.json",
      nlohmann::json({{"format", "ostraka-report/1"}, {"decisions", {join.id}}}).dump()));
  // One piece now, and called otherwise: a stranger that was found beside it has its name.
  records::SherdRecord strange;
  strange.context = context12;
  strange.batch = batch;
  strange.front = moved(2, 1, -80);
  moved(1, 2, 60);
  const store::SherdRow stranger =
      catalogue::valueIn(sherds::Sherds(catalogue()).add(strange, anna));
  ASSERT_TRUE(sherds::Sherds(catalogue()).setModel(stranger, "models/B0001/2/model.ply", ""));
  ASSERT_TRUE(forgetPiecesOf(catalogue(), "B0001", back, output));
  EXPECT_TRUE(sherds::Sherds(catalogue()).get(sherd)->model_path.empty());
  EXPECT_FALSE(sherds::Sherds(catalogue()).get(stranger)->model_path.empty());
}

}  // namespace
}  // namespace ostraka::intake
