#include "rendering/hand_held.h"

#include <gmock/gmock.h>

#include <limits>

namespace ostraka::rendering {
namespace {

std::string wrongIn(const HandHeldOptions& options) {
  const Result<void> checked = options.check();
  return checked ? "" : checked.error().what.english();
}

TEST(HandHeldOptions, NameTheFieldThatCannotBe) {
  EXPECT_EQ(wrongIn({}), "");
  EXPECT_EQ(wrongIn({.photographs = 3, .bend_mm = 20, .clutter = 4}), "");
  EXPECT_EQ(wrongIn({.photographs = 400, .bend_mm = 0, .clutter = 0}), "");
  for (const int photographs : {-1, 2, 401})
    EXPECT_THAT(wrongIn({.photographs = photographs}), testing::HasSubstr("hand_held"));
  for (const double bend_mm : {-0.1, 20.1, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(wrongIn({.bend_mm = bend_mm}), testing::HasSubstr("bend"));
  for (const int clutter : {-1, 5})
    EXPECT_THAT(wrongIn({.clutter = clutter}), testing::HasSubstr("clutter"));
}

}  // namespace
}  // namespace ostraka::rendering
