#include "decisions/decisions.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/uuid.h"
#include "decisions/candidate_table.h"
#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;
using batch::Side;

class DecisionsOf : public testing::Test {
 protected:
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
  /// 1 for the first in the file.
  std::vector<int> placesOf(const std::vector<std::string>& ids) const {
    std::vector<int> places;
    const Decisions all = *readDecisions(out_);
    for (const std::string& id : ids)
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].id == id) places.push_back(static_cast<int>(i) + 1);
    return places;
  }
  std::vector<int> placesOf(const Decisions& decisions) const {
    std::vector<std::string> ids;
    for (const PairDecision& d : decisions) ids.push_back(d.id);
    return placesOf(ids);
  }
  std::vector<int> standingPlaces() const { return placesOf(standing(*readDecisions(out_))); }

  TemporaryFolder temporary_;
  fs::path out_ = temporary_.path();
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
  EXPECT_TRUE(isUuid(r.id)) << r.id;
  EXPECT_EQ(momentOf(r), r.at.substr(0, 10) + " " + r.at.substr(11, 5) + " UTC");
  EXPECT_EQ(r.by, "AP");
  EXPECT_EQ(r.note, d.note);
  EXPECT_EQ(r.at.size(), 20u) << "UTC to the second: " << r.at;
  EXPECT_EQ(r.settle, Settle::AsGiven);
  ASSERT_TRUE(r.front_from_back.has_value());
  EXPECT_EQ(r.front_from_back->matrix(), d.front_from_back->matrix());
  EXPECT_EQ(r.scans[1].id, "b002");
  EXPECT_EQ(r.scans[1].place_mm, Eigen::Vector2d(100, 20));
}

TEST_F(DecisionsOf, NameThoseThatTheyReplaceByTheirIds) {
  const PairDecision first = append(pair(1, 2));
  const PairDecision second = append(pair(1, 3));
  EXPECT_NE(first.id, second.id);
  EXPECT_EQ(second.replaces, std::vector<std::string>{first.id});
  EXPECT_EQ(readDecisions(out_)->back().replaces, std::vector<std::string>{first.id});
}

TEST_F(DecisionsOf, ANewPairReplacesAllThatWasSaidAboutItsTwoScans) {
  append(pair(1, 2));
  append(pair(2, 1));
  append(pair(3, 3));
  const PairDecision both = append(pair(1, 1));
  EXPECT_EQ(placesOf(both.replaces), (std::vector<int>{1, 2}));
  EXPECT_EQ(standingPlaces(), (std::vector<int>{3, 4}));
}

// Another window may have decided about what would hold again.
TEST_F(DecisionsOf, AWithdrawalBringsBackNothingThatContradictsALaterDecision) {
  append(pair(1, 1));
  PairDecision undo;
  undo.kind = DecisionKind::Withdraw;
  undo.by = "AP";
  undo.replaces = {append(pair(1, 2)).id};
  append(pair(2, 1));  // of back 1 nothing was said any more
  const Result<PairDecision> refused = appendDecision(out_, undo);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what,
            "The field pair was changed meanwhile; nothing was undone or redone.");
  EXPECT_EQ(standingPlaces(), (std::vector<int>{2, 3}));
}

TEST_F(DecisionsOf, WhatADecisionReplacesIsToldBeforeItIsAppended) {
  append(pair(1, 1));
  append(pair(2, 2));
  append(pair(3, 3));
  const Decisions replaced = *replacedBy(pair(1, 2), out_);
  EXPECT_EQ(placesOf(replaced), (std::vector<int>{1, 2}));
  EXPECT_TRUE(equivalent(replaced, {pair(2, 2), pair(1, 1)})) << "in any order";
  EXPECT_FALSE(equivalent(replaced, {pair(1, 1)}));
  EXPECT_FALSE(equivalent(replaced, {pair(1, 1), pair(3, 3)}));
  EXPECT_EQ(append(pair(1, 2)).replaces.size(), 2u);
}

TEST_F(DecisionsOf, AWithdrawalBringsBackWhatWasReplacedAndLosesNothing) {
  append(pair(1, 2));
  append(pair(2, 1));
  const PairDecision both = append(pair(1, 1));
  PairDecision undo;
  undo.kind = DecisionKind::Withdraw;
  undo.by = "AP";
  undo.replaces = {both.id};
  append(undo);
  EXPECT_EQ(standingPlaces(), (std::vector<int>{1, 2}));
  EXPECT_EQ(readDecisions(out_)->size(), 4u);
  EXPECT_FALSE(appendDecision(out_, undo).has_value()) << "it does not hold any more";
  append(pair(1, 1));
  EXPECT_EQ(standingPlaces(), (std::vector<int>{5}));
}

TEST_F(DecisionsOf, SettingAsideReplacesAPairAndAPairBringsItBack) {
  append(pair(1, 1));
  PairDecision aside;
  aside.kind = DecisionKind::Aside;
  aside.by = "AP";
  aside.scans = {front(1)};
  append(aside);
  EXPECT_EQ(standingPlaces(), (std::vector<int>{2}));
  append(pair(1, 3));
  EXPECT_EQ(standingPlaces(), (std::vector<int>{3}));
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
  EXPECT_EQ(standingPlaces(), (std::vector<int>{2}));
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
  d = pair(1, 1);
  d.note = "\x1B[2J";
  EXPECT_FALSE(appendDecision(out_, d).has_value()) << "no document can hold its note";
}

TEST_F(DecisionsOf, ADamagedFileIsNamedAndLeftAsItIs) {
  for (const char* text :
       {"{", R"({"format":1,"decisions":[{"kind":"pair"}]})", R"({"format":99,"decisions":[]})",
        R"({"format":1,"decisions":[{"id":"","replaces":[],"kind":"melt",
                               "at":"","by":"AP","scans":[]}]})"}) {
    ASSERT_TRUE(writeFileAtomically(out_ / "decisions.json", text).has_value());
    const Result<Decisions> refused = readDecisions(out_);
    ASSERT_FALSE(refused.has_value()) << text;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(refused.error().sentence().english().find("decisions.json"), std::string::npos);
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
        R"("kind":"aside","note":"\u0000","scans":[{"side":"front","id":"f001","place_mm":[1,2]}])",
        R"("kind":"aside","scans":[{"side":"front","id":"\u001b[2J","place_mm":[1,2]}])",
        R"("kind":"aside","scans":[])", R"("kind":"withdraw","scans":[])"}) {
    const std::string text =
        R"({"format":1,"decisions":[{"id":"0190a0b0-0000-7000-8000-000000000007","replaces":[],)"
        R"("at":"","by":"AP",)" +
        std::string(wrong) + "}]}";
    ASSERT_TRUE(writeFileAtomically(out_ / "decisions.json", text).has_value());
    const Result<Decisions> refused = readDecisions(out_);
    ASSERT_FALSE(refused.has_value()) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    const std::string sentence = refused.error().sentence().english();
    EXPECT_NE(sentence.find("decisions.json"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("Decision 1"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("restore a copy"), std::string::npos) << "what to do: " << sentence;
  }
}

TEST_F(DecisionsOf, WithoutAnIdOfTheirOwnAreNamed) {
  append(pair(1, 1));
  append(pair(2, 2));
  const std::string text = *readFile(out_ / "decisions.json");
  const Decisions all = *readDecisions(out_);
  for (const std::string& id : {all[0].id, std::string("2"), std::string()}) {
    std::string wrong = text;
    wrong.replace(wrong.find(all[1].id), all[1].id.size(), id);
    const Result<Decisions> refused = parseDecisions(wrong, "decisions.json");
    ASSERT_FALSE(refused.has_value()) << id;
    EXPECT_NE(refused.error().sentence().english().find("Decision 2"), std::string::npos)
        << refused.error().sentence();
  }
}

// The text of decisions that each set front 1 aside; what each replaces, by places that begin at 1.
std::string asides(const std::vector<std::vector<std::size_t>>& replaced) {
  const auto id = [](std::size_t place) {
    const std::string digits = std::to_string(place);
    return "0190a0b0-0000-7000-8000-" + std::string(12 - digits.size(), '0') + digits;
  };
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < replaced.size(); ++i) {
    nlohmann::json ids = nlohmann::json::array();
    for (const std::size_t place : replaced[i]) ids.push_back(id(place));
    list.push_back({{"id", id(i + 1)},
                    {"replaces", ids},
                    {"kind", "aside"},
                    {"at", ""},
                    {"by", "AP"},
                    {"scans", {{{"side", "front"}, {"id", "f001"}, {"place_mm", {1, 2}}}}}});
  }
  return nlohmann::json({{"format", 1}, {"unit", "mm"}, {"decisions", list}}).dump();
}

TEST_F(DecisionsOf, ReplaceOnlyEarlierOnesAndEachOnce) {
  const Result<Decisions> fine = parseDecisions(asides({{}, {}, {1, 2}}), "decisions.json");
  ASSERT_TRUE(fine.has_value()) << fine.error().sentence();
  EXPECT_EQ(standing(*fine).size(), 1u);
  const std::vector<std::vector<std::vector<std::size_t>>> wrong = {
      {{}, {}, {1, 1}}, {{}, {2}}, {{2}, {}}, {{}, {77}}};
  for (const auto& lists : wrong) {
    const Result<Decisions> refused = parseDecisions(asides(lists), "decisions.json");
    ASSERT_FALSE(refused.has_value()) << asides(lists);
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(refused.error().sentence().english().find("decisions.json"), std::string::npos)
        << refused.error().sentence();
  }
}

TEST_F(DecisionsOf, AreNoMoreThanAPersonTakes) {
  const std::vector<std::vector<std::size_t>> most(limits::kDecisions.most);
  ASSERT_TRUE(writeFileAtomically(out_ / "decisions.json", asides(most)).has_value());
  ASSERT_TRUE(readDecisions(out_).has_value());
  const Result<PairDecision> one_more = appendDecision(out_, pair(1, 1));
  ASSERT_FALSE(one_more.has_value()) << "the file could not be read any more";
  EXPECT_EQ(one_more.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(readDecisions(out_)->size(), most.size());
  const std::vector<std::vector<std::size_t>> more(limits::kDecisions.most + 1);
  EXPECT_FALSE(parseDecisions(asides(more), "decisions.json").has_value());

  std::vector<std::vector<std::size_t>> lists(limits::kDecisionReplaces.most + 2);
  for (std::size_t i = 1; i <= limits::kDecisionReplaces.most; ++i) lists.back().push_back(i);
  EXPECT_TRUE(parseDecisions(asides(lists), "decisions.json").has_value());
  lists.back().push_back(limits::kDecisionReplaces.most + 1);
  EXPECT_FALSE(parseDecisions(asides(lists), "decisions.json").has_value());
}

TEST_F(DecisionsOf, AreNotAboutASideThatWasPhotographedAgain) {
  const std::vector<ScanRef> now = {{Side::Front, "f001", {0, 0}, "new"}};
  EXPECT_EQ(resolved({Side::Front, "f001", {0, 0}, "old"}, now), -1);
  EXPECT_EQ(resolved({Side::Front, "f001", {0, 0}, "new"}, now), 0);
  EXPECT_EQ(resolved({Side::Front, "f001", {0, 0}, {}}, now), 0)
      << "of results without photographs";
  PairDecision d = pair(1, 1);
  d.scans[0].photographs = "old";
  append(d);
  EXPECT_EQ(readDecisions(out_)->front().scans[0].photographs, "old");
  d.scans[0].photographs = "new";
  EXPECT_EQ(placesOf(append(d).replaces), std::vector<int>{1})
      << "decided again, the old word is replaced";
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
    const Decisions all = *readDecisions(out_);
    return placesOf(changedSince(all, followed(all, out_)));
  };
  const auto computedWith = [&](const std::vector<std::string>& ids) {
    return writeFileAtomically(out_ / "report.json", nlohmann::json({{"decisions", ids}}).dump());
  };
  const std::string first = append(pair(1, 1)).id, second = append(pair(2, 2)).id;
  EXPECT_EQ(changed(), (std::vector<int>{1, 2})) << "there are no results";
  ASSERT_TRUE(computedWith({first}));
  EXPECT_EQ(changed(), std::vector<int>{2}) << "taken while it was computed";
  ASSERT_TRUE(computedWith({first, second}));
  EXPECT_TRUE(changed().empty());
  PairDecision back;
  back.kind = DecisionKind::Withdraw;
  back.by = "AP";
  back.replaces = {first};
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
}

}  // namespace
}  // namespace ostraka::decisions
