#pragma once
#include <cstdint>
#include <string_view>

#include "base/message.h"

namespace ostraka {

enum class NoteLevel { Info, Warning };

/// How a stage reports while it works. Only the stage's own thread calls it.
class Progress {
 public:
  virtual ~Progress() = default;
  /// A new stage of a longer job begins; share is its part of the whole job's time, 0..1, as
  /// expected. Stages never call this themselves, only the caller that runs several of them.
  virtual void begin(std::string_view /*stage*/, double /*share*/) {}
  virtual void report(std::int64_t done, std::int64_t total) = 0;
  /// One line for the log: stage, ids, metric with unit. A warning asks a person to act.
  virtual void note(NoteLevel level, const Message& text) = 0;
};

/// Discards everything; for tests and inner calls.
class QuietProgress final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message&) override {}
};

}  // namespace ostraka
