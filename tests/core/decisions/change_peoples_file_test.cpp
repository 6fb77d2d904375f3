#include "decisions/change_peoples_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>
#include <thread>

#include "decisions/decisions.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;

class PeoplesFile : public testing::Test {
 protected:
  // Each about a scan of its own, so that none replaces another.
  static bool appendMany(const fs::path& output, int first, int count) {
    for (int i = first; i < first + count; ++i) {
      PairDecision d;
      d.kind = DecisionKind::Aside;
      d.by = "AP";
      d.scans = {{batch::Side::Front, "f" + std::to_string(i), {50.0 * i, 0}}};
      if (!appendDecision(output, d)) return false;
    }
    return true;
  }
  TemporaryFolder temporary_;
  fs::path out_ = temporary_.path();
};

TEST_F(PeoplesFile, LosesNoneOfTheDecisionsOfTwoProgramsThatAppendAtOneTime) {
  constexpr int kEach = 200;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) ::_exit(appendMany(out_, kEach, kEach) ? 0 : 1);
  EXPECT_TRUE(appendMany(out_, 0, kEach));
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  std::set<std::string> scans;
  const Result<Decisions> all = readDecisions(out_);
  ASSERT_TRUE(all);
  for (const PairDecision& d : *all) scans.insert(d.scans.front().id);
  EXPECT_EQ(scans.size(), 2U * kEach);
  EXPECT_FALSE(fs::exists(out_ / kLockFile)) << "people look for their results there";
}

TEST_F(PeoplesFile, IsChangedByOneThreadAtATime) {
  constexpr int kEach = 20;
  const fs::path file = out_ / "decisions.json";
  ASSERT_TRUE(writeFileAtomically(file, "0"));
  const auto count = [&] {
    for (int i = 0; i < kEach; ++i)
      EXPECT_TRUE(changePeoplesFile(out_, [&] {
        return writeFileAtomically(file, std::to_string(std::stoi(*readFile(file)) + 1));
      }));
  };
  std::thread other(count);
  count();
  other.join();
  EXPECT_EQ(*readFile(file), "40");
}

TEST_F(PeoplesFile, OfResultsThatAreGoneIsNotMadeByTheLock) {
  const fs::path gone = out_ / "gone";
  EXPECT_FALSE(appendMany(gone, 0, 1));
  EXPECT_FALSE(fs::exists(gone));
}

TEST_F(PeoplesFile, IsLeftAloneWhereALinkStandsForTheLock) {
  fs::create_symlink(out_ / "elsewhere", out_ / kLockFile);
  bool ran = false;
  const Result<void> refused = changePeoplesFile(out_, [&]() -> Result<void> {
    ran = true;
    return {};
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::CannotWrite);
  EXPECT_FALSE(ran);
  EXPECT_FALSE(fs::exists(out_ / "elsewhere"));
}

TEST_F(PeoplesFile, TellsWhatTheChangeSaysAndIsFreeAgain) {
  const Result<void> refused =
      changePeoplesFile(out_, [] { return Result<void>(Error::cancelled()); });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Cancelled);
  EXPECT_TRUE(changePeoplesFile(out_, [] { return Result<void>(); }));
}

}  // namespace
}  // namespace ostraka::decisions
