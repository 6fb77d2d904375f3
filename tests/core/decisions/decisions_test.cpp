#include "decisions/decisions.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "decisions/candidate_table.h"
#include "files/files.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;
using batch::Side;

class DecisionsOf : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "ostraka_decisions_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    out_ = pattern;
  }
  void TearDown() override { fs::remove_all(out_); }

  static ScanRef front(int i) { return {Side::Front, "f00" + std::to_string(i), {50.0 * i, 0}}; }
  static ScanRef back(int i) { return {Side::Back, "b00" + std::to_string(i), {50.0 * i, 20}}; }
  static PairDecision pair(int f, int b) {
    PairDecision d;
    d.kind = DecisionKind::Pair;
    d.by = "AP";
    d.scans = {front(f), back(b)};
    return d;
  }
  PairDecision append(const PairDecision& d) {
    const Result<PairDecision> written = appendDecision(out_, d);
    EXPECT_TRUE(written.has_value()) << (written ? "" : written.error().sentence());
    return written ? *written : PairDecision{};
  }
  // The results, with front 1 and these backs.
  void computed(const std::vector<int>& backs) const {
    CandidateTable table;
    table.fronts = {front(1)};
    for (const int i : backs) table.backs.push_back(back(i));
    table.front_files.resize(table.fronts.size());
    table.back_files.resize(table.backs.size());
    ASSERT_TRUE(writeFileAtomically(out_ / "work/pairs/candidates.json", toJson(table).dump()));
  }
  std::vector<int> standingNumbers() {
    std::vector<int> numbers;
    for (const PairDecision& d : standing(*readDecisions(out_))) numbers.push_back(d.number);
    return numbers;
  }

  fs::path out_;
};

TEST_F(DecisionsOf, ABatchWithoutAFileAreNone) {
  const Result<Decisions> none = readDecisions(out_);
  ASSERT_TRUE(none.has_value());
  EXPECT_TRUE(none->empty());
}

TEST_F(DecisionsOf, AreReadBackAsTheyWereTaken) {
  PairDecision d = pair(1, 2);
  d.note = "Fits by the painted band – seen in the light.";
  d.front_from_back = Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  d.front_from_back->translation() = Eigen::Vector3d(1.5, -2.25, 1.0 / 3);
  d.settle = Settle::AsGiven;
  append(d);
  const Result<Decisions> read = readDecisions(out_);
  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->size(), 1u);
  const PairDecision& r = read->front();
  EXPECT_EQ(r.number, 1);
  EXPECT_EQ(r.by, "AP");
  EXPECT_EQ(r.note, d.note);
  EXPECT_EQ(r.at.size(), 20u) << "UTC to the second: " << r.at;
  EXPECT_EQ(r.settle, Settle::AsGiven);
  ASSERT_TRUE(r.front_from_back.has_value());
  EXPECT_EQ(r.front_from_back->matrix(), d.front_from_back->matrix());
  EXPECT_EQ(r.scans[1].id, "b002");
  EXPECT_EQ(r.scans[1].place_mm, Eigen::Vector2d(100, 20));
}

TEST_F(DecisionsOf, NameTheMomentsOfThoseThatTheyReplace) {
  const PairDecision first = append(pair(1, 2));
  const PairDecision second = append(pair(1, 3));
  EXPECT_EQ(second.replaced_at, std::vector<std::string>{first.at});
  EXPECT_EQ(readDecisions(out_)->back().replaced_at, std::vector<std::string>{first.at});
}

TEST_F(DecisionsOf, ANewPairReplacesAllThatWasSaidAboutItsTwoScans) {
  append(pair(1, 2));
  append(pair(2, 1));
  append(pair(3, 3));
  const PairDecision both = append(pair(1, 1));
  EXPECT_EQ(both.replaces, (std::vector<int>{1, 2}));
  EXPECT_EQ(standingNumbers(), (std::vector<int>{3, 4}));
}

TEST_F(DecisionsOf, AWithdrawalBringsBackWhatWasReplacedAndLosesNothing) {
  append(pair(1, 2));
  append(pair(2, 1));
  const PairDecision both = append(pair(1, 1));
  PairDecision undo;
  undo.kind = DecisionKind::Withdraw;
  undo.by = "AP";
  undo.replaces = {both.number};
  append(undo);
  EXPECT_EQ(standingNumbers(), (std::vector<int>{1, 2}));
  EXPECT_EQ(readDecisions(out_)->size(), 4u);
  EXPECT_FALSE(appendDecision(out_, undo).has_value()) << "it does not hold any more";
  append(pair(1, 1));
  EXPECT_EQ(standingNumbers(), (std::vector<int>{5}));
}

TEST_F(DecisionsOf, SettingAsideReplacesAPairAndAPairBringsItBack) {
  append(pair(1, 1));
  PairDecision aside;
  aside.kind = DecisionKind::Aside;
  aside.by = "AP";
  aside.scans = {front(1)};
  append(aside);
  EXPECT_EQ(standingNumbers(), (std::vector<int>{2}));
  append(pair(1, 3));
  EXPECT_EQ(standingNumbers(), (std::vector<int>{3}));
}

TEST_F(DecisionsOf, ASherdThatWasTakenOutStaysOutWithBothItsSides) {
  computed({2, 3});
  PairDecision again;
  again.kind = DecisionKind::Reshoot;
  again.by = "AP";
  again.scans = {front(1), back(2)};
  append(again);
  again.scans = {front(1)};  // once more, where its card shows the front alone
  append(again);
  EXPECT_EQ(standingNumbers(), (std::vector<int>{2}));
  EXPECT_EQ(standing(*readDecisions(out_))[0].scans.size(), 2u);
  computed({3});  // its back was photographed again, or joined
  again.kind = DecisionKind::Aside;
  append(again);
  EXPECT_EQ(standing(*readDecisions(out_))[0].scans.size(), 1u);
  append(pair(1, 3));
  EXPECT_EQ(standing(*readDecisions(out_))[0].scans[1].id, back(3).id);
}

TEST_F(DecisionsOf, NobodyAreRefused) {
  PairDecision d = pair(1, 1);
  d.by.clear();
  const Result<PairDecision> refused = appendDecision(out_, d);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  d = pair(1, 1);
  std::swap(d.scans[0], d.scans[1]);
  EXPECT_FALSE(appendDecision(out_, d).has_value()) << "a pair is a front, then a back";
}

TEST_F(DecisionsOf, ADamagedFileIsNamedAndLeftAsItIs) {
  for (const char* text :
       {"{", R"({"format":1,"decisions":[{"kind":"pair"}]})", R"({"format":99,"decisions":[]})",
        R"({"format":1,"decisions":[{"number":1,"replaces":[],"kind":"melt",
                               "at":"","by":"AP","scans":[]}]})"}) {
    ASSERT_TRUE(writeFileAtomically(out_ / "decisions.json", text).has_value());
    const Result<Decisions> refused = readDecisions(out_);
    ASSERT_FALSE(refused.has_value()) << text;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(refused.error().sentence().find("decisions.json"), std::string::npos);
    EXPECT_FALSE(appendDecision(out_, pair(1, 1)).has_value());
    EXPECT_EQ(*readFile(out_ / "decisions.json"), text);
  }
}

// Anyone may have edited the file: what appendDecision would refuse is refused when it is read.
TEST_F(DecisionsOf, ThatNobodyCouldTakeAreNamed) {
  for (const char* wrong :
       {R"("kind":"join","scans":[])",
        R"("kind":"split","scans":[{"side":"front","id":"f001","place_mm":[1,2]}])",
        R"("kind":"pair","scans":[{"side":"back","id":"b001","place_mm":[1,2]}])",
        R"("kind":"aside","scans":[])", R"("kind":"withdraw","scans":[])"}) {
    const std::string text = R"({"format":1,"decisions":[{"number":7,"replaces":[],"at":"",)"
                             R"("by":"AP",)" +
                             std::string(wrong) + "}]}";
    ASSERT_TRUE(writeFileAtomically(out_ / "decisions.json", text).has_value());
    const Result<Decisions> refused = readDecisions(out_);
    ASSERT_FALSE(refused.has_value()) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    const std::string sentence = refused.error().sentence();
    EXPECT_NE(sentence.find("decisions.json"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("Decision 7"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("restore a copy"), std::string::npos) << "what to do: " << sentence;
  }
}

TEST_F(DecisionsOf, AreNotAboutASideThatWasPhotographedAgain) {
  const std::vector<ScanRef> now = {{Side::Front, "f001", {0, 0}, "new"}};
  EXPECT_EQ(resolved({Side::Front, "f001", {0, 0}, "old"}, now), -1);
  EXPECT_EQ(resolved({Side::Front, "f001", {0, 0}, "new"}, now), 0);
  EXPECT_EQ(resolved({Side::Front, "f001", {0, 0}, {}}, now), 0) << "of an older program";
  PairDecision d = pair(1, 1);
  d.scans[0].photographs = "old";
  append(d);
  EXPECT_EQ(readDecisions(out_)->front().scans[0].photographs, "old");
  d.scans[0].photographs = "new";
  EXPECT_EQ(append(d).replaces, std::vector<int>{1}) << "decided again, the old word is replaced";
}

TEST_F(DecisionsOf, FindTheirScanByItsPlaceWhenItsIdChanged) {
  const std::vector<ScanRef> now = {{Side::Front, "f001", {0, 0}}, {Side::Front, "f002", {51, 2}}};
  EXPECT_EQ(resolved({Side::Front, "f001", {50, 0}}, now), 1);
  EXPECT_EQ(resolved({Side::Front, "f001", {25, 0}}, now), -1) << "nothing lies there any more";
  EXPECT_EQ(resolved({Side::Back, "b001", {0, 0}}, now), -1);
}

TEST_F(DecisionsOf, SayTheSameWhoeverTookThemAndWhenever) {
  PairDecision one = pair(1, 1);
  one.front_from_back = Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  PairDecision other = append(one);
  other.by = "MH";
  EXPECT_TRUE(equivalent(one, other));
  other.front_from_back->translation().x() += 0.01;
  EXPECT_FALSE(equivalent(one, other)) << "another pose";
  other.front_from_back.reset();
  EXPECT_FALSE(equivalent(one, other)) << "a pose that the program finds";
  PairDecision cut;
  cut.kind = DecisionKind::Split;
  cut.scans = {front(1)};
  cut.cut_mm = {Eigen::Vector2d(40, 0), Eigen::Vector2d(60, 0)};
  PairDecision elsewhere = cut;
  EXPECT_TRUE(equivalent(cut, elsewhere));
  elsewhere.cut_mm[1].y() = 5;
  EXPECT_FALSE(equivalent(cut, elsewhere));
  PairDecision photographed_again = cut;
  photographed_again.scans[0].photographs = "second";
  EXPECT_FALSE(equivalent(cut, photographed_again));
}

// What the results follow is told by their report, not by the age of files.
TEST_F(DecisionsOf, WhatChangedSinceTheResultsIsKnown) {
  const auto changed = [&] {
    std::vector<int> numbers;
    const Decisions all = *readDecisions(out_);
    for (const PairDecision& d : changedSince(all, followed(all, out_)))
      numbers.push_back(d.number);
    return numbers;
  };
  append(pair(1, 1));
  append(pair(2, 2));
  EXPECT_EQ(changed(), (std::vector<int>{1, 2})) << "there are no results";
  ASSERT_TRUE(writeFileAtomically(out_ / "report.json", R"({"decisions": [1]})"));
  EXPECT_EQ(changed(), std::vector<int>{2}) << "taken while it was computed";
  ASSERT_TRUE(writeFileAtomically(out_ / "report.json", R"({"decisions": [1, 2]})"));
  EXPECT_TRUE(changed().empty());
  PairDecision back;
  back.kind = DecisionKind::Withdraw;
  back.by = "AP";
  back.replaces = {1};
  append(back);
  EXPECT_EQ(changed(), std::vector<int>{1}) << "followed, and holds no more";
  PairDecision again = pair(1, 1);
  again.by = "MH";
  again.note = "after all";
  append(again);
  EXPECT_TRUE(changed().empty()) << "done again: the results are of this pair still";
  again.scans[1] = DecisionsOf::back(3);
  append(again);
  EXPECT_EQ(changed(), (std::vector<int>{5, 1})) << "another back";
  ASSERT_TRUE(writeFileAtomically(out_ / "report.json", R"({"format": "of an earlier program"})"));
  EXPECT_TRUE(changed().empty());
}

}  // namespace
}  // namespace ostraka::decisions
