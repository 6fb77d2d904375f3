// Whose a number is, which measurement counts, and which sherds join.
#include <gmock/gmock.h>

#include <tuple>

#include "store/database.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using namespace catalogue;

class TwoNumbers : public Conflicts {
 protected:
  /// A new sherd in each project, with these numbers.
  std::pair<std::string, std::string> called(const std::string& in_a, const std::string& in_b) {
    const auto id = [&](upkeep::Project& project, const std::string& number) {
      const store::SherdRow sherd = newSherd(project, context13, false);
      say(project, sherd, "number", number);
      return sherds::Sherds(project.catalogue()).get(sherd)->id;
    };
    return {id(*project_, in_a), id(b_, in_b)};
  }
  static std::size_t sherdsIn(const upkeep::Project& project) {
    return valueIn(sherds::Sherds(project.catalogue()).rows(sherds::Filter{}, {})).size();
  }
  std::string ownerOf(const std::string& number) {
    return catalogue()
        .database()
        .sql("SELECT s.id FROM given_number g JOIN sherd s ON s.row = g.sherd WHERE g.number = ?",
             number)
        .one<std::string>();
  }
};

TEST_F(TwoNumbers, ANumberGivenToTwoSherdsStaysWithOne) {
  const std::string own = sherds::Sherds(catalogue()).get(newSherd(*project_, context13, true))->id;
  const std::string theirs = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  ASSERT_EQ(saidOf(*project_, own, "number"), saidOf(b_, theirs, "number"));
  settle({{"number/" + theirs, take(Take::A)}});
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0002");
}

TEST_F(TwoNumbers, ANumberGivenToTwoSherdsGoesToTheOther) {
  const std::string own = sherds::Sherds(catalogue()).get(newSherd(*project_, context13, true))->id;
  const std::string theirs = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0002");
}

TEST_F(TwoNumbers, ANumberGivenToTwoSherdsBecomesANewOne) {
  newSherd(*project_, context13, true);
  const std::string theirs = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  const Result<MergeReport> taken =
      tried(*project_, b_, {{"number/" + theirs, {Take::A, "ARM1-T3-0012-0001"}}});
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().what, testing::HasSubstr("never reused"));
  settle({{"number/" + theirs, {Take::A, "ARM1-T3-0013-0101"}}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0101");
}

TEST_F(TwoNumbers, ANumberGoesToTheOtherAndTheOwnSherdIsCalledAsAPersonSays) {
  const auto [own, theirs] = called("N-8", "N-8");
  settle({{"number/" + theirs, {Take::B, "ARM1-T3-0013-0031"}}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "N-8");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0031");
  // It counts as one of the scheme: the next is behind it.
  const store::SherdRow next = newSherd(*project_, context13, true);
  EXPECT_EQ(saidOf(*project_, idOf(next), "number"), "ARM1-T3-0013-0032");
}

// Whichever way each is settled, no two sherds get one number.
TEST_F(TwoNumbers, ThatAreOpenComeWithANewNumberForEitherSherd) {
  const auto [own, theirs] = called("N-8", "N-8");
  const auto [own_7, theirs_7] = called("N-7", "N-7");
  std::map<std::string, std::pair<std::string, std::string>> proposed;
  for (const Conflict& conflict : merged(*project_, b_).conflicts)
    proposed[conflict.name] = {conflict.new_a, conflict.new_b};
  EXPECT_THAT(proposed,
              testing::ElementsAre(
                  testing::Pair("N-7", testing::Pair("ARM1-T3-0013-0002", "ARM1-T3-0013-0002")),
                  testing::Pair("N-8", testing::Pair("ARM1-T3-0013-0001", "ARM1-T3-0013-0001"))));
  settle({{"number/" + theirs, {Take::B, proposed["N-8"].first}},
          {"number/" + theirs_7, {Take::A, proposed["N-7"].second}}});
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(saidOf(*project_, theirs_7, "number"), "ARM1-T3-0013-0002");
}

TEST_F(TwoNumbers, OfOneSherdAreOneRecordThatKeepsWhatBothSay) {
  const auto [own, theirs] = called("N-8", "n-8");
  const store::SherdRow mine = *sherds::Sherds(catalogue()).byId(own),
                        other = *sherds::Sherds(b_.catalogue()).byId(theirs);
  say(*project_, mine, "ware", "black");
  say(b_, other, "ware", "grey");
  say(b_, other, "note", "a foot");
  say(b_, other, "weight_g", "12.5");
  say(b_, other, "joins", "ARM1-T3-0012-0001");
  const auto count = sherdsIn(*project_);
  Settled settled = {{"number/" + theirs, take(Take::One)}};
  EXPECT_THAT(openIn(merged(*project_, b_, settled)),
              testing::UnorderedElementsAre("sherd/" + own + "/ware", "sherd/" + own + "/number"));
  settled["sherd/" + own + "/ware"] = take(Take::B);
  settled["sherd/" + own + "/number"] = take(Take::A);
  ASSERT_TRUE(merged(*project_, b_, settled).entered);
  EXPECT_EQ(sherdsIn(*project_), count);
  EXPECT_EQ(saidOf(*project_, own, "number"), "N-8");
  EXPECT_EQ(saidOf(*project_, own, "ware"), "grey");
  EXPECT_EQ(saidOf(*project_, own, "note"), "a foot");
  EXPECT_EQ(saidOf(*project_, own, "weight_g"), "12.5");
  EXPECT_EQ(saidOf(*project_, own, "joins"), "ARM1-T3-0012-0001");
  bool told = false;
  for (const auto& entry : valueIn(History(catalogue()).of("sherd", mine.value)))
    told |= entry.field == "one_with" && entry.new_value == theirs;
  EXPECT_TRUE(told) << "the history does not say that they were made one";
  const std::string content = contentIn(*project_);
  EXPECT_THAT(merged(*project_, b_).conflicts, testing::IsEmpty());
  EXPECT_EQ(contentIn(*project_), content);
  EXPECT_THAT(merged(b_, *project_).conflicts, testing::IsEmpty());
  EXPECT_EQ(saidOf(b_, theirs, "number"), "N-8");
  EXPECT_EQ(saidOf(b_, theirs, "ware"), "grey");
  EXPECT_EQ(sherdsIn(b_), count);
}

TEST_F(TwoNumbers, OfSherdsThatAreOneInOneProjectAndTwoInAnotherBecomeTwo) {
  const auto [own, theirs] = called("N-8", "N-8");
  say(*project_, *sherds::Sherds(catalogue()).byId(own), "weight_g", "7");
  say(b_, *sherds::Sherds(b_.catalogue()).byId(theirs), "weight_g", "7");
  upkeep::Project c = copied("c");  // has the own one
  merged(c, b_, {{"number/" + theirs, take(Take::A)}});
  merged(*project_, b_, {{"number/" + theirs, take(Take::One)}});
  const std::string other = saidOf(c, theirs, "number");
  ASSERT_NE(other, "N-8");
  ASSERT_TRUE(merged(*project_, c).entered);
  EXPECT_EQ(saidOf(*project_, own, "number"), "N-8");
  EXPECT_EQ(saidOf(*project_, own, "weight_g"), "7");
  EXPECT_EQ(saidOf(*project_, theirs, "number"), other);
  const std::string content = contentIn(*project_);
  for (const upkeep::Project* project : {&b_, &c}) {
    EXPECT_THAT(merged(*project_, *project).conflicts, testing::IsEmpty());
    EXPECT_EQ(contentIn(*project_), content);
  }
  EXPECT_TRUE(catalogue().checkIntegrity());
}

TEST_F(TwoNumbers, OfSherdsThatOneProjectKnowsApartAreNeverOne) {
  const auto [own, theirs] = called("N-8", "N-8");
  merged(b_, *project_, {{"number/" + own, take(Take::A)}});  // B knows both
  say(*project_, *sherds::Sherds(catalogue()).byId(own), "number", "N-9");
  say(*project_, *sherds::Sherds(catalogue()).byId(own), "number", "N-8");
  for (const Conflict& conflict : merged(*project_, b_).conflicts)
    EXPECT_FALSE(conflict.offers(Take::One)) << conflict.id;
}

TEST_F(TwoNumbers, ANumberInOtherLettersGoesToTheOther) {
  const auto [own, theirs] = called("q-7", "Q-7");
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "Q-7");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(ownerOf("Q-7"), theirs);
}

TEST_F(TwoNumbers, ANumberWithTheSameFileNameGoesToTheOther) {
  const auto [own, theirs] = called("R/1", "R_1");
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "R_1");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(ownerOf("R_1"), theirs);
}

TEST_F(TwoNumbers, ANumberThatASherdHadBeforeStaysItsOwn) {
  say(*project_, rows[0], "number", "N-9");
  const auto [own, theirs] = called("N-8", "N-9");
  say(*project_, rows[0], "number", "N-10");
  settle({{"number/" + theirs, take(Take::A)}});
  EXPECT_EQ(ownerOf("N-9"), idOf(rows[0]));
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0001");
}

TEST_F(TwoNumbers, ANumberThatASherdHadBeforeGoesToAnotherAsAPersonSays) {
  say(*project_, rows[0], "number", "N-9");
  const auto [own, theirs] = called("N-8", "N-9");
  say(*project_, rows[0], "number", "N-10");
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(ownerOf("N-9"), theirs);
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "N-9");
  EXPECT_EQ(valueOf(rows[0], "number"), "N-10");
}

TEST_F(TwoNumbers, ANewNumberIsCheckedAsATypedOne) {
  const auto [own, theirs] = called("q-7", "q-7");
  for (const std::string& number : {std::string("8\0x", 3), std::string("a\nb"), std::string("  "),
                                    std::string("8\u202e"), std::string(121, 'x')}) {
    const Result<MergeReport> refused =
        tried(*project_, b_, {{"number/" + theirs, {Take::A, number}}});
    ASSERT_FALSE(refused) << number;
    EXPECT_EQ(refused.error().where, "number/" + theirs);
  }
}

/// Two sherds with one number, each made in one house, and settled otherwise in each: N3 stands on
/// the label of the second in the first house, and of the first in the second one.
class SwappedNumbers : public TwoNumbers {
 protected:
  static constexpr const char *kFirst = "ARM1-T3-0013-0001", *kSecond = "ARM1-T3-0013-0002";
  void swap() {
    std::tie(x_, y_) = called("N3", "N3");
    const upkeep::Project old = copied("old");
    merged(*project_, b_, {{"number/" + y_, take(Take::B)}});
    merged(b_, old, {{"number/" + x_, take(Take::B)}});
  }
  std::string x_, y_;
};

TEST_F(SwappedNumbers, AreThoseOfTheOtherProjectWhereOneOfThemGoesOver) {
  swap();
  ASSERT_EQ(saidOf(*project_, x_, "number") + saidOf(*project_, y_, "number"),
            std::string(kFirst) + "N3");
  ASSERT_EQ(saidOf(b_, x_, "number") + saidOf(b_, y_, "number"), std::string("N3") + kFirst);
  settle({{"number/" + y_, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, x_, "number"), "N3");
  EXPECT_EQ(saidOf(*project_, y_, "number"), kFirst);
  EXPECT_EQ(ownerOf("N3"), x_);
  EXPECT_EQ(ownerOf(kFirst), y_);
}

TEST_F(SwappedNumbers, StayWhereAPersonSaysSoAndNobodyAsksAgain) {
  swap();
  settle({{"number/" + y_, take(Take::A)}});
  const std::vector<const upkeep::Project*> both = {&*project_, &b_};
  for (const upkeep::Project* project : both) {
    EXPECT_EQ(saidOf(*project, x_, "number"), kFirst);
    EXPECT_EQ(saidOf(*project, y_, "number"), "N3");
  }
}

TEST_F(SwappedNumbers, AreNamedWhereASherdGetsAnother) {
  swap();
  const MergeReport report = merged(*project_, b_, {{"number/" + y_, take(Take::B)}});
  EXPECT_THAT(report.new_numbers,
              testing::ElementsAre(testing::Pair(x_, testing::Pair(kFirst, "N3"))));
}

TEST_F(SwappedNumbers, AreAConflictOfTheirOwnWhereAThirdSherdBearsTheFreeOne) {
  std::tie(x_, y_) = called("N3", "N3");
  const upkeep::Project old = copied("old");
  merged(*project_, b_, {{"number/" + y_, take(Take::B)}});  // the first one is 0001
  const std::string third = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  ASSERT_EQ(saidOf(b_, third, "number"), kFirst);
  merged(b_, old, {{"number/" + x_, take(Take::B)}});
  ASSERT_EQ(saidOf(b_, y_, "number"), kSecond);
  // A person in the first house says once more that the second one bears N3.
  const store::SherdRow y = *sherds::Sherds(catalogue()).byId(y_);
  say(*project_, y, "number", "M-1");
  say(*project_, y, "number", "N3");
  Settled settled = {{"sherd/" + y_ + "/number", take(Take::A)},
                     {"number/" + third, take(Take::B)}};
  const MergeReport open = merged(*project_, b_, settled);
  EXPECT_FALSE(open.entered);
  EXPECT_THAT(openIn(open), testing::ElementsAre("number/" + x_));
  settled["number/" + x_] = take(Take::A);
  const MergeReport done = merged(*project_, b_, settled);
  EXPECT_TRUE(done.entered);
  EXPECT_EQ(saidOf(*project_, third, "number"), kFirst);
  EXPECT_EQ(saidOf(*project_, y_, "number"), "N3");
  EXPECT_EQ(saidOf(*project_, x_, "number"), "ARM1-T3-0013-0003");
  EXPECT_THAT(done.new_numbers,
              testing::ElementsAre(testing::Pair(x_, testing::Pair(kFirst, "ARM1-T3-0013-0003"))));
}

class MergedMeasurements : public Conflicts {
 protected:
  std::string weightIn(upkeep::Project& project) {
    return saidOf(project, idOf(rows[0]), "weight_g");
  }
  /// How many values of it a project keeps, and how many of them count.
  std::pair<int, int> keptIn(upkeep::Project& project) {
    store::Statement row = project.catalogue().database().sql(
        "SELECT count(*), sum(m.current) FROM measurement m JOIN sherd s ON s.row = m.sherd "
        "WHERE "
        "s.id = ? AND m.kind = 'weight'",
        idOf(rows[0]));
    std::pair<int, int> counts;
    EXPECT_TRUE(row.read(counts.first, counts.second));
    return counts;
  }
};

TEST_F(MergedMeasurements, OfOneProjectReplaceTheValueThatNobodyElseChangedAndKeepIt) {
  EXPECT_EQ(weightIn(*project_), "23.4");
  say(b_, rows[0], "weight_g", "24.1");
  EXPECT_THAT(merged(*project_, b_).conflicts, testing::IsEmpty());
  EXPECT_EQ(weightIn(*project_), "24.1");
  EXPECT_EQ(keptIn(*project_), std::pair(2, 1));
  EXPECT_THAT(merged(b_, *project_).conflicts, testing::IsEmpty());
  EXPECT_EQ(weightIn(b_), "24.1");
}

TEST_F(MergedMeasurements, ThatBothTookAlikeNeedNoPerson) {
  say(*project_, rows[0], "weight_g", "24.1");
  say(b_, rows[0], "weight_g", "24.1");
  EXPECT_THAT(merged(*project_, b_).conflicts, testing::IsEmpty());
  EXPECT_EQ(weightIn(*project_), "24.1");
  EXPECT_EQ(keptIn(*project_).second, 1);
}

TEST_F(MergedMeasurements, ThatAPersonChoseCountAloneAndTheOthersAreKept) {
  say(*project_, rows[0], "weight_g", "24.1");
  say(b_, rows[0], "weight_g", "25.9");
  settle({{"sherd/" + idOf(rows[0]) + "/weight", take(Take::A)}});
  EXPECT_EQ(weightIn(*project_), "24.1");
  EXPECT_EQ(keptIn(*project_), std::pair(3, 1)) << "23.4 of before, 24.1 and 25.9";
}

TEST_F(MergedMeasurements, ThatOneProjectTookAwayStayAway) {
  say(b_, rows[0], "weight_g", "");
  ASSERT_EQ(weightIn(b_), "");
  EXPECT_THAT(merged(*project_, b_).conflicts, testing::IsEmpty());
  EXPECT_EQ(weightIn(*project_), "");
}

}  // namespace
}  // namespace ostraka::merge
