#include "devices/conversation.h"

namespace ostraka::devices {
namespace {

constexpr std::size_t kLongestMessage = 512;  // longer ones are noise on the line

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0';
}

std::string trimmed(const std::string& text) {
  std::size_t first = 0, last = text.size();
  while (first < last && isSpace(text[first])) ++first;
  while (last > first && isSpace(text[last - 1])) --last;
  return text.substr(first, last - first);
}

}  // namespace

void Conversation::take(std::string_view bytes) {
  for (const char c : bytes) {
    if (c == end_) {
      const std::string message = trimmed(rest_);
      rest_.clear();
      if (!message.empty()) messages_.push_back(message);
    } else if (dropped_.find(c) == std::string::npos && rest_.size() < kLongestMessage) {
      rest_ += c;
    }
  }
}

Result<std::optional<std::string>> Conversation::next(double timeout_s, std::stop_token stop) {
  const double deadline_s = clock_->now_s() + timeout_s;
  for (int rounds = 0; messages_.empty(); ++rounds) {
    const double left_s = deadline_s - clock_->now_s();
    const Result<std::string> bytes = channel_->read(left_s > 0 ? left_s : 0, stop);
    if (!bytes) return bytes.error();
    take(*bytes);
    if (!messages_.empty()) break;
    // A line that babbles without an end is left as well.
    const bool over = left_s <= 0 || clock_->now_s() >= deadline_s - 1e-6;
    if (stop.stop_requested() || (over && (bytes->empty() || rounds > 64)))
      return std::optional<std::string>();
  }
  std::optional<std::string> message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

}  // namespace ostraka::devices
