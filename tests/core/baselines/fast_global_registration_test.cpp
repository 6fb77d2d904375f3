#include "baselines/fast_global_registration.h"

#include <gtest/gtest.h>

#include "fracture_pair.h"

namespace ostraka::baselines {
namespace {

// Features of noisy points 0.6 mm apart fix a pose to a few spacings: 1.1 mm is the worst of the
// clean sets, whose outlines have more corners than this one.
TEST(FastGlobalRegistration, FindsTheKnownPoseFromNothing) {
  const FracturePair pair;
  const auto found = fastGlobalRegistration(pair.front, pair.back, {}, {});
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(pair.error_mm(*found), 1.5);
}

TEST(FastGlobalRegistration, TheSameInputGivesTheSamePose) {
  const FracturePair pair;
  const auto one = fastGlobalRegistration(pair.front, pair.back, {}, {});
  const auto other = fastGlobalRegistration(pair.front, pair.back, {}, {});
  ASSERT_TRUE(one.has_value() && other.has_value());
  EXPECT_TRUE(one->matrix() == other->matrix());
}

TEST(FastGlobalRegistration, SaysSoWhereTooFewFeaturesAgree) {
  const FracturePair pair;
  const auto few = fastGlobalRegistration(firstPoints(pair.front, 15), pair.back, {}, {});
  ASSERT_FALSE(few.has_value());
  EXPECT_EQ(few.error().code, ErrorCode::NotEnough);
  FastGlobalOptions strict;
  strict.fewest_pairs = 100000;
  const auto none = fastGlobalRegistration(pair.front, pair.back, strict, {});
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::Failed);
}

TEST(FastGlobalRegistration, StopsOnRequest) {
  const FracturePair pair;
  std::stop_source stop;
  stop.request_stop();
  const auto found = fastGlobalRegistration(pair.front, pair.back, {}, stop.get_token());
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::baselines
