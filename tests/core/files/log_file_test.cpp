#include "files/log_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>

#include "tests/core/files/temporary_folder.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

struct LogFiles : testing::Test {
  TemporaryFolder temporary;
  fs::path folder = temporary.path();
  static std::string textOf(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(LogFiles, GrowAtTheirEnd) {
  LogFile(folder / "log.txt").line("first");
  LogFile(folder / "log.txt").line("second");
  EXPECT_EQ(textOf(folder / "log.txt"), "first\nsecond\n");
}

TEST_F(LogFiles, ReplaceAPlantedLinkAndLeaveWhatItLeadsTo) {
  std::ofstream(folder / "precious") << "keep me";
  fs::create_symlink(folder / "precious", folder / "log.txt");
  LogFile(folder / "log.txt").line("new");
  EXPECT_EQ(textOf(folder / "precious"), "keep me");
  EXPECT_EQ(textOf(folder / "log.txt"), "new\n");
}

TEST_F(LogFiles, DoNotWaitForTheReaderOfAPipe) {
  ASSERT_EQ(::mkfifo((folder / "log.txt").c_str(), 0600), 0);
  LogFile log(folder / "log.txt");
  EXPECT_LT(log.descriptor(), 0);
  log.line("nobody reads this");
}

}  // namespace
}  // namespace ostraka
