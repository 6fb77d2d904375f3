#include "base/pace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ostraka {
namespace {

constexpr double kInstant_s = 0.5;  // a stage this short was found whole from an earlier run
// Of what this run has to do: the shares of the first stages alone tell little of the others.
constexpr double kLeastShare = 0.2, kLeast_s = 3;
// A new estimate counts by so many seconds, and by this part of the time left.
constexpr double kSettle_s = 5, kSettleOfLeft = 0.25;
constexpr double kLeastOfEstimate = 0.5;  // where nothing was reported for long

double seconds(Pace::Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

Pace::Clock::duration ticks(double seconds) {
  return std::chrono::duration_cast<Pace::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

void Pace::begin(double share, Clock::time_point now) {
  if (in_stage_) {
    const double spent = seconds(now - *stage_begin_);
    if (spent > kInstant_s) {
      worked_share_ += stage_share_;
      worked_seconds_ += spent;
    }
    share_before_ += stage_share_;
  }
  in_stage_ = true;
  stage_share_ = share;
  stage_done_ = 0;
  stage_begin_ = now;
  follow(now);
}

void Pace::report(double done, Clock::time_point now) {
  if (!stage_begin_) stage_begin_ = now;
  stage_done_ = std::clamp(done, 0.0, 1.0);
  follow(now);
}

void Pace::skip(Clock::duration idle) {
  if (stage_begin_) *stage_begin_ += idle;
  if (end_) *end_ += idle;
  followed_ += idle;
}

double Pace::fraction() const {
  return std::clamp(share_before_ + stage_share_ * stage_done_, 0.0, 1.0);
}

std::optional<double> Pace::secondsLeft(Clock::time_point now) const {
  const std::optional<double> left = estimate(now);
  if (!left || !end_) return left;
  return std::max(seconds(*end_ - now), kLeastOfEstimate * *left);
}

void Pace::follow(Clock::time_point now) {
  const std::optional<double> left = estimate(now);
  if (!left) return;
  const double since = seconds(now - std::exchange(followed_, now));
  if (!end_) {
    end_ = now + ticks(*left);
    return;
  }
  const double counts = 1 - std::exp(-since / (kSettle_s + kSettleOfLeft * *left));
  *end_ += ticks(counts * (*left - seconds(*end_ - now)));
}

std::optional<double> Pace::estimate(Clock::time_point now) const {
  if (!stage_begin_) return {};
  const double share = worked_share_ + stage_share_ * stage_done_;
  const double spent = seconds(now - *stage_begin_), work = worked_seconds_ + spent;
  const double rest = std::max(0.0, 1 - share_before_ - stage_share_ * stage_done_);
  if (work < kLeast_s || share <= 0 || share < kLeastShare * (share + rest) - 1e-9) return {};
  const double by_all = rest * work / share;
  if (stage_done_ <= 0) return by_all;
  // The further the stage is, the more its own pace says about the rest of it.
  const double stage_rest = stage_share_ * (1 - stage_done_) * work / share;
  const double by_itself = spent * (1 - stage_done_) / stage_done_;
  return by_all + stage_done_ * (by_itself - stage_rest);
}

}  // namespace ostraka
