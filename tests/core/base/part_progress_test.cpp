#include "base/part_progress.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace ostraka {
namespace {

class Written final : public Progress {
 public:
  void report(std::int64_t done, std::int64_t total) override { reports.push_back({done, total}); }
  void note(NoteLevel, const Message& text) override { notes.emplace_back(text.english()); }
  std::vector<std::pair<std::int64_t, std::int64_t>> reports;
  std::vector<std::string> notes;
};

TEST(PartProgress, GoesOnWhereThePartBeforeEnded) {
  Written all;
  PartProgress first(all, 0, 2), second(all, 1, 2);
  first.report(1, 4);
  first.report(4, 4);
  second.report(0, 10);
  second.report(10, 10);
  second.note(NoteLevel::Info, "one");
  const std::vector<std::pair<std::int64_t, std::int64_t>> expected = {
      {1, 8}, {4, 8}, {10, 20}, {20, 20}};
  EXPECT_EQ(all.reports, expected);
  EXPECT_EQ(all.notes, std::vector<std::string>{"one"});
}

}  // namespace
}  // namespace ostraka
