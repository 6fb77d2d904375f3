#pragma once
#include <chrono>
#include <optional>

namespace ostraka {

/// Fraction done and time left of work in stages with expected shares; work without stages counts
/// as one stage.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  void begin(double share, Clock::time_point now);
  void report(double done, Clock::time_point now);  ///< 0..1 of the present stage
  /// A pause does not count as work.
  void skip(Clock::duration idle);

  double fraction() const;
  /// By the time that this run took so far; empty before a fifth of it is done, a guess until then.
  /// A stage that is slower or faster than its share says counts little by little, so that the
  /// figure neither jumps nor swings.
  std::optional<double> secondsLeft(Clock::time_point now) const;

 private:
  std::optional<double> estimate(Clock::time_point now) const;  ///< seconds left, unsmoothed
  void follow(Clock::time_point now);

  bool in_stage_ = false;
  double stage_share_ = 1, share_before_ = 0, stage_done_ = 0;
  // Stages reused from an earlier run take no time; the pace comes from the others.
  double worked_share_ = 0, worked_seconds_ = 0;
  std::optional<Clock::time_point> stage_begin_;  // empty before the first word of the work
  std::optional<Clock::time_point> end_;          // expected; empty while it is a guess
  Clock::time_point followed_{};                  // when end_ was last brought up to date
};

}  // namespace ostraka
