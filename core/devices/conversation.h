#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "devices/byte_channel.h"
#include "devices/clock.h"

namespace ostraka::devices {

/// Text back and forth over a channel that cuts it anywhere.
class Conversation {
 public:
  /// end: what ends a message, '\n' or ';'; dropped: bytes without a meaning, as heartbeats.
  Conversation(std::unique_ptr<ByteChannel> channel, std::shared_ptr<Clock> clock, char end,
               std::string dropped = {})
      : channel_(std::move(channel)),
        clock_(std::move(clock)),
        end_(end),
        dropped_(std::move(dropped)) {}

  Result<void> send(std::string_view bytes) { return channel_->write(bytes); }
  /// The next message without its end and without spaces around; nothing after timeout_s.
  Result<std::optional<std::string>> next(double timeout_s, std::stop_token stop);
  /// What has come already, without waiting.
  Result<std::optional<std::string>> waiting() { return next(0, {}); }

  ByteChannel& channel() { return *channel_; }
  Clock& clock() { return *clock_; }
  void forget() {
    rest_.clear();
    messages_.clear();
  }

 private:
  void take(std::string_view bytes);

  std::unique_ptr<ByteChannel> channel_;
  std::shared_ptr<Clock> clock_;
  char end_;
  std::string dropped_;
  std::string rest_;
  std::deque<std::string> messages_;
};

}  // namespace ostraka::devices
