#pragma once
#include <cstdint>
#include <string_view>

#include "base/message.h"

namespace ostraka {

enum class NoteLevel { Info, Warning };

/// How a stage speaks while it works. Calls come from the stage's own thread only.
class Progress {
 public:
  virtual ~Progress() = default;
  /// A new stage of a longer job begins; share is its part of the whole job's time, 0..1, as
  /// expected. Stages themselves never call this, only who runs several of them.
  virtual void begin(std::string_view /*stage*/, double /*share*/) {}
  virtual void report(std::int64_t done, std::int64_t total) = 0;
  /// One line for the log: stage, ids, figure with unit. A warning asks a person to act.
  virtual void note(NoteLevel level, const Message& text) = 0;
};

/// Says nothing; for tests and inner calls.
class QuietProgress final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message&) override {}
};

}  // namespace ostraka
