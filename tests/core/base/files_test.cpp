#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace ostraka {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("ostraka_files_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(Files, ComeBackAsTheyWereWritten) {
  const std::string bytes("a\0b\xff\n", 5);
  ASSERT_TRUE(writeFileAtomically(folder_ / "deep/er/file.bin", bytes).has_value());
  const auto back = readFile(folder_ / "deep/er/file.bin");
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(*back, bytes);
}

TEST_F(Files, AreReplacedWholeAndLeaveNothingBeside) {
  const fs::path file = folder_ / "file.txt";
  ASSERT_TRUE(writeFileAtomically(file, "a much longer first version").has_value());
  ASSERT_TRUE(writeFileAtomically(file, "second").has_value());
  EXPECT_EQ(*readFile(file), "second");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, KeepTheOldVersionWhenThereIsNoRoomForTheNew) {
  const fs::path file = folder_ / "file.txt";
  ASSERT_TRUE(writeFileAtomically(file, "old").has_value());
  // A limit on file sizes fails a write in the middle as a full disk does.
  struct rlimit before {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit small = before;
  small.rlim_cur = 4096;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const Result<void> written = writeFileAtomically(file, std::string(100'000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ErrorCode::CannotWrite);
  EXPECT_NE(written.error().where.find("file.txt"), std::string::npos);
  EXPECT_EQ(*readFile(file), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, SayWhatIsWrongWithWhatCannotBeRead) {
  const auto absent = readFile(folder_ / "absent.txt");
  ASSERT_FALSE(absent.has_value());
  EXPECT_EQ(absent.error().code, ErrorCode::UnusableInput);
  EXPECT_NE(absent.error().sentence().find("absent.txt: There is no such file"), std::string::npos);
  EXPECT_FALSE(readFile(folder_).has_value()) << "a folder is no file";
  ASSERT_TRUE(writeFileAtomically(folder_ / "large", std::string(1000, 'x')).has_value());
  EXPECT_TRUE(readFile(folder_ / "large", 1000).has_value());
  EXPECT_FALSE(readFile(folder_ / "large", 999).has_value());
}

TEST_F(Files, CannotBeWrittenWhereAFileStandsInTheWay) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "file", "x").has_value());
  const auto written = writeFileAtomically(folder_ / "file" / "below", "y");
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ErrorCode::CannotWrite);
}

TEST(Sha256, GivesTheStandardsExamples) {
  // FIPS 180-2, appendix B.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace ostraka
