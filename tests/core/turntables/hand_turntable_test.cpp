#include "turntables/hand_turntable.h"

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace ostraka::turntables {
namespace {

class HandTurntable : public ::testing::Test {
 protected:
  std::vector<std::string> asked_;
  bool obliges_ = true;
  std::unique_ptr<devices::Turntable> table_ =
      openHandTurntable([this](const Message& sentence, std::stop_token) {
        asked_.push_back(sentence.english());
        return obliges_;
      });
};

// A marked circle ends at 359.
TEST_F(HandTurntable, AsksForTheMarkThatStandsOnTheTable) {
  for (const auto& [degrees, mark] :
       {std::pair(45.0, "45"), std::pair(405.0, "45"), std::pair(360.0, "0"),
        std::pair(-90.0, "270"), std::pair(359.7, "0"), std::pair(719.999999, "0")}) {
    asked_.clear();
    ASSERT_TRUE(table_->moveTo(degrees, {}));
    EXPECT_THAT(asked_,
                testing::ElementsAre(testing::HasSubstr(" to " + std::string(mark) + " degrees,")))
        << degrees;
    EXPECT_EQ(table_->position_deg(), degrees);
  }
}

TEST_F(HandTurntable, AsksNobodyToTurnItWhereItStands) {
  EXPECT_FALSE(table_->turnsItself());
  ASSERT_TRUE(table_->zeroHere({}));
  EXPECT_EQ(table_->position_deg(), 0);
  ASSERT_TRUE(table_->moveTo(0, {}));
  EXPECT_TRUE(asked_.empty());
  ASSERT_TRUE(table_->moveTo(360, {})) << "a whole turn on";
  EXPECT_EQ(asked_.size(), 1u);
}

// Half turned: nobody knows how far.
TEST_F(HandTurntable, StandsAnywhereOnceAPersonGaveUp) {
  ASSERT_TRUE(table_->home({}));
  obliges_ = false;
  EXPECT_EQ(table_->moveTo(90, {}).error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(table_->position_deg());
  obliges_ = true;
  ASSERT_TRUE(table_->moveTo(0, {}));
  EXPECT_EQ(asked_.size(), 3u) << "where it stood before says nothing";
  EXPECT_EQ(table_->position_deg(), 0);
}

TEST_F(HandTurntable, WithoutAPersonIsNotTurned) {
  const auto alone = openHandTurntable({});
  EXPECT_EQ(alone->home({}).error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(alone->position_deg());
}

}  // namespace
}  // namespace ostraka::turntables
