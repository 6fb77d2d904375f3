#include "decisions/pair_sides.h"

#include <gtest/gtest.h>

#include <set>

namespace ostraka::decisions {
namespace {

using pairing::Doubt;

TEST(ReasonOf, EachDoubtHasItsOwnSentenceAndASurePairHasNone) {
  SherdPair pair;
  EXPECT_EQ(reasonOf(pair), "");
  EXPECT_FALSE(pair.decision.ambiguous());
  std::set<std::string> reasons;
  for (const Doubt doubt : {Doubt::OtherPartner, Doubt::Unrelated, Doubt::OtherPose, Doubt::NotSure,
                            Doubt::Displaced, Doubt::SharedBack}) {
    pair.decision.doubt = doubt;
    EXPECT_TRUE(pair.decision.ambiguous());
    EXPECT_TRUE(reasonOf(pair).ends_with('.'));
    reasons.insert(reasonOf(pair));
  }
  EXPECT_EQ(reasons.size(), 6u);
}

TEST(ReasonOf, AFailedSelfCheckSpeaksForItself) {
  SherdPair pair;
  pair.registration.reason = "The faces cross: 12 % of the front lies behind the back.";
  EXPECT_EQ(reasonOf(pair), "") << "a pair that nobody doubts";
  pair.decision.doubt = Doubt::SelfCheck;
  EXPECT_EQ(reasonOf(pair), pair.registration.reason);
}

}  // namespace
}  // namespace ostraka::decisions
