#include "turntables/comxim.h"

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
using capture::testing::SimulatedComXim;
using ::testing::HasSubstr;

ComXimOptions optionsOf(int dialect) {
  ComXimOptions options;
  options.dialect = dialect == 1 ? ComXimDialect::Brackets : ComXimDialect::Commas;
  options.speed_deg_s = 50;
  return options;
}

class ComXim : public ::testing::TestWithParam<int> {
 protected:
  void make(const Mischief& mischief = {}) {
    device_ = std::make_shared<SimulatedComXim>(clock_, mischief, GetParam());
  }
  void open() {
    auto table = openComXim(std::make_unique<SimulatedChannel>(device_, clock_),
                            optionsOf(GetParam()), clock_, {});
    ASSERT_TRUE(table.has_value()) << table.error().what;
    table_ = std::move(*table);
  }

  std::shared_ptr<SimulatedClock> clock_ = std::make_shared<SimulatedClock>();
  std::shared_ptr<SimulatedComXim> device_;
  std::unique_ptr<devices::Turntable> table_;
};
INSTANTIATE_TEST_SUITE_P(Dialect, ComXim, ::testing::Values(1, 2));

TEST_P(ComXim, TurnsToAbsoluteAnglesThoughTheTableKnowsOnlyRelativeOnes) {
  make();
  open();
  EXPECT_EQ(table_->moveTo(10, {}).error().code, ErrorCode::NotEnough);
  ASSERT_TRUE(table_->home({}).has_value());
  for (const double angle : {45.0, 90.0, 360.0, 405.0, 400.0, 400.0}) {
    ASSERT_TRUE(table_->moveTo(angle, {}).has_value());
    EXPECT_NEAR(device_->degrees(), angle, 0.02);
  }
  EXPECT_NEAR(device_->turned_in_all(), 410, 0.05) << "the same angle twice turns nothing";
}

TEST_P(ComXim, TakesBothSpellings) {
  make();
  device_->new_spelling = true;
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
  EXPECT_NEAR(device_->degrees(), 45, 0.02);
}

TEST_P(ComXim, NeverTurnsTwiceWhenTheReplyOrTheArrivalIsLost) {
  for (const std::string lost : {"OK", "TB_END", "TURNANGLE"}) {
    make();
    open();
    ASSERT_TRUE(table_->zeroHere({}).has_value());
    bool once = true;
    device_->swallow = [&](const std::string& message) {
      return message.find(lost) != std::string::npos &&
             message.find("Angle") == std::string::npos && std::exchange(once, false);
    };
    ASSERT_TRUE(table_->moveTo(45, {}).has_value()) << lost;
    EXPECT_NEAR(device_->turned_in_all(), 45, 0.02) << lost;
  }
}

TEST_P(ComXim, LosesItsPositionWhenAReplyIsLostAndItCannotTellWhereItStands) {
  make();
  device_->tells_offset = false;
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
  bool once = true;
  device_->swallow = [&](const std::string& message) {
    return message.find("OK") != std::string::npos && std::exchange(once, false);
  };
  const auto moved = table_->moveTo(90, {});
  ASSERT_FALSE(moved.has_value());
  EXPECT_EQ(moved.error().code, ErrorCode::NotEnough);
  EXPECT_FALSE(table_->position_deg().has_value());
  EXPECT_NEAR(device_->turned_in_all(), 90, 0.02);
  device_->swallow = nullptr;
  ASSERT_TRUE(table_->home({}).has_value());
  EXPECT_NEAR(std::remainder(device_->degrees(), 360), 0, 0.02);
}

TEST_P(ComXim, RecoversWhenACommandNeverArrived) {
  make();
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  device_->mischief().deaf = 1;
  EXPECT_FALSE(table_->moveTo(45, {}).has_value());
  EXPECT_FALSE(table_->position_deg().has_value());
  EXPECT_EQ(device_->degrees(), 0);
  device_->mischief().deaf = 0;
  ASSERT_TRUE(table_->home({}).has_value());
  ASSERT_TRUE(table_->moveTo(45, {}).has_value());
  EXPECT_NEAR(device_->turned_in_all(), 45, 0.02);
}

TEST_P(ComXim, StandsWhereItSaysOrSaysThatItDoesNotKnow) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    make({.lost = 0.08,
          .late = 0.08,
          .doubled = 0.08,
          .garbled = 0.08,
          .deaf = 0.05,
          .unplug = 0.01,
          .seed = seed});
    auto table = openComXim(std::make_unique<SimulatedChannel>(device_, clock_),
                            optionsOf(GetParam()), clock_, {});
    if (!table) continue;  // all greetings were lost: said in words
    for (int k = 0; k < 15; ++k) {
      if (!(*table)->position_deg() && !(*table)->home({})) {
        (void)(*table)->reopen({});
        continue;
      }
      const double target = 45 * (k % 9);
      const auto moved = (*table)->moveTo(target, {});
      if (moved) {
        EXPECT_NEAR(std::remainder(device_->degrees() - target, 360), 0, 0.4)
            << "seed " << seed << ", move " << k;
      } else if (moved.error().code == ErrorCode::Missing) {
        (void)(*table)->reopen({});
      }
    }
  }
}

TEST_P(ComXim, RefusesWhatDoesNotAnswer) {
  make({.deaf = 1});
  const auto table = openComXim(std::make_unique<SimulatedChannel>(device_, clock_),
                                optionsOf(GetParam()), clock_, {});
  ASSERT_FALSE(table.has_value());
  EXPECT_THAT(table.error().what, HasSubstr("does not answer like a ComXim"));
}

TEST_P(ComXim, StopsTheTableOnRequest) {
  make();
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(table_->moveTo(180, stop.get_token()).error().code, ErrorCode::Cancelled);
  EXPECT_LT(device_->degrees(), 180);
}

TEST_P(ComXim, IsHomedAgainAfterItWasStopped) {
  make();
  open();
  ASSERT_TRUE(table_->home({}).has_value());
  table_->stopNow();
  EXPECT_TRUE(table_->home({}).has_value());
}

TEST_P(ComXim, WorksOverAPseudoTerminal) {
  const auto device =
      std::make_shared<SimulatedComXim>(devices::steadyClock(), Mischief{}, GetParam());
  device->speed_deg_s = 2000;
  const PseudoTerminal terminal(device);
  auto channel = devices::openSerial(terminal.path(), 115200);
  ASSERT_TRUE(channel.has_value());
  auto table = openComXim(std::move(*channel), optionsOf(GetParam()), devices::steadyClock(), {});
  ASSERT_TRUE(table.has_value()) << table.error().what;
  ASSERT_TRUE((*table)->zeroHere({}).has_value());
  ASSERT_TRUE((*table)->moveTo(45, {}).has_value());
  EXPECT_NEAR(device->degrees(), 45, 0.02);
}

TEST(ParseComXimReply, TellsTheMessagesApart) {
  using Kind = ComXimReply::Kind;
  const auto one = [](const char* m) { return parseComXimReply(m, ComXimDialect::Brackets); };
  const auto two = [](const char* m) { return parseComXimReply(m, ComXimDialect::Commas); };
  EXPECT_EQ(one("CR+OK").kind, Kind::Accepted);
  EXPECT_EQ(one("CR+EVENT=TB_END").kind, Kind::Arrived);
  EXPECT_EQ(one("CR+EVENT=TB_PAUSE").kind, Kind::Paused);
  EXPECT_EQ(one("CR+ERR=71").error, 71);
  EXPECT_DOUBLE_EQ(one("CR+OffsetAngle=-12.5").angle_deg, -12.5);
  EXPECT_EQ(one("CR+OffsetAngle=1e999").kind, Kind::Other);
  EXPECT_EQ(one("CR+OKK").kind, Kind::Other);
  EXPECT_EQ(two("+OK").kind, Kind::Accepted);
  EXPECT_EQ(two("+OK,TURNANGLE=45.0").kind, Kind::Arrived);
  EXPECT_EQ(two("+FAIL,ERR=007").error, 7);
  EXPECT_DOUBLE_EQ(two("+DATA=30").angle_deg, 30);
  EXPECT_EQ(two("+DATA=V3.28").kind, Kind::Other);
}

}  // namespace
}  // namespace ostraka::turntables
