#include "upkeep/file_check_log.h"

#include <gmock/gmock.h>

#include <fstream>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class CheckLog : public testing::Test {
 protected:
  static KnownFile known(const std::string& path, const std::string& hash = "ab12") {
    KnownFile file;
    file.path = path;
    file.sha256 = hash;
    return file;
  }
  fs::path file() const { return folder_.path() / "file-checks.txt"; }
  FileCheckLog opened() const { return FileCheckLog(folder_.path()); }
  void write(const std::string& text) const {
    ASSERT_TRUE(writeFileAtomically(file(), text).has_value());
  }
  TemporaryFolder folder_;
};

TEST_F(CheckLog, TellsTheNextProgramWhatEachCheckFound) {
  {
    FileCheckLog log = opened();
    log.note(known("batches/B0001/front/a b.jpg"), 1000, std::nullopt, "3,7,1.2,1.3");
    log.note(known("models/m.ply"), 2000, Damage::Changed, "");
    log.note(known("models/n.ply"), 3000, Damage::Missing, "");
    log.note(known("models/o.ply"), 4000, Damage::Unreadable, "5");
  }
  const FileCheckLog log = opened();
  const FileCheckLog::Seen* whole = log.seen(known("batches/B0001/front/a b.jpg"));
  ASSERT_NE(whole, nullptr);
  EXPECT_EQ(whole->at_ms, 1000);
  EXPECT_EQ(whole->damage, std::nullopt);
  EXPECT_EQ(whole->stamp, "3,7,1.2,1.3");
  const std::map<std::string, Damage> damaged = {{"models/m.ply", Damage::Changed},
                                                 {"models/n.ply", Damage::Missing},
                                                 {"models/o.ply", Damage::Unreadable}};
  for (const auto& [path, damage] : damaged) {
    ASSERT_NE(log.seen(known(path)), nullptr) << path;
    EXPECT_EQ(log.seen(known(path))->damage, damage) << path;
  }
  EXPECT_EQ(log.seen(known("models/m.ply"))->stamp, "");
}

TEST_F(CheckLog, SaysNothingOfAFileThatTheCatalogueHoldsAnewOrWithoutAHash) {
  FileCheckLog log = opened();
  log.note(known("a.jpg", "ab12"), 1000, std::nullopt, "");
  log.note(known("b.jpg", ""), 1000, std::nullopt, "");
  EXPECT_NE(log.seen(known("a.jpg", "ab12")), nullptr);
  EXPECT_EQ(log.seen(known("a.jpg", "cd34")), nullptr);
  EXPECT_EQ(log.seen(known("b.jpg", "")), nullptr);
  EXPECT_EQ(log.seen(known("never.jpg")), nullptr);
}

TEST_F(CheckLog, TellsTheLastCheckOfAFile) {
  {
    FileCheckLog log = opened();
    log.note(known("a.jpg"), 1000, Damage::Changed, "1");
    log.note(known("a.jpg"), 2000, std::nullopt, "2");
  }
  EXPECT_EQ(opened().seen(known("a.jpg"))->at_ms, 2000);
  EXPECT_EQ(opened().seen(known("a.jpg"))->damage, std::nullopt);
}

TEST_F(CheckLog, KnowsTheRoundThatDidNotEnd) {
  EXPECT_EQ(opened().begun_ms(), 0);
  {
    FileCheckLog log = opened();
    log.begin(5000);
    log.note(known("a.jpg"), 5001, std::nullopt, "");
    EXPECT_EQ(log.begun_ms(), 5000);
  }
  EXPECT_EQ(opened().begun_ms(), 5000);
  opened().end(6000);
  EXPECT_EQ(opened().begun_ms(), 0);
}

// The power fails within a line, at whichever byte: what stood before it holds, what comes after it
// is read.
TEST_F(CheckLog, LosesOneLineAtMostWhereTheLastWasCutOff) {
  const std::string first = "1000 whole ab12 - a.jpg\n";
  const std::string second = "2000 changed ab12 9,9 models/m.ply\n";
  for (std::size_t size = 1; size < second.size(); ++size) {
    write(first + second.substr(0, size));
    {
      FileCheckLog log = opened();
      ASSERT_NE(log.seen(known("a.jpg")), nullptr) << size;
      EXPECT_EQ(log.seen(known("models/m.ply")), nullptr) << size << ": not even half a path";
      EXPECT_EQ(log.seen(known("models/m.p")), nullptr);
      log.note(known("c.jpg"), 3000, std::nullopt, "");
    }
    const FileCheckLog log = opened();
    EXPECT_NE(log.seen(known("a.jpg")), nullptr) << size;
    ASSERT_NE(log.seen(known("c.jpg")), nullptr) << size;
    EXPECT_EQ(log.seen(known("c.jpg"))->at_ms, 3000);
  }
}

TEST_F(CheckLog, PassesOverLinesThatSayNothing) {
  write(
      "\n"
      "rubbish\n"
      "99999999999999999999999 whole ab12 - a.jpg\n"
      "1000 fine ab12 - b.jpg\n"
      "1000 whole ab12\n"
      "1000 whole ab12 -\n"
      "2000 whole ab12 - c.jpg\n");
  const FileCheckLog log = opened();
  EXPECT_EQ(log.seen(known("a.jpg")), nullptr);
  EXPECT_EQ(log.seen(known("b.jpg")), nullptr);
  EXPECT_NE(log.seen(known("c.jpg")), nullptr);
}

// Twice the files and a thousand lines more are one too many.
TEST_F(CheckLog, IsWrittenAnewWithOneLineForEachFileBeforeItGrowsWithoutEnd) {
  std::string text = "7 begin\n";
  for (int i = 0; i < 1001; ++i) text += std::to_string(1000 + i) + " whole ab12 - a.jpg\n";
  write(text);
  EXPECT_EQ(opened().seen(known("a.jpg"))->at_ms, 2000) << "1,002 lines for one file: kept";
  EXPECT_EQ(*readFile(file()), text);
  write(text + "2001 changed ab12 4,5 a.jpg\n");
  EXPECT_EQ(opened().begun_ms(), 7);
  EXPECT_EQ(*readFile(file()), "2001 changed ab12 4,5 a.jpg\n7 begin\n");
  EXPECT_EQ(opened().begun_ms(), 7);
  EXPECT_EQ(opened().seen(known("a.jpg"))->damage, Damage::Changed);
}

TEST_F(CheckLog, IsNeitherReadNorWrittenThroughALink) {
  const fs::path elsewhere = folder_.path() / "elsewhere.txt";
  ASSERT_TRUE(writeFileAtomically(elsewhere, "").has_value());
  fs::create_symlink(elsewhere, file());
  opened().note(known("a.jpg"), 1000, std::nullopt, "");
  EXPECT_EQ(*readFile(elsewhere), "");
}

TEST_F(CheckLog, StampChangesWithWhateverIsDoneToAFile) {
  const fs::path file = folder_.path() / "a.jpg";
  EXPECT_EQ(FileCheckLog::stampOf(file), "");
  EXPECT_EQ(FileCheckLog::stampOf(folder_.path()), "");
  ASSERT_TRUE(writeFileAtomically(file, "abc").has_value());
  const std::string first = FileCheckLog::stampOf(file);
  EXPECT_THAT(first, testing::StartsWith("3,"));
  EXPECT_EQ(FileCheckLog::stampOf(file), first);
  EXPECT_THAT(first, testing::Not(testing::HasSubstr(" "))) << "it is one word of a line";
  std::ofstream(file, std::ios::app) << 'd';
  const std::string longer = FileCheckLog::stampOf(file);
  EXPECT_NE(longer, first);
  fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
  EXPECT_NE(FileCheckLog::stampOf(file), longer);
  fs::create_symlink(file, folder_.path() / "link");
  EXPECT_EQ(FileCheckLog::stampOf(folder_.path() / "link"), "") << "what it leads to may change";
}

}  // namespace
}  // namespace ostraka::upkeep
