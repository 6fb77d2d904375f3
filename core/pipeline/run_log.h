#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"

namespace ostraka::pipeline {

/// Passes everything on and keeps the warnings.
class WarningsKept final : public Progress {
 public:
  explicit WarningsKept(Progress& outer) : outer_(outer) {}
  void begin(std::string_view stage, double share) override { outer_.begin(stage, share); }
  void report(std::int64_t done, std::int64_t total) override { outer_.report(done, total); }
  void note(NoteLevel level, std::string_view text) override {
    if (level == NoteLevel::Warning) warnings.emplace_back(text);
    outer_.note(level, text);
  }
  std::vector<std::string> warnings;

 private:
  Progress& outer_;
};

/// Passes everything on and keeps OUT/log.txt, where the warnings come first that were given
/// before.
class LoggedProgress final : public Progress {
 public:
  LoggedProgress(Progress& outer, const std::filesystem::path& file,
                 const std::vector<std::string>& before)
      : outer_(outer), log_(file, std::ios::app) {
    for (const std::string& warning : before) log_ << "warning: " << warning << std::endl;
  }
  void begin(std::string_view stage, double share) override {
    log_ << "stage " << stage << std::endl;
    outer_.begin(stage, share);
  }
  void report(std::int64_t done, std::int64_t total) override { outer_.report(done, total); }
  void note(NoteLevel level, std::string_view text) override {
    log_ << (level == NoteLevel::Warning ? "warning: " : "") << text << std::endl;
    outer_.note(level, text);
  }

 private:
  Progress& outer_;
  std::ofstream log_;
};

}  // namespace ostraka::pipeline
