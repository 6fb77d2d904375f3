#pragma once
#include <cstdio>
#include <functional>
#include <string>

#include "base/pace.h"
#include "base/progress.h"

namespace ostraka::app {

enum class Loudness { Quiet, Warnings, Everything };

/// Progress for a person: on a terminal one line that is drawn anew, with the time left; into a
/// pipe plain lines, one per stage and one every ten seconds.
class TerminalProgress final : public Progress {
 public:
  using Clock = Pace::Clock;

  /// now: the clock, handed in for tests.
  TerminalProgress(std::FILE* out, bool terminal, Loudness loudness,
                   std::function<Clock::time_point()> now = Clock::now);
  ~TerminalProgress() override;

  void begin(std::string_view stage, double share) override;
  void report(std::int64_t done, std::int64_t total) override;
  void note(NoteLevel level, const Message& text) override;
  /// Ends the line that is drawn anew, before other output.
  void finish();

 private:
  void draw(bool whole_line);
  void clearLine();
  std::string line() const;

  std::FILE* out_;
  bool terminal_;
  Loudness loudness_;
  std::function<Clock::time_point()> now_;
  std::string stage_;
  Pace pace_;
  Clock::time_point last_drawn_;
  bool line_open_ = false;
};

/// "about 40 s", "about 3 min", "about 2 h 10 min".
std::string durationWords(double seconds);

}  // namespace ostraka::app
