#include "terminal_progress.h"

#include <algorithm>
#include <cmath>

#include "shown.h"

namespace ostraka::app {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::chrono::seconds kPlainLine{10};
constexpr double kInstant_s = 0.5;  // a stage this short was found whole from an earlier run

double seconds(TerminalProgress::Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

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
      stage_begin_(now_()),
      last_drawn_(stage_begin_) {}

TerminalProgress::~TerminalProgress() {
  finish();
}

void TerminalProgress::endStage() {
  const double spent = seconds(now_() - stage_begin_);
  if (!stage_.empty() && spent > kInstant_s) {
    worked_share_ += stage_share_;
    worked_seconds_ += spent;
  }
  if (!stage_.empty()) share_before_ += stage_share_;
}

void TerminalProgress::begin(std::string_view stage, double share) {
  endStage();
  stage_ = stage;
  stage_share_ = share;
  stage_done_ = 0;
  stage_begin_ = now_();
  draw(true);
}

void TerminalProgress::report(std::int64_t done, std::int64_t total) {
  if (total <= 0) return;
  stage_done_ = std::clamp(static_cast<double>(done) / static_cast<double>(total), 0.0, 1.0);
  draw(false);
}

void TerminalProgress::note(NoteLevel level, std::string_view text) {
  const bool warning = level == NoteLevel::Warning;
  if (loudness_ == Loudness::Quiet || (!warning && loudness_ != Loudness::Everything)) return;
  clearLine();
  show(out_, "%s%.*s\n", warning ? "Warning: " : "", static_cast<int>(text.size()), text.data());
  if (terminal_) draw(true);
}

std::optional<double> TerminalProgress::secondsLeft() const {
  const double spent = seconds(now_() - stage_begin_);
  const double share = worked_share_ + stage_share_ * stage_done_;
  const double work = worked_seconds_ + spent;
  // Below three seconds or two hundredths the pace is a guess.
  if (work < 3 || share < 0.02) return {};
  const double left = 1 - share_before_ - stage_share_ * stage_done_;
  return std::max(0.0, left) * work / share;
}

std::string TerminalProgress::line() const {
  const double done = std::clamp(share_before_ + stage_share_ * stage_done_, 0.0, 1.0);
  std::string text = std::to_string(std::lround(std::floor(100 * done))) + " %  " + stage_;
  if (const std::optional<double> left = secondsLeft())
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
