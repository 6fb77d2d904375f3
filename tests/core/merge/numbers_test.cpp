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
      tried(*project_, b_, {{"number/" + theirs, {Take::Number, "ARM1-T3-0012-0001"}}});
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().what, testing::HasSubstr("never reused"));
  settle({{"number/" + theirs, {Take::Number, "ARM1-T3-0013-0101"}}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0101");
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
        tried(*project_, b_, {{"number/" + theirs, {Take::Number, number}}});
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
