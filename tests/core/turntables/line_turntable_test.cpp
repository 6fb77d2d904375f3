#include "turntables/line_turntable.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/capture/flat_rig.h"

namespace ostraka::turntables {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// A line on which all lies that a controller said before anybody listened.
class SpokenLine final : public devices::ByteChannel {
 public:
  explicit SpokenLine(std::string said) : said_(std::move(said)) {}
  std::string name() const override { return "the line"; }
  Result<void> write(std::string_view) override { return {}; }
  Result<std::string> read(double, std::stop_token) override {
    return std::exchange(said_, babbles ? said_ : std::string());
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}
  bool babbles = false;

 private:
  std::string said_;
};

class BareTable final : public LineTurntable {
 public:
  explicit BareTable(std::unique_ptr<devices::ByteChannel> channel, double speed_deg_s = 20)
      : LineTurntable(
            devices::Conversation(std::move(channel),
                                  std::make_shared<capture::testing::SimulatedClock>(), '\n'),
            speed_deg_s, false) {}
  std::string name() const override { return "bare"; }
  Result<void> home(std::stop_token) override { return {}; }
  Result<void> zeroHere(std::stop_token) override { return {}; }
  Result<void> moveTo(double, std::stop_token) override { return {}; }
  Result<void> connect(std::stop_token) override {
    ++connected;
    const auto heard = line_.waiting();
    if (heard && *heard) overheard.push_back(**heard);
    return {};
  }
  void overhear(const std::string& line) override { overheard.push_back(line); }
  using LineTurntable::beginMove, LineTurntable::drain, LineTurntable::halt_,
      LineTurntable::patience_s, LineTurntable::setPosition;

  int connected = 0;
  std::vector<std::string> overheard;
};

BareTable tableThatSaid(const std::string& said) {
  return BareTable(std::make_unique<SpokenLine>(said));
}

TEST(LineTurntable, IsNotOpenedWithoutASpeed) {
  for (const double speed : {0.0, -20.0, kNoNumber}) {
    const auto opened = LineTurntable::open(
        std::make_unique<BareTable>(std::make_unique<SpokenLine>(""), speed), {});
    ASSERT_FALSE(opened) << speed;
    EXPECT_EQ(opened.error().code, ErrorCode::UnusableInput);
  }
  EXPECT_TRUE(
      LineTurntable::open(std::make_unique<BareTable>(std::make_unique<SpokenLine>("")), {}));
}

TEST(LineTurntable, MovesOnlyFromWhereItIsKnownToStand) {
  BareTable table = tableThatSaid("");
  EXPECT_FALSE(table.position_deg());
  const Result<double> unknown = table.beginMove(45);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::NotEnough);
  EXPECT_EQ(unknown.error().where, "the line");
  table.setPosition(10);
  EXPECT_EQ(*table.beginMove(45), 10);
  for (const double angle : {kNoNumber, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(table.beginMove(angle).error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(table.position_deg(), 10) << "a move that did not begin leaves it";
}

// Else the next move would end at once.
TEST(LineTurntable, ForgetsWithTheNextMoveThatItWasStopped) {
  BareTable table = tableThatSaid("");
  table.setPosition(0);
  table.stopNow();
  EXPECT_TRUE(table.halt_);
  ASSERT_TRUE(table.beginMove(45));
  EXPECT_FALSE(table.halt_);
}

TEST(LineTurntable, WaitsLongerThanATurnTakesEitherWay) {
  const BareTable table = tableThatSaid("");
  EXPECT_GT(table.patience_s(0), 1) << "a controller answers after a while";
  EXPECT_GT(table.patience_s(360), 360 / 20.0);
  EXPECT_EQ(table.patience_s(-360), table.patience_s(360));
}

TEST(LineTurntable, OverhearsWhatWasSaidBeforeACommandButNotForEver) {
  BareTable table = tableThatSaid("restarted\r\n  old \n\nhalf");
  ASSERT_TRUE(table.drain());
  EXPECT_THAT(table.overheard, testing::ElementsAre("restarted", "old"));
  auto line = std::make_unique<SpokenLine>("ok\n");
  line->babbles = true;
  BareTable babbling(std::move(line));
  ASSERT_TRUE(babbling.drain());
  EXPECT_EQ(babbling.overheard.size(), 1000u);
}

// The cable may have been plugged into another table, or this one turned by hand.
TEST(LineTurntable, OpenedAgainKnowsNeitherItsPlaceNorWhatWasSaid) {
  BareTable table = tableThatSaid("first\nsecond\n");
  ASSERT_TRUE(table.connect({}));
  table.setPosition(90);
  ASSERT_TRUE(table.reopen({}));
  EXPECT_EQ(table.connected, 2);
  EXPECT_FALSE(table.position_deg());
  EXPECT_THAT(table.overheard, testing::ElementsAre("first"));
}

}  // namespace
}  // namespace ostraka::turntables
