#include "devices/conversation.h"

#include <gtest/gtest.h>

#include "base/message.h"
#include "tests/core/capture/simulated_clock.h"

namespace ostraka::devices {
namespace {

/// Gives its pieces one at a read, at once; then nothing comes any more.
class PiecesChannel final : public ByteChannel {
 public:
  PiecesChannel(std::deque<std::string> pieces, std::shared_ptr<Clock> clock)
      : pieces_(std::move(pieces)), clock_(std::move(clock)) {}
  std::string name() const override { return "pieces"; }
  Result<void> write(std::string_view) override { return {}; }
  Result<std::string> read(double timeout_s, std::stop_token stop) override {
    if (babbles) {
      clock_->sleep(std::min(timeout_s, 0.01), stop);
      return std::string("x");
    }
    if (broken) return Error::missing(message("The line is gone."));
    if (pieces_.empty()) {
      clock_->sleep(timeout_s, stop);
      return std::string();
    }
    std::string piece = pieces_.front();
    pieces_.pop_front();
    return piece;
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}
  bool babbles = false, broken = false;

 private:
  std::deque<std::string> pieces_;
  std::shared_ptr<Clock> clock_;
};

struct Line {
  Line(char end, std::deque<std::string> pieces, const std::string& dropped = {})
      : talk(std::make_unique<PiecesChannel>(std::move(pieces), clock), clock, end, dropped) {}
  PiecesChannel& channel() { return static_cast<PiecesChannel&>(talk.channel()); }
  /// "-" where none came in a second.
  std::string next() { return talk.next(1, {}).value().value_or("-"); }

  std::shared_ptr<capture::testing::SimulatedClock> clock =
      std::make_shared<capture::testing::SimulatedClock>();
  Conversation talk;
};

TEST(Conversation, PutsTogetherWhatTheChannelCutAnywhere) {
  Line line('\n', {"o", "k\r\n<Id", "le>\r\n", "\r\nALARM:1\n"});
  EXPECT_EQ(line.next(), "ok");
  EXPECT_EQ(line.next(), "<Idle>");
  EXPECT_EQ(line.next(), "ALARM:1") << "an empty line is no message";
  EXPECT_EQ(line.clock->now_s(), 0) << "nothing of this has to be waited for";
  EXPECT_EQ(line.next(), "-");
  EXPECT_EQ(line.clock->now_s(), 1);
}

TEST(Conversation, EndsMessagesAsTheControllerDoesAndLeavesItsHeartbeatsOut) {
  Line line(';', {"+CR", "+,T", "B=90;+", "+OK\r\n;"}, "+");
  EXPECT_EQ(line.next(), "CR,TB=90");
  EXPECT_EQ(line.next(), "OK");
}

// The rest of an answer that comes late belongs to its beginning.
TEST(Conversation, KeepsTheBeginningOfAMessageForTheNextCall) {
  Line line('\n', {"", "[VER", ":1.1h]\n"});
  EXPECT_FALSE(line.talk.waiting().value().has_value());
  EXPECT_EQ(line.next(), "[VER:1.1h]");
}

TEST(Conversation, ForgetsWhatCameAndWhatBegan) {
  Line line('\n', {"one\ntwo\nthr", "ee\n"});
  EXPECT_EQ(line.next(), "one");
  line.talk.forget();
  EXPECT_EQ(line.next(), "ee");
}

TEST(Conversation, TakesNoMoreThan512BytesOfNoise) {
  Line line('\n', {std::string(600, 'x') + "\nok\n"});
  EXPECT_EQ(line.next(), std::string(512, 'x'));
  EXPECT_EQ(line.next(), "ok");
}

TEST(Conversation, LeavesALineThatBabblesWithoutAnEnd) {
  Line line('\n', {});
  line.channel().babbles = true;
  EXPECT_EQ(line.next(), "-");
  EXPECT_GE(line.clock->now_s(), 1);
  EXPECT_LT(line.clock->now_s(), 2);
}

TEST(Conversation, EndsAtARequestToStopAndTellsWhyTheLineIsGone) {
  Line line('\n', {"", "ok\n"});
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(line.talk.next(60, stop.get_token()).value().has_value());
  EXPECT_EQ(line.next(), "ok");
  line.channel().broken = true;
  EXPECT_EQ(line.talk.next(1, {}).error().code, ErrorCode::Missing);
}

}  // namespace
}  // namespace ostraka::devices
