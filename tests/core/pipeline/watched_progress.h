#pragma once
#include <gtest/gtest.h>

#include <stop_token>
#include <string>
#include <utility>

#include "base/progress.h"

namespace ostraka::pipeline {

/// Asks to stop as soon as a stage of this name begins.
class StopsAt final : public Progress {
 public:
  StopsAt(std::string stage, std::stop_source& stop) : stage_(std::move(stage)), stop_(stop) {}
  void begin(std::string_view stage, double) override {
    if (stage == stage_) stop_.request_stop();
  }
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message&) override {}

 private:
  std::string stage_;
  std::stop_source& stop_;
};

/// What a bar shows of a job never goes back within a stage.
class NeverBack final : public Progress {
 public:
  void begin(std::string_view stage, double share) override {
    stage_ = stage, fraction_ = 0;
    shares += share;
  }
  void report(std::int64_t done, std::int64_t total) override {
    const double fraction = static_cast<double>(done) / static_cast<double>(total);
    EXPECT_GE(fraction, fraction_) << stage_;
    EXPECT_LE(fraction, 1) << stage_;
    fraction_ = fraction;
  }
  void note(NoteLevel, const Message&) override {}
  double shares = 0;  ///< of all stages

 private:
  std::string stage_;
  double fraction_ = 0;
};

}  // namespace ostraka::pipeline
