#include "files/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/core/files/temporary_folder.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

class FilesTest : public testing::Test {
 protected:
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(FilesTest, ComeBackAsTheyWereWritten) {
  const std::string bytes("a\0b\xff\n", 5);
  ASSERT_TRUE(writeFileAtomically(folder_ / "deep/er/file.bin", bytes).has_value());
  const auto back = readFile(folder_ / "deep/er/file.bin");
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(*back, bytes);
}

TEST_F(FilesTest, AreReplacedWholeAndLeaveNothingBeside) {
  const fs::path file = folder_ / "file.txt";
  ASSERT_TRUE(writeFileAtomically(file, "a much longer first version").has_value());
  ASSERT_TRUE(writeFileAtomically(file, "second").has_value());
  EXPECT_EQ(*readFile(file), "second");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FilesTest, KeepTheOldVersionWhenThereIsNoRoomForTheNew) {
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

TEST_F(FilesTest, AreCopiedWholeOrSayThatTheDiskIsFull) {
  const fs::path from = folder_ / "from", to = folder_ / "to";
  const std::string bytes(3'000'000, 'b');
  ASSERT_TRUE(writeFileAtomically(from, bytes));
  fs::permissions(from, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(copyFile(from, to));
  EXPECT_EQ(*readFile(to), bytes);
  EXPECT_EQ(fs::status(to).permissions(), fs::status(from).permissions());
  EXPECT_FALSE(copyFile(from, to)) << "what is there stays";
  const Result<void> full = copyFile(from, "/dev/full");
  ASSERT_FALSE(full);
  EXPECT_NE(full.error().what.english().find("The disk is full"), std::string::npos);
  EXPECT_TRUE(fs::exists("/dev/full")) << "a device is not taken away";
}

// A limit of the file's size stands for the disk.
TEST_F(FilesTest, LeaveNoHalfOfACopy) {
  const fs::path from = folder_ / "from", to = folder_ / "to";
  ASSERT_TRUE(writeFileAtomically(from, std::string(3'000'000, 'b')));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{2'000'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Result<void> copied = copyFile(from, to);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(copied);
  EXPECT_FALSE(fs::exists(to));
  EXPECT_EQ(fs::file_size(from), 3'000'000U);
}

TEST_F(FilesTest, SayWhatIsWrongWithWhatCannotBeRead) {
  const auto absent = readFile(folder_ / "absent.txt");
  ASSERT_FALSE(absent.has_value());
  EXPECT_EQ(absent.error().code, ErrorCode::UnusableInput);
  EXPECT_NE(absent.error().sentence().english().find("absent.txt: There is no such file"),
            std::string::npos);
  EXPECT_FALSE(readFile(folder_).has_value()) << "a folder is no file";
  ASSERT_TRUE(writeFileAtomically(folder_ / "large", std::string(1000, 'x')).has_value());
  EXPECT_TRUE(readFile(folder_ / "large", 1000).has_value());
  EXPECT_FALSE(readFile(folder_ / "large", 999).has_value());
}

TEST_F(FilesTest, PlantedLinksAreReplacedAndWhatTheyLeadToStays) {
  const fs::path precious = folder_ / "precious", file = folder_ / "in/file.txt";
  ASSERT_TRUE(writeFileAtomically(precious, "keep me").has_value());
  fs::create_directories(folder_ / "in");
  fs::create_symlink(precious, file.string() + ".partial");
  fs::create_symlink(precious, file);
  ASSERT_TRUE(writeFileAtomically(file, "new").has_value());
  EXPECT_EQ(*readFile(precious), "keep me");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(file)));
  EXPECT_EQ(*readFile(file), "new");
  fs::remove(file);
  fs::create_symlink(folder_ / "not made", file);
  ASSERT_TRUE(writeFileAtomically(file, "new").has_value());
  EXPECT_FALSE(fs::exists(folder_ / "not made"));
}

TEST_F(FilesTest, KeepThePermissionsThatTheyHadAndNewOnesFollowTheUmask) {
  const mode_t before = ::umask(027);
  const fs::path fresh = folder_ / "fresh", closed = folder_ / "closed", open = folder_ / "open";
  const auto modeOf = [](const fs::path& file) {
    struct stat info {};
    EXPECT_EQ(::stat(file.c_str(), &info), 0);
    return info.st_mode & 0777;
  };
  for (const fs::path& file : {fresh, closed, open})
    ASSERT_TRUE(writeFileAtomically(file, "1").has_value());
  EXPECT_EQ(modeOf(fresh), 0640U);
  ASSERT_EQ(::chmod(closed.c_str(), 0600), 0);
  ASSERT_EQ(::chmod(open.c_str(), 0664), 0);
  for (const fs::path& file : {closed, open})
    ASSERT_TRUE(writeFileAtomically(file, "2").has_value());
  ::umask(before);
  EXPECT_EQ(modeOf(closed), 0600U);
  EXPECT_EQ(modeOf(open), 0664U);
}

TEST_F(FilesTest, WhatAKilledWriteLeftGoesWithTheNextWriteButALiveOneStays) {
  const fs::path file = folder_ / "file.txt";
  const fs::path dead = folder_ / ".file.txt.0123456789ab.partial",
                 alive = folder_ / ".file.txt.ba9876543210.partial",
                 foreign = folder_ / ".file.txt.mine.partial",
                 others = folder_ / ".other.txt.0123456789ab.partial";
  for (const fs::path& left : {dead, alive, foreign, others}) std::ofstream(left) << "half";
  const int held = ::open(alive.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  ASSERT_TRUE(writeFileAtomically(file, "whole").has_value());
  EXPECT_FALSE(fs::exists(dead));
  for (const fs::path& kept : {alive, foreign, others}) EXPECT_TRUE(fs::exists(kept)) << kept;
  ::close(held);
}

TEST_F(FilesTest, WritersOfOneNameAtTheSameTimeAllSucceed) {
  const fs::path file = folder_ / "file.txt";
  std::atomic<int> failures = 0;
  std::vector<std::thread> writers;
  for (int w = 0; w < 8; ++w)
    writers.emplace_back([&, w] {
      for (int k = 0; k < 25; ++k)
        if (!writeFileAtomically(file, std::string(1000, static_cast<char>('a' + w)))) ++failures;
    });
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(failures, 0);
  const std::string last = *readFile(file);
  EXPECT_EQ(last, std::string(1000, last[0]));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FilesTest, DoNotTakeThePlaceOfAPipeOrADeviceOrAFolder) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder_ / "null");
  fs::create_directories(folder_ / "folder");
  for (const auto& [name, word] :
       {std::pair{"pipe", "a pipe"}, {"null", "a device"}, {"folder", "a folder"}}) {
    const Result<void> written = writeFileAtomically(folder_ / name, "x");
    ASSERT_FALSE(written.has_value()) << name;
    EXPECT_EQ(written.error().code, ErrorCode::CannotWrite);
    EXPECT_NE(written.error().what.english().find(word), std::string::npos) << written.error().what;
  }
  EXPECT_TRUE(fs::is_symlink(folder_ / "null"));
}

TEST_F(FilesTest, ANameOfTheGreatestLengthCanBeWritten) {
  EXPECT_TRUE(writeFileAtomically(folder_ / std::string(255, 'n'), "x").has_value());
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FilesTest, CannotBeWrittenWhereAFileStandsInTheWay) {
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
