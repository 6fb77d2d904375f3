// Photographs that change while a batch is processed, as when a card is copied anew meanwhile.
#include "pipeline/chain.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

#include "files/files.h"
#include "pipeline/process_batch.h"
#include "small_batch.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// At the beginning of a stage does something, once, and hears what is reused.
class AtStage final : public Progress {
 public:
  AtStage(std::string stage, std::function<void()> act)
      : stage_(std::move(stage)), act_(std::move(act)) {}
  void begin(std::string_view stage, double) override {
    if (stage == stage_) act_();
  }
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { notes.emplace_back(text.english()); }
  std::vector<std::string> notes;

 private:
  std::string stage_;
  std::function<void()> act_;
};

TEST_F(ProcessBatch, LeavesNoRecordOfAStageDuringWhichPhotographsChanged) {
  ProcessOptions options;
  options.batch = folder_ / "swapped";
  options.output = folder_ / "swapped_out";
  fs::copy(folder_ / "batch", options.batch, fs::copy_options::recursive);
  std::vector<fs::path> fronts;
  for (const fs::directory_entry& entry : fs::directory_iterator(options.batch / "front"))
    fronts.push_back(entry.path());
  std::sort(fronts.begin(), fronts.end());
  const std::string first = *readFile(fronts[0]), second = *readFile(fronts[1]);

  AtStage swapping("masks of the front side", [&] {
    ASSERT_TRUE(writeFileAtomically(fronts[0], second).has_value());
    ASSERT_TRUE(writeFileAtomically(fronts[1], first).has_value());
  });
  const Result<ProcessSummary> changed = processBatch(options, swapping, {});
  ASSERT_FALSE(changed.has_value());
  EXPECT_EQ(changed.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(changed.error().where, fronts[0].string());
  EXPECT_FALSE(fs::exists(options.output / "work/masks_front/stage.json"));
  EXPECT_FALSE(fs::exists(options.output / "report.json"));

  ASSERT_TRUE(writeFileAtomically(fronts[0], first).has_value());
  ASSERT_TRUE(writeFileAtomically(fronts[1], second).has_value());
  std::stop_source stop;
  AtStage stopping("stereo of the front side", [&] { stop.request_stop(); });
  ASSERT_FALSE(processBatch(options, stopping, stop.get_token()).has_value());
  EXPECT_THAT(stopping.notes, Contains(HasSubstr("rig: reused from an earlier run")));
  EXPECT_THAT(stopping.notes, Not(Contains(HasSubstr("masks_front: reused"))));
  EXPECT_TRUE(fs::exists(options.output / "work/masks_front/stage.json"));
}

}  // namespace
}  // namespace ostraka::pipeline
