// What both projects did since they were one.
#include <gmock/gmock.h>

#include <tuple>

#include "merge/told.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using Events = TwoCopies;

TEST_F(Events, WhatWasChangedBackHoldsAgainstWhatWasNeverChanged) {
  say(*project_, rows[0], "ware", "grey");
  merged(b_, *project_);
  say(b_, rows[0], "ware", "");
  EXPECT_THAT(merged(*project_, b_).conflicts, testing::IsEmpty());
  EXPECT_EQ(valueOf(rows[0], "ware"), "");
}

TEST_F(Events, TellWhoChangedWhatInB) {
  say(b_, rows[0], "note", "a handle");
  merged(*project_, b_);
  const auto history = catalogue::valueIn(catalogue::History(catalogue()).of(rows[0]));
  EXPECT_EQ(history.front().field, "note");
  EXPECT_EQ(history.front().new_value, "a handle");
  EXPECT_EQ(history.front().by, anna.person);
  EXPECT_EQ(history.front().source, "test");
}

// So that a repair can tell them; later merges ask what persons said, as before.
TEST_F(Events, TellPairsThatAMergeJoinedOrParted) {
  say(b_, rows[1], "joins", "ARM1-T3-0012-0003");
  merged(*project_, b_);
  for (const auto& [sherd, before, after] :
       {std::tuple(rows[0], "ARM1-T3-0012-0002", ""), {rows[2], "", "ARM1-T3-0012-0002"}}) {
    const auto history = catalogue::valueIn(catalogue::History(catalogue()).of(sherd));
    EXPECT_EQ(history.front().field, "joins");
    EXPECT_EQ(history.front().old_value, before);
    EXPECT_EQ(history.front().new_value, after);
    EXPECT_EQ(history.front().source, "merge");
  }
  say(b_, rows[1], "joins", "");
  merged(*project_, b_);
  EXPECT_EQ(valueOf(rows[1], "joins"), "") << "the merge did not say that they join";
}

TEST(TellMembers, TellsWhatLeftAndWhatCameButNotWhatStayed) {
  Event event;
  event.old_value = "rim; neck; base";
  event.new_value = "body; neck";
  std::vector<std::pair<std::string, bool>> told;
  tellMembers(event,
              [&](const std::string& member, bool added) { told.emplace_back(member, added); });
  using testing::Pair;
  EXPECT_THAT(told,
              testing::ElementsAre(Pair("rim", false), Pair("base", false), Pair("body", true)));
  std::swap(event.old_value, event.new_value);
  event.old_value.clear();
  told.clear();
  tellMembers(event, [&](const std::string& member, bool) { told.emplace_back(member, true); });
  EXPECT_EQ(told.size(), 3u);
}

// One took it away; the other said nothing of it, or took it away too.
TEST(IsGone, OnlyWhereOneTookItAwayAndTheOtherDidNotAddIt) {
  const std::pair<std::string, std::string> joined("a", "b");
  EXPECT_TRUE(isGone({{joined, false}}, {}, joined));
  EXPECT_TRUE(isGone({{joined, false}}, {{joined, false}}, joined));
  EXPECT_FALSE(isGone({{joined, false}}, {{joined, true}}, joined));
  EXPECT_FALSE(isGone({{joined, true}}, {}, joined));
  EXPECT_FALSE(isGone({}, {{joined, false}}, joined)) << "asked the other way round";
}

}  // namespace
}  // namespace ostraka::merge
