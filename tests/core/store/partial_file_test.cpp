#include "store/partial_file.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;
using catalogue::bytesOf;
using catalogue::writeBytes;

class PartialFiles : public testing::Test {
 protected:
  PartialFile begun() const { return std::move(*PartialFile::beside(file_)); }
  TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "catalogue.sqlite";
};

TEST_F(PartialFiles, GoWithWhoeverDidNotFinishThem) {
  fs::path first;
  {
    const PartialFile partial = begun(), other = begun();
    first = partial.path();
    EXPECT_NE(first, other.path());
    EXPECT_EQ(first.parent_path(), folder_.path());
    writeBytes(first.string() + "-wal", "frames");
  }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(PartialFiles, TakeTheNameOnlyWhereItIsFreeOrMayBeReplaced) {
  writeBytes(file_, "before");
  PartialFile partial = begun();
  writeBytes(partial.path(), "whole");
  EXPECT_FALSE(partial.become(file_, PartialFile::Existing::Refused));
  EXPECT_EQ(bytesOf(file_), "before");
  EXPECT_EQ(bytesOf(partial.path()), "whole") << "to be tried again";
  ASSERT_TRUE(partial.become(file_, PartialFile::Existing::Replaced));
  EXPECT_EQ(bytesOf(file_), "whole");
  PartialFile second = begun();
  ASSERT_TRUE(second.become(folder_.path() / "other.sqlite", PartialFile::Existing::Refused));
}

// SQLite keeps to itself that a full disk kept it from bringing all into the file.
TEST_F(PartialFiles, DoNotTakeTheNameWithoutWhatIsStillInTheWal) {
  PartialFile partial = begun();
  writeBytes(partial.path().string() + "-wal", "frames");
  EXPECT_EQ(partial.become(file_, PartialFile::Existing::Refused).error().code,
            ErrorCode::CannotWrite);
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(PartialFiles, OfAKilledProcessAreRemovedAndThoseOfOthersStay) {
  const fs::path left = file_.string() + ".77-0.partial";
  writeBytes(left, "half");
  writeBytes(left.string() + "-wal", "frames");
  writeBytes(file_.string() + ".78-0.partial-journal", "its database is gone");
  writeBytes(folder_.path() / "photographs.partial", "of somebody else");
  writeBytes(file_, "whole");
  const PartialFile held = begun();
  EXPECT_TRUE(PartialFile::isLeftover(left));
  EXPECT_FALSE(PartialFile::isLeftover(held.path())) << "somebody is writing it";
  EXPECT_FALSE(PartialFile::isLeftover(file_));
  PartialFile::removeLeftovers(folder_.path());
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(left.string() + "-wal"));
  EXPECT_FALSE(fs::exists(file_.string() + ".78-0.partial-journal"));
  EXPECT_TRUE(fs::exists(folder_.path() / "photographs.partial"));
  EXPECT_TRUE(fs::exists(held.path()));
  EXPECT_EQ(bytesOf(file_), "whole");
}

}  // namespace
}  // namespace ostraka::store
