#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "files/log_file.h"

namespace ostraka::stages {

/// Passes everything on and keeps the warnings.
class WarningsKept final : public Progress {
 public:
  explicit WarningsKept(Progress& outer) : outer_(outer) {}
  void begin(std::string_view stage, double share) override { outer_.begin(stage, share); }
  void report(std::int64_t done, std::int64_t total) override { outer_.report(done, total); }
  void note(NoteLevel level, const Message& text) override {
    if (level == NoteLevel::Warning) warnings.emplace_back(text);
    outer_.note(level, text);
  }
  std::vector<Message> warnings;

 private:
  Progress& outer_;
};

/// Passes everything on and keeps OUT/log.txt, where the warnings come first that were given
/// before.
class LoggedProgress final : public Progress {
 public:
  LoggedProgress(Progress& outer, const std::filesystem::path& file,
                 const std::vector<Message>& before)
      : outer_(outer), log_(file) {
    for (const Message& warning : before) log_.line("warning: " + warning.english());
  }
  void begin(std::string_view stage, double share) override {
    log_.line("stage " + std::string(stage));
    outer_.begin(stage, share);
  }
  void report(std::int64_t done, std::int64_t total) override { outer_.report(done, total); }
  void note(NoteLevel level, const Message& text) override {
    log_.line((level == NoteLevel::Warning ? "warning: " : "") + text.english());
    outer_.note(level, text);
  }

 private:
  Progress& outer_;
  LogFile log_;
};

}  // namespace ostraka::stages
