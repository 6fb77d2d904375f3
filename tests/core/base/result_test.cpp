#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace ostraka {
namespace {

TEST(Result, HoldsEitherAValueOrAnError) {
  const Result<int> seven = 7;
  EXPECT_TRUE(seven.has_value());
  EXPECT_EQ(*seven, 7);
  const Result<int> wrong = Error{ErrorCode::NotEnough, "Too few.", "a.ply"};
  EXPECT_FALSE(wrong);
  EXPECT_EQ(wrong.error().sentence(), "a.ply: Too few.");
  EXPECT_EQ(Error::cancelled().sentence(), "Cancelled.");
}

TEST(Result, MovesItsValueOut) {
  Result<std::unique_ptr<int>> held = std::make_unique<int>(3);
  const std::unique_ptr<int> taken = std::move(held).value();
  EXPECT_EQ(*taken, 3);
}

TEST(ResultOfNothing, IsFineUnlessAnErrorSaysOtherwise) {
  EXPECT_TRUE(Result<void>().has_value());
  EXPECT_FALSE(Result<void>(Error::cancelled()).has_value());
}

}  // namespace
}  // namespace ostraka
