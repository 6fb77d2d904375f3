#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/progress.h"

namespace ostraka {

/// One of several equal parts of a stage, so that the progress bar does not restart with each.
class PartProgress final : public Progress {
 public:
  PartProgress(Progress& outer, std::size_t part, std::size_t parts)
      : outer_(outer),
        part_(static_cast<std::int64_t>(part)),
        parts_(static_cast<std::int64_t>(parts)) {}
  void report(std::int64_t done, std::int64_t total) override {
    outer_.report(part_ * total + done, parts_ * total);
  }
  void note(NoteLevel level, const Message& text) override { outer_.note(level, text); }

 private:
  Progress& outer_;
  std::int64_t part_, parts_;
};

}  // namespace ostraka
