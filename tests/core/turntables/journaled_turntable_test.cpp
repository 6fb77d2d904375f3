#include "turntables/journaled_turntable.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "tests/core/capture/flat_rig.h"

namespace ostraka::turntables {
namespace {

namespace fs = std::filesystem;
using capture::testing::FlatTruth;
using capture::testing::FlatTurntable;

class JournaledTurntable : public ::testing::Test {
 protected:
  ~JournaledTurntable() override { fs::remove(file_); }

  // A program that starts; the controller restarted with it and has no switch.
  void start(bool still_counts = false) {
    auto table = std::make_unique<FlatTurntable>(truth_);
    inner_ = table.get();
    inner_->has_switch = false;
    if (!still_counts) inner_->forgetPosition();
    table_ = rememberPosition(std::move(table), file_);
  }

  fs::path file_ =
      fs::temp_directory_path() / ("ostraka_journal_" + std::to_string(::getpid()) + ".json");
  std::shared_ptr<FlatTruth> truth_ = std::make_shared<FlatTruth>();
  FlatTurntable* inner_ = nullptr;
  std::unique_ptr<devices::Turntable> table_;
};

TEST_F(JournaledTurntable, KnowsItsPlaceAfterTheProgramWasKilledAtRest) {
  start();
  EXPECT_FALSE(table_->position_deg().has_value()) << "nothing was ever written down";
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->moveTo(135, {}).has_value());
  start();
  EXPECT_EQ(table_->position_deg(), 135);
  ASSERT_TRUE(table_->moveTo(180, {}).has_value());
  EXPECT_DOUBLE_EQ(truth_->degrees, 180);
  start();
  EXPECT_EQ(table_->position_deg(), 180);
}

TEST_F(JournaledTurntable, DoesNotKnowItAfterAMoveThatBrokeOff) {
  start(true);
  ASSERT_TRUE(table_->moveTo(90, {}).has_value());
  inner_->faults = {FlatTurntable::Fault::Restarted};
  EXPECT_FALSE(table_->moveTo(180, {}).has_value());
  EXPECT_FALSE(table_->position_deg().has_value());
  ASSERT_TRUE(table_->reopen({}).has_value());
  EXPECT_FALSE(table_->position_deg().has_value());
  start();
  EXPECT_FALSE(table_->position_deg().has_value());
}

TEST_F(JournaledTurntable, BelievesAControllerThatStillCounts) {
  std::ofstream(file_) << R"({"format":"ostraka-turntable/1","stands_at_deg":77})";
  start(true);
  EXPECT_EQ(table_->position_deg(), 0);
}

TEST_F(JournaledTurntable, IsNotMisledByABrokenJournal) {
  for (const char* text : {"", "[1]", R"({"format":3})", R"({"stands_at_deg":77})",
                           R"({"format":"ostraka-turntable/1","stands_at_deg":"x"})"}) {
    std::ofstream(file_) << text;
    start();
    EXPECT_FALSE(table_->position_deg().has_value()) << text;
  }
}

}  // namespace
}  // namespace ostraka::turntables
