#include "turntables/grbl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/capture/flat_rig.h"
#include "tests/core/capture/simulated_controllers.h"

namespace ostraka::turntables {
namespace {

using capture::testing::Mischief;
using capture::testing::PseudoTerminal;
using capture::testing::SimulatedChannel;
using capture::testing::SimulatedClock;
using capture::testing::SimulatedGrbl;
using ::testing::HasSubstr;

class Grbl : public ::testing::Test {
 protected:
  void open(const Mischief& mischief = {}, const GrblOptions& options = {}) {
    device_ = std::make_shared<SimulatedGrbl>(clock_, mischief);
    auto table = openGrbl(std::make_unique<SimulatedChannel>(device_, clock_), options, clock_, {});
    ASSERT_TRUE(table.has_value()) << table.error().what;
    table_ = std::move(*table);
  }

  std::shared_ptr<SimulatedClock> clock_ = std::make_shared<SimulatedClock>();
  std::shared_ptr<SimulatedGrbl> device_;
  std::unique_ptr<devices::Turntable> table_;
};

TEST_F(Grbl, DoesNotTurnBeforeItsPositionIsKnown) {
  open();
  EXPECT_FALSE(table_->position_deg().has_value());
  const auto moved = table_->moveTo(45, {});
  EXPECT_EQ(moved.error().code, ErrorCode::NotEnough);
  EXPECT_EQ(device_->degrees(), 0);
}

TEST_F(Grbl, HomesAndTurnsToAbsoluteAnglesPastAWholeTurn) {
  open();
  device_->switch_deg = -30;
  ASSERT_TRUE(table_->home({}).has_value());
  EXPECT_EQ(table_->position_deg(), 0);
  for (const double angle : {45.0, 90.0, 360.0, 405.0, 400.0}) {
    ASSERT_TRUE(table_->moveTo(angle, {}).has_value());
    EXPECT_NEAR(device_->degrees(), angle - 30, 1e-3);  // commands carry three decimals
    EXPECT_EQ(table_->position_deg(), angle);
  }
}

TEST_F(Grbl, ReturnsOnlyWhenTheTableStandsStill) {
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  const double before_s = clock_->now_s();
  ASSERT_TRUE(table_->moveTo(90, {}).has_value());
  EXPECT_GE(clock_->now_s() - before_s, 90 / 20.0);  // degrees over degrees a second
  EXPECT_NEAR(device_->degrees(), 90, 1e-3);
}

TEST_F(Grbl, SaysThatThereIsNoSwitch) {
  device_ = std::make_shared<SimulatedGrbl>(clock_, Mischief{});
  device_->has_switch = false;
  auto table = openGrbl(std::make_unique<SimulatedChannel>(device_, clock_), {}, clock_, {});
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ((*table)->home({}).error().code, ErrorCode::Missing);
  ASSERT_TRUE((*table)->zeroHere({}).has_value());
  EXPECT_EQ((*table)->position_deg(), 0);
}

TEST_F(Grbl, NeverTurnsTwiceAfterALostReply) {
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  int lost = 2;
  device_->swallow = [&](const std::string& message) { return message == "ok\r\n" && lost-- > 0; };
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
  EXPECT_NEAR(device_->degrees(), 45, 1e-3);
  EXPECT_NEAR(device_->turned_in_all(), 45, 1e-3);
}

TEST_F(Grbl, SaysACommandAgainThatNeverArrived) {
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  device_->mischief().deaf = 1;
  clock_->sleep(1, {});
  int heard = 0;
  device_->swallow = [&](const std::string&) {
    if (++heard == 5) device_->mischief().deaf = 0;
    return false;
  };
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
  EXPECT_NEAR(device_->turned_in_all(), 45, 1e-3);
}

TEST_F(Grbl, KnowsNoPositionAfterARestartInMidMove) {
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  device_->mischief().restart = 1;
  const auto moved = table_->moveTo(45, {});
  ASSERT_FALSE(moved.has_value());
  EXPECT_EQ(moved.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(moved.error().what, HasSubstr("restarted"));
  EXPECT_FALSE(table_->position_deg().has_value());
  device_->mischief().restart = 0;
  ASSERT_TRUE(table_->home({}).has_value());
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
}

TEST_F(Grbl, ComesBackAfterTheCableWasPulled) {
  open();
  ASSERT_TRUE(table_->home({}).has_value());
  device_->mischief().unplug = 1;
  EXPECT_EQ(table_->moveTo(45, {}).error().code, ErrorCode::Missing);
  EXPECT_FALSE(table_->position_deg().has_value());
  device_->mischief().unplug = 0;
  ASSERT_TRUE(table_->reopen({}).has_value());
  ASSERT_TRUE(table_->home({}).has_value());
  ASSERT_TRUE(table_->moveTo(90, {}).has_value());
  EXPECT_NEAR(device_->degrees(), 90, 1e-3);
}

TEST_F(Grbl, GivesUpOnASilentTableInWords) {
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  device_->mischief().lost = 1;
  const auto moved = table_->moveTo(45, {});
  ASSERT_FALSE(moved.has_value());
  EXPECT_EQ(moved.error().code, ErrorCode::Missing);
  EXPECT_FALSE(table_->position_deg().has_value());
}

// Asks to stop when the table has turned for a while.
class StoppingClock final : public devices::Clock {
 public:
  double now_s() override { return inner->now_s(); }
  bool sleep(double seconds, std::stop_token stop) override {
    inner->sleep(seconds, stop);
    if (inner->now_s() > stop_at_s) source.request_stop();
    return !stop.stop_requested();
  }
  std::shared_ptr<SimulatedClock> inner = std::make_shared<SimulatedClock>();
  std::stop_source source;
  double stop_at_s = 1e9;
};

TEST_F(Grbl, StopsInMidMoveAndStillKnowsWhereItStands) {
  const auto clock = std::make_shared<StoppingClock>();
  device_ = std::make_shared<SimulatedGrbl>(clock, Mischief{});
  auto table = openGrbl(std::make_unique<SimulatedChannel>(device_, clock), {}, clock, {});
  ASSERT_TRUE(table.has_value());
  ASSERT_TRUE((*table)->zeroHere({}).has_value());
  clock->stop_at_s = clock->now_s() + 2;
  EXPECT_EQ((*table)->moveTo(180, clock->source.get_token()).error().code, ErrorCode::Cancelled);
  const double stood = device_->degrees();
  EXPECT_GT(stood, 20);
  EXPECT_LT(stood, 80);
  ASSERT_TRUE((*table)->position_deg().has_value());
  EXPECT_NEAR(*(*table)->position_deg(), stood, 0.01);
  ASSERT_TRUE((*table)->moveTo(180, {}).has_value());
  EXPECT_NEAR(device_->degrees(), 180, 0.01);
}

TEST_F(Grbl, FiresTheShuttersAndAlwaysSwitchesTheOutputOff) {
  open({}, {.speed_deg_s = 20, .shutter = "M62 P0", .clockwise = false});
  EXPECT_TRUE(table_->firesShutters());
  ASSERT_TRUE(table_->fireShutters({}).has_value());
  const auto& lines = device_->lines;
  ASSERT_GE(lines.size(), 3u);
  EXPECT_EQ(lines[lines.size() - 3], "M62 P0");
  EXPECT_EQ(lines.back(), "M63 P0");
}

TEST_F(Grbl, CountsClockwiseAxesTheOtherWay) {
  open({}, {.speed_deg_s = 20, .shutter = {}, .clockwise = true});
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
  EXPECT_NEAR(device_->degrees(), -45, 1e-3);
}

TEST_F(Grbl, RefusesWhatIsNoGrbl) {
  device_ = std::make_shared<SimulatedGrbl>(clock_, Mischief{.deaf = 1});
  device_->restarts_when_opened = false;
  device_->swallow = [](const std::string&) { return true; };
  const auto table = openGrbl(std::make_unique<SimulatedChannel>(device_, clock_), {}, clock_, {});
  ASSERT_FALSE(table.has_value());
  EXPECT_THAT(table.error().what, HasSubstr("does not answer like a GRBL"));
}

// Whatever goes wrong on the line: the table says so, or stands where it was told to.
TEST_F(Grbl, StandsWhereItSaysOrSaysThatItDoesNotKnow) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    device_ = std::make_shared<SimulatedGrbl>(clock_, Mischief{.lost = 0.1,
                                                               .late = 0.1,
                                                               .doubled = 0.1,
                                                               .garbled = 0.1,
                                                               .deaf = 0.05,
                                                               .restart = 0.01,
                                                               .unplug = 0.01,
                                                               .seed = seed});
    auto table = openGrbl(std::make_unique<SimulatedChannel>(device_, clock_), {}, clock_, {});
    if (!table) continue;  // it did not answer, and said so
    table_ = std::move(*table);
    double target = 0;
    for (int k = 0; k < 20; ++k) {
      if (!table_->position_deg() && !table_->home({})) {
        (void)table_->reopen({});
        continue;
      }
      target = 45 * (k % 9);
      const auto moved = table_->moveTo(target, {});
      if (moved) {
        EXPECT_NEAR(device_->degrees(), target, 0.02) << "seed " << seed << ", move " << k;
        EXPECT_EQ(table_->position_deg(), target);
      } else if (moved.error().code == ErrorCode::Missing) {
        (void)table_->reopen({});
      }
    }
  }
}

TEST(GrblOnAPseudoTerminal, TurnsInRealTime) {
  const auto device = std::make_shared<SimulatedGrbl>(devices::steadyClock(), Mischief{});
  const PseudoTerminal terminal(device);
  auto channel = devices::openSerial(terminal.path(), 115200);
  ASSERT_TRUE(channel.has_value()) << channel.error().what;
  auto table = openGrbl(std::move(*channel), {.speed_deg_s = 2000}, devices::steadyClock(), {});
  ASSERT_TRUE(table.has_value()) << table.error().what;
  ASSERT_TRUE((*table)->zeroHere({}).has_value());
  ASSERT_TRUE((*table)->moveTo(45, {}).has_value());
  EXPECT_NEAR(device->degrees(), 45, 1e-3);
}

TEST(SerialChannel, IsForOneProgramOnly) {
  const auto device = std::make_shared<SimulatedGrbl>(devices::steadyClock(), Mischief{});
  const PseudoTerminal terminal(device);
  const auto first = devices::openSerial(terminal.path(), 115200);
  ASSERT_TRUE(first.has_value());
  const auto second = devices::openSerial(terminal.path(), 115200);
  ASSERT_FALSE(second.has_value());
  EXPECT_THAT(second.error().what, HasSubstr("Another program"));
  EXPECT_EQ(devices::openSerial("/dev/no-such-port", 115200).error().code, ErrorCode::Missing);
  EXPECT_EQ(devices::openSerial(terminal.path(), 123).error().code, ErrorCode::UnusableInput);
}

TEST(SerialChannel, NoticesThatTheOtherEndIsGone) {
  auto terminal = std::make_unique<PseudoTerminal>(
      std::make_shared<SimulatedGrbl>(devices::steadyClock(), Mischief{}));
  const auto channel = devices::openSerial(terminal->path(), 115200);
  ASSERT_TRUE(channel.has_value());
  terminal.reset();
  Result<std::string> read = std::string();
  for (int k = 0; k < 20 && read; ++k) read = (*channel)->read(0.05, {});
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, ErrorCode::Missing);
}

}  // namespace
}  // namespace ostraka::turntables
