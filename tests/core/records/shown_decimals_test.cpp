#include "records/shown_decimals.h"

#include <gtest/gtest.h>

namespace ostraka::records {
namespace {

TEST(DecimalsShown, OfATypedNumberAreThoseThatWereTyped) {
  EXPECT_EQ(decimalsShown(6.25, {}, 1), 2);
  EXPECT_EQ(decimalsShown(6.25, 0.4, 1), 2);
  EXPECT_EQ(decimalsShown(0.125, {}, 1), 3);
  EXPECT_EQ(decimalsShown(120, {}, 1), 0);
  EXPECT_EQ(decimalsShown(1205.4, {}, 1), 1);
}

TEST(DecimalsShown, OfAComputedNumberAreThoseThatItsUncertaintyBears) {
  const double computed = 53.929898797564384;
  EXPECT_EQ(decimalsShown(computed, 0.4, 2), 1);    // 53.9 +- 0.4
  EXPECT_EQ(decimalsShown(computed, 0.12, 2), 2);   // 53.93 +- 0.12
  EXPECT_EQ(decimalsShown(computed, 0.012, 2), 3);  // 53.930 +- 0.012
  EXPECT_EQ(decimalsShown(computed, 30.0, 2), 0);
  EXPECT_EQ(decimalsShown(computed, {}, 2), 2);
  EXPECT_EQ(decimalsShown(10 * computed, {}, 2), 2);
  EXPECT_EQ(decimalsShown(100 * computed, {}, 2), 0);
}

}  // namespace
}  // namespace ostraka::records
