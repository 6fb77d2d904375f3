// What a person sees of a conflict.
#include <gmock/gmock.h>

#include "two_houses.h"

namespace ostraka::merge {
namespace {

using Versions = TwoCopies;

TEST_F(Versions, AreToldByNumberFieldAndWhoEnteredWhat) {
  say(*project_, rows[0], "ware", "grey");
  say(b_, rows[0], "ware", "red");
  say(*project_, rows[0], "weight_g", "24");
  say(b_, rows[0], "weight_g", "25");
  const MergeReport report = merged(*project_, b_);
  ASSERT_EQ(report.conflicts.size(), 2u);
  const Conflict &ware = report.conflicts[0], &weight = report.conflicts[1];
  EXPECT_EQ(ware.table, "sherd");
  EXPECT_EQ(ware.name, "ARM1-T3-0012-0001");
  EXPECT_EQ(ware.field, "ware");
  EXPECT_THAT(ware.a.values, testing::ElementsAre(testing::Pair("ware", "grey")));
  EXPECT_THAT(ware.b.values, testing::ElementsAre(testing::Pair("ware", "red")));
  EXPECT_EQ(ware.a.by, "AP");
  EXPECT_GT(ware.b.at_ms, ware.a.at_ms);
  EXPECT_THAT(ware.takes, testing::ElementsAre(Take::A, Take::B));
  EXPECT_EQ(weight.field, "weight");
  EXPECT_EQ(weight.a.values.front().first, "weight");
  EXPECT_EQ(weight.b.by, "AP");
}

TEST_F(Versions, OfANumberGivenToTwoSherdsSayWhatTellsThemApart) {
  const store::SherdRow own = newSherd(*project_, context13, true);
  const store::SherdRow theirs = newSherd(b_, context13, true);
  say(*project_, own, "ware", "grey");
  say(b_, theirs, "ware", "red");
  const MergeReport report = merged(*project_, b_);
  ASSERT_EQ(report.conflicts.size(), 1u);
  const Conflict& number = report.conflicts.front();
  EXPECT_EQ(number.name, "ARM1-T3-0013-0001");
  EXPECT_THAT(number.a.values, testing::ElementsAre(testing::Pair("context", "ARM1-T3-0013"),
                                                    testing::Pair("ware", "grey")));
  EXPECT_THAT(number.b.values, testing::Contains(testing::Pair("ware", "red")));
  EXPECT_TRUE(number.offers(Take::One));
}

}  // namespace
}  // namespace ostraka::merge
