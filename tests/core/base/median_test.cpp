#include "base/median.h"

#include <gmock/gmock.h>

namespace ostraka {
namespace {

TEST(Median, IsTheValueInTheMiddleWhateverTheOrder) {
  EXPECT_EQ(medianOf(std::vector<int>{9, 1, 5}), 5);
  EXPECT_EQ(medianOf(std::vector<int>{5, 9, 1}), 5);
}

TEST(Median, OfAnEvenNumberIsTheUpperOfTheTwoInTheMiddle) {
  EXPECT_EQ(medianOf(std::vector<double>{4, 1, 3, 2}), 3);
}

TEST(Median, OfNothingIsZero) {
  EXPECT_EQ(medianOf(std::vector<float>{}), 0);
}

TEST(Median, KeepsTheValuesThatItPutsInAnotherOrder) {
  std::vector<int> values{7, 3, 3, 8, 1};
  EXPECT_EQ(medianOf(values), 3);
  EXPECT_THAT(values, ::testing::UnorderedElementsAre(7, 3, 3, 8, 1));
}

TEST(Ranked, IsTheLowerValueAtTheShareOfTheOrder) {
  EXPECT_EQ(rankedAt(std::vector<double>{4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(rankedAt(std::vector<float>{5, 9, 1, 7, 3}, 0.75), 7);
  EXPECT_EQ(rankedAt(std::vector<float>{}, 0.5), 0);
}

TEST(Quantile, LiesBetweenTheTwoValuesAroundTheRank) {
  EXPECT_DOUBLE_EQ(quantileOf({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantileOf({10, 0}, 0.95), 9.5);
  EXPECT_DOUBLE_EQ(quantileOf({7}, 0.9), 7);
}

}  // namespace
}  // namespace ostraka
