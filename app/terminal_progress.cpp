#include "terminal_progress.h"

#include <algorithm>
#include <cmath>

#include "shown.h"

namespace ostraka::app {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::chrono::seconds kPlainLine{10};

}  // namespace

std::string durationWords(double s) {
  if (s < 55) return "about " + std::to_string(std::max(1L, std::lround(s / 5) * 5)) + " s";
  const long minutes = std::lround(s / 60);
  if (minutes < 60) return "about " + std::to_string(std::max(1L, minutes)) + " min";
  return "about " + std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

TerminalProgress::TerminalProgress(std::FILE* out, bool terminal, Loudness loudness,
                                   std::function<Clock::time_point()> now)
    : out_(out),
      terminal_(terminal),
      loudness_(loudness),
      now_(std::move(now)),
      last_drawn_(now_()) {}

TerminalProgress::~TerminalProgress() {
  finish();
}

void TerminalProgress::begin(std::string_view stage, double share) {
  stage_ = stage;
  pace_.begin(share, now_());
  draw(true);
}

void TerminalProgress::report(std::int64_t done, std::int64_t total) {
  if (total <= 0) return;
  pace_.report(static_cast<double>(done) / static_cast<double>(total), now_());
  draw(false);
}

void TerminalProgress::note(NoteLevel level, const Message& text) {
  const bool warning = level == NoteLevel::Warning;
  if (loudness_ == Loudness::Quiet || (!warning && loudness_ != Loudness::Everything)) return;
  clearLine();
  show(out_, "%s%s\n", warning ? "Warning: " : "", text.english().c_str());
  if (terminal_) draw(true);
}

std::string TerminalProgress::line() const {
  std::string text =
      std::to_string(std::lround(std::floor(100 * pace_.fraction()))) + " %  " + stage_;
  if (const std::optional<double> left = pace_.secondsLeft(now_()))
    text += (stage_.empty() ? "" : ", ") + durationWords(*left) + " left";
  return text;
}

void TerminalProgress::draw(bool whole_line) {
  if (loudness_ == Loudness::Quiet) return;
  const Clock::time_point now = now_();
  if (terminal_) {
    if (!whole_line && now - last_drawn_ < kRedraw) return;
    std::fprintf(out_, "\r\033[K%s", line().c_str());
    line_open_ = true;
  } else {
    if (!whole_line && now - last_drawn_ < kPlainLine) return;
    std::fprintf(out_, "%s\n", line().c_str());
  }
  std::fflush(out_);
  last_drawn_ = now;
}

void TerminalProgress::clearLine() {
  if (line_open_) std::fputs("\r\033[K", out_);
  line_open_ = false;
}

void TerminalProgress::finish() {
  clearLine();
  std::fflush(out_);
}

}  // namespace ostraka::app
