#include "files/hold.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "tests/core/files/temporary_folder.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class Holds : public testing::Test {
 protected:
  Holds() { std::ofstream(file_) << "half"; }
  TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "file.partial";
};

TEST_F(Holds, AreForOneHolderAtATime) {
  for (const fs::path& held : {file_, folder_.path()}) {
    {
      const std::optional<Hold> hold = Hold::take(held);
      ASSERT_TRUE(hold) << held;
      EXPECT_FALSE(Hold::take(held)) << held;
    }
    EXPECT_TRUE(Hold::take(held)) << held;
  }
  EXPECT_FALSE(Hold::take(folder_.path() / "absent"));
}

TEST_F(Holds, MoveWithTheirObject) {
  std::optional<Hold> first = Hold::take(file_);
  ASSERT_TRUE(first);
  std::optional<Hold> second(std::move(*first));
  first.reset();
  EXPECT_FALSE(Hold::take(file_));
  second.reset();
  EXPECT_TRUE(Hold::take(file_));
}

TEST_F(Holds, AreWaitedForNoLongerThanAsked) {
  const std::optional<Hold> hold = Hold::take(file_);
  const auto before = std::chrono::steady_clock::now();
  EXPECT_FALSE(Hold::wait(file_, 50ms));
  EXPECT_GE(std::chrono::steady_clock::now() - before, 50ms);
  EXPECT_FALSE(Hold::wait(file_, 0ms)) << "asked once";
}

// A file that a killed program left is nobody's, and whoever waits for it gets it.
TEST_F(Holds, EndWithTheProcess) {
  int told[2];
  ASSERT_EQ(::pipe(told), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const std::optional<Hold> hold = Hold::take(file_);
    [[maybe_unused]] const auto n = ::write(told[1], hold ? "y" : "n", 1);
    ::pause();
    ::_exit(0);
  }
  char answer = '?';
  ASSERT_EQ(::read(told[0], &answer, 1), 1);
  EXPECT_EQ(answer, 'y');
  EXPECT_FALSE(Hold::take(file_));
  ::kill(child, SIGKILL);
  EXPECT_TRUE(Hold::wait(file_, 30s));
  ::waitpid(child, nullptr, 0);
  for (const int end : told) ::close(end);
}

}  // namespace
}  // namespace ostraka
