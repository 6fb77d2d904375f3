#include "turntables/text_turntable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/core/capture/flat_rig.h"
#include "tests/core/capture/simulated_controllers.h"

namespace ostraka::turntables {
namespace {

using capture::testing::Mischief;
using capture::testing::SimulatedChannel;
using capture::testing::SimulatedClock;
using capture::testing::SimulatedController;
using ::testing::HasSubstr;

// What a Marlin board says to the few words that a turntable needs.
class SimulatedMarlin final : public SimulatedController {
 public:
  using SimulatedController::SimulatedController;
  void opened() override {
    const std::lock_guard lock(guard_);
    if (restarts_when_opened) say("start\nMarlin 2.1.2\n", 0.05);
  }
  bool restarts_when_opened = true;
  std::vector<std::string> lines;

 private:
  void byte(char c) override {
    if (c != '\n') {
      rest_ += c;
      return;
    }
    const std::string text = rest_;
    rest_.clear();
    if (chance(mischief().deaf)) return;
    lines.push_back(text);
    if (text.starts_with("G0 X")) {
      const double target = std::atof(text.c_str() + 4);
      startMove(target - (place() - zero_deg_), std::atof(text.c_str() + text.find('F') + 1) / 60);
      say("ok\n");
    } else if (text == "M400") {
      const double wait_s = moving() ? moveEnds_s() - now_s() : 0;
      if (wait_s > 1) say("echo:busy: processing\n", 1);
      say("ok\n", wait_s);
    } else if (text == "M114") {
      say("X:" + std::to_string(place() - zero_deg_) + " Y:0.00 Z:0.00 E:0.00 Count X:0\nok\n");
    } else if (text == "G92 X0") {
      zero_deg_ = place();
      say("ok\n");
    } else if (text == "G28 X") {
      startMove(-place(), 100);
      say("ok\n", 1);
    } else {
      say(text == "G21" || text == "G90" || text == "M410" ? "ok\n" : "Error:Unknown command\n");
    }
  }
  std::string rest_;
  double zero_deg_ = 0;
};

class TextTurntable : public ::testing::Test {
 protected:
  void open(const Mischief& mischief = {}, const TextTableOptions& options = {}) {
    board_ = std::make_shared<SimulatedMarlin>(clock_, mischief);
    auto table =
        openTextTable(std::make_unique<SimulatedChannel>(board_, clock_), options, clock_, {});
    ASSERT_TRUE(table.has_value()) << table.error().what;
    table_ = std::move(*table);
  }
  std::shared_ptr<SimulatedClock> clock_ = std::make_shared<SimulatedClock>();
  std::shared_ptr<SimulatedMarlin> board_;
  std::unique_ptr<devices::Turntable> table_;
};

TEST_F(TextTurntable, TurnsAMarlinTableAndWaitsUntilItStands) {
  open();
  EXPECT_EQ(table_->moveTo(10, {}).error().code, ErrorCode::NotEnough);
  ASSERT_TRUE(table_->home({}).has_value());
  for (const double angle : {45.0, 90.0, 405.0, 405.0}) {
    ASSERT_TRUE(table_->moveTo(angle, {}).has_value());
    EXPECT_NEAR(board_->degrees(), angle, 1e-3);
  }
  EXPECT_EQ(table_->position_deg(), 405);
  EXPECT_NEAR(board_->turned_in_all(), 405, 0.01);
}

TEST_F(TextTurntable, IsHomedAndAlignedAgainAfterItWasStopped) {
  open();
  table_->stopNow();
  EXPECT_TRUE(table_->home({}).has_value());
  table_->stopNow();
  EXPECT_TRUE(table_->zeroHere({}).has_value());
}

TEST_F(TextTurntable, TurnsOnceThoughRepliesAreLostDoubledOrLate) {
  open({.lost = 0.1, .late = 0.1, .doubled = 0.1, .deaf = 0.1, .seed = 3});
  double target = 0;
  for (int k = 0; k < 200; ++k) {
    if (!table_->position_deg() && !table_->zeroHere({})) continue;
    const double zero = board_->degrees() - *table_->position_deg();
    target = *table_->position_deg() + 45;
    if (table_->moveTo(target, {})) {
      clock_->sleep(10, {});
      EXPECT_NEAR(board_->degrees() - zero, target, 1e-3) << k;
    }
  }
  EXPECT_GT(target, 0);
}

TEST_F(TextTurntable, KnowsThatARestartedBoardCountsFromAnew) {
  open();
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->reopen({}).has_value());
  EXPECT_FALSE(table_->position_deg().has_value());
  board_->restarts_when_opened = false;
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->moveTo(30, {}).has_value());
  ASSERT_TRUE(table_->reopen({}).has_value());
  EXPECT_NEAR(table_->position_deg().value_or(-1), 30, 1e-3) << "a cut line alone changes nothing";
}

TEST_F(TextTurntable, SpeaksTheWordsThatAFileGivesIt) {
  const auto dialect = dialectFromJson(nlohmann::json::parse(
      R"({"name":"Arduino","move":"G0 X{target} F{deg_min}","still":"M400","accepted":"^ok$"})"));
  ASSERT_TRUE(dialect.has_value()) << dialect.error().what;
  TextTableOptions options;
  options.dialect = *dialect;
  options.clockwise = true;
  open({}, options);
  ASSERT_TRUE(table_->zeroHere({}).has_value());
  ASSERT_TRUE(table_->moveTo(60, {}).has_value());
  EXPECT_NEAR(board_->degrees(), -60, 1e-3);
  EXPECT_EQ(table_->home({}).error().code, ErrorCode::Missing);
  EXPECT_THAT(table_->name(), HasSubstr("Arduino"));
}

TEST_F(TextTurntable, GivesTheBoardsOwnWordsWhenItRefuses) {
  TextTableOptions options;
  options.dialect.zero = "ZERO";
  open({}, options);
  const auto zeroed = table_->zeroHere({});
  ASSERT_FALSE(zeroed.has_value());
  EXPECT_THAT(zeroed.error().what, HasSubstr("Unknown command"));
}

TEST(TextDialect, RefusesWordsThatCannotWork) {
  const auto refused = [](const char* text) {
    const auto dialect = dialectFromJson(nlohmann::json::parse(text));
    return !dialect && dialect.error().code == ErrorCode::UnusableInput;
  };
  EXPECT_TRUE(refused(R"("klipper")"));
  EXPECT_TRUE(refused(R"({"accepted":"ok"})"));
  EXPECT_TRUE(refused(R"({"move":"TURN","accepted":"ok"})"));
  EXPECT_TRUE(refused(R"({"move":"T{by}","accepted":"(ok"})"));
  EXPECT_TRUE(refused(R"({"move":"T{by}","accepted":"ok","query":"?"})"));
  EXPECT_TRUE(refused(R"({"move":"T{by}","accepted":"ok","query":"?","position":"[0-9]+"})"));
  EXPECT_TRUE(refused(R"({"move":"T{by}","accepted":"ok","end":"ab"})"));
  EXPECT_TRUE(dialectFromJson("marlin").has_value());
}

}  // namespace
}  // namespace ostraka::turntables
