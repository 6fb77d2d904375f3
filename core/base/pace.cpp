#include "base/pace.h"

#include <algorithm>

namespace ostraka {
namespace {

constexpr double kInstant_s = 0.5;  // a stage this short was found whole from an earlier run
// Of what this run has to do: the shares of the first stages alone tell little of the others.
constexpr double kLeastShare = 0.2, kLeast_s = 3;

double seconds(Pace::Clock::duration d) {
  return std::chrono::duration<double>(d).count();
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
}

void Pace::report(double done, Clock::time_point now) {
  if (!stage_begin_) stage_begin_ = now;
  stage_done_ = std::clamp(done, 0.0, 1.0);
}

void Pace::skip(Clock::duration idle) {
  if (stage_begin_) *stage_begin_ += idle;
}

double Pace::fraction() const {
  return std::clamp(share_before_ + stage_share_ * stage_done_, 0.0, 1.0);
}

std::optional<double> Pace::secondsLeft(Clock::time_point now) const {
  if (!stage_begin_) return {};
  const double share = worked_share_ + stage_share_ * stage_done_;
  const double work = worked_seconds_ + seconds(now - *stage_begin_);
  const double rest = std::max(0.0, 1 - share_before_ - stage_share_ * stage_done_);
  if (work < kLeast_s || share <= 0 || share < kLeastShare * (share + rest) - 1e-9) return {};
  return rest * work / share;
}

}  // namespace ostraka
