#include "base/shared_progress.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace ostraka {
namespace {

class Reported final : public Progress {
 public:
  void report(std::int64_t done, std::int64_t total) override { all.emplace_back(done, total); }
  void note(NoteLevel, const Message&) override {}
  std::vector<std::pair<std::int64_t, std::int64_t>> all;
};

TEST(SharedProgress, IsReportedByItsOwnThreadWithWhatOthersHaveDone) {
  Reported reported;
  SharedProgress shared(reported, 10);
  shared.count(2);
  std::jthread([&] { shared.count(3); }).join();
  EXPECT_EQ(reported.all.size(), 1U);
  shared.count();
  const std::vector<std::pair<std::int64_t, std::int64_t>> expected = {{2, 10}, {6, 10}};
  EXPECT_EQ(reported.all, expected);
}

}  // namespace
}  // namespace ostraka
