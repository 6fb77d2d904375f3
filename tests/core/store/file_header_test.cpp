#include "store/file_header.h"

#include <gmock/gmock.h>

#include "store/database.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

class FileHeader : public testing::Test {
 protected:
  FileHeader() {
    auto database = std::move(*Database::open(file_, Database::Mode::Create));
    database->script(
        "PRAGMA application_id = 1330861138; PRAGMA user_version = 3;"
        "CREATE TABLE thing (row INTEGER PRIMARY KEY) STRICT;");
    database->copyTo(backup_);
    database.reset();
    bytes_ = catalogue::bytesOf(file_);
  }
  // Of the file with this in place of its bytes from `at` on.
  std::string saidOf(std::size_t at, const std::string& other) const {
    std::string bytes = bytes_;
    catalogue::writeBytes(file_, bytes.replace(at, other.size(), other));
    const Result<void> checked = checkHeader(file_);
    if (checked) return "good";
    EXPECT_EQ(checked.error().code, ErrorCode::Damaged);
    EXPECT_EQ(checked.error().where, file_.string());
    return checked.error().what.english();
  }
  TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "catalogue.sqlite",
                 backup_ = folder_.path() / "backup.sqlite";
  std::string bytes_;
};

// Places of sqlite.org/fileformat2.html, section 1.3.
TEST_F(FileHeader, TellsWhyAFileIsNoCatalogue) {
  using testing::HasSubstr;
  EXPECT_EQ(saidOf(0, ""), "good");
  EXPECT_THAT(saidOf(0, "SQLite format 4"), HasSubstr("not a database"));
  EXPECT_THAT(saidOf(68, "QGIS"), HasSubstr("another program"));
  EXPECT_THAT(saidOf(60, std::string(4, '\0')), HasSubstr("contains no catalogue"));
  EXPECT_THAT(saidOf(16, std::string("\x20\0", 2)), HasSubstr("inconsistent")) << "8192 a page";
  EXPECT_THAT(saidOf(20, std::string(1, '\0')), HasSubstr("inconsistent")) << "no checksums";
  catalogue::writeBytes(file_, "");
  EXPECT_THAT(checkHeader(file_).error().what.english(), HasSubstr("empty"));
  catalogue::writeBytes(file_, "short");
  EXPECT_THAT(checkHeader(file_).error().what.english(), HasSubstr("not a database"));
}

TEST_F(FileHeader, OfAFileThatCannotBeReadIsNotDamaged) {
  const Result<void> none = checkHeader(folder_.path() / "none.sqlite");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::UnusableInput);
  EXPECT_FALSE(hasWalOfAnother(folder_.path() / "none.sqlite"));
}

// SQLite would write the newer pages into the older file.
TEST_F(FileHeader, OfABackupBesideTheWalOfItsCatalogueIsRefused) {
  EXPECT_TRUE(checkHeader(backup_)) << "without one";
  catalogue::writeBytes(backup_.string() + "-wal", "");
  EXPECT_TRUE(checkHeader(backup_)) << "an empty one says nothing";
  catalogue::writeBytes(backup_.string() + "-wal", "frames");
  EXPECT_TRUE(hasWalOfAnother(backup_));
  EXPECT_EQ(checkHeader(backup_).error().code, ErrorCode::Damaged);
  catalogue::writeBytes(file_.string() + "-wal", "frames");
  EXPECT_FALSE(hasWalOfAnother(file_)) << "its own";
}

}  // namespace
}  // namespace ostraka::store
