#include "store/wal_content.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/store/filled_project.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

// Of the words 1, 2, 3, 4: s0 = 1, s1 = 2 + 1; then s0 = 1 + 3 + 3, s1 = 3 + 4 + 7.
TEST(WalChecksum, SumsTwoWordsAtATimeInTheFilesByteOrder) {
  const std::array<unsigned char, 16> little = {1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0};
  std::array<unsigned char, 16> big{};
  for (std::size_t i = 0; i < big.size(); ++i) big[i] = little[i ^ 3];
  for (const bool big_endian : {false, true}) {
    std::uint32_t s0 = 0, s1 = 0;
    const unsigned char* bytes = big_endian ? big.data() : little.data();
    addToWalChecksum(bytes, 8, big_endian, s0, s1);
    EXPECT_EQ(s0, 1u);
    EXPECT_EQ(s1, 3u);
    addToWalChecksum(bytes + 8, 8, big_endian, s0, s1);
    EXPECT_EQ(s0, 7u);
    EXPECT_EQ(s1, 14u);
  }
  std::uint32_t s0 = 0xFFFFFFFF, s1 = 0;
  addToWalChecksum(little.data(), 8, false, s0, s1);
  EXPECT_EQ(s0, 0u) << "modulo 2^32";
  EXPECT_EQ(s1, 2u);
}

// As frames of a WAL tell it: which of them count.
WalContent walOf(const std::string& wal) {
  const ReadAt read = [&](unsigned char* to, std::size_t count, std::int64_t from) {
    const auto at = static_cast<std::size_t>(from);
    if (at + count > wal.size()) return false;
    std::copy_n(wal.begin() + from, count, to);
    return true;
  };
  return readWal(read, static_cast<std::int64_t>(wal.size()));
}

class DamagedWal : public FilledProject {
 protected:
  // A few transactions in the WAL of a closed project.
  void SetUp() override {
    project_.reset();
    inAKilledProcess([&] {
      project_ = std::make_unique<upkeep::Project>(*upkeep::Project::open(folder()));
      fill(4);
    });
    main_ = catalogue::bytesOf(file());
    wal_ = catalogue::bytesOf(file().string() + "-wal");
    frames_ = walOf(wal_).frames;
    ASSERT_GT(frames_.size(), 20u);
    content_ = *catalogue::contentOf(folder());
  }
  Result<std::string> contentWith(const std::string& wal) {
    catalogue::writeBytes(file(), main_);
    catalogue::writeBytes(file().string() + "-wal", wal);
    fs::remove(file().string() + "-shm");
    return catalogue::contentOf(folder());
  }
  std::string walWithBitOf(std::size_t byte) const {
    std::string wal = wal_;
    wal[byte] ^= 4;
    return wal;
  }
  std::string main_, wal_, content_;
  std::vector<WalFrame> frames_;
};

TEST_F(DamagedWal, IsRefusedAndLeftAsItIs) {
  // Number of the page, size, salt, checksum, page and page's checksum; a whole WAL stands first.
  ASSERT_EQ(*contentWith(wal_), content_);
  for (std::size_t frame = 0; frame + 1 < frames_.size(); frame += 7)
    for (const int place : {-21, -17, -14, -3, 100, 4090}) {
      const auto byte = static_cast<std::size_t>(frames_[frame].at + place);
      const std::string wal = walWithBitOf(byte);
      const Result<std::string> content = contentWith(wal);
      ASSERT_FALSE(content) << "frame " << frame << ", byte " << place;
      EXPECT_EQ(content.error().code, ErrorCode::Damaged);
      EXPECT_EQ(catalogue::bytesOf(file().string() + "-wal"), wal);
    }
}

TEST_F(DamagedWal, IsRefusedForABitOfItsHeaderAndOfTheLastPage) {
  for (const std::size_t byte : {std::size_t{1}, std::size_t{17}, std::size_t{26},
                                 static_cast<std::size_t>(frames_.back().at) + 700}) {
    const Result<std::string> content = contentWith(walWithBitOf(byte));
    ASSERT_FALSE(content) << "byte " << byte;
    EXPECT_EQ(content.error().code, ErrorCode::Damaged);
  }
}

TEST_F(DamagedWal, IsRepairedWithoutAnyBackup) {
  fs::remove_all(folder() / "backups");
  for (const int place : {-21, -17, -14, -3, 100, 4090}) {
    const std::string wal = walWithBitOf(static_cast<std::size_t>(frames_[9].at + place));
    ASSERT_FALSE(contentWith(wal));
    QuietProgress quiet;
    const Result<upkeep::RepairReport> report = upkeep::repairCatalogue(folder(), quiet, {});
    ASSERT_TRUE(report) << report.error().sentence();
    EXPECT_EQ(catalogue::bytesOf(report->damaged.string() + "-wal"), wal) << "it is kept";
    EXPECT_EQ(*catalogue::contentOf(folder()), content_) << "byte " << place;
    fs::remove_all(folder() / "backups");
  }
}

// What a killed process or a power cut leaves of a transaction is not damage.
TEST_F(DamagedWal, IsNotOneThatEndsWithinATransaction) {
  const auto last = static_cast<std::size_t>(frames_.back().at);
  for (const std::size_t bytes : {last + 2000, last - 10, last - 24, last - 5000}) {
    EXPECT_TRUE(contentWith(wal_.substr(0, bytes)));
    EXPECT_TRUE(contentWith(wal_.substr(0, bytes) + std::string(20000, '\0')));
  }
  // The first frame of a transaction that was given up lies behind the saved ones.
  EXPECT_EQ(*contentWith(
                wal_ + wal_.substr(static_cast<std::size_t>(frames_[3].at) - 24, kPageBytes + 24)),
            content_);
}

// Disks write in any order: the end of what was being written may stand, and not all before it.
TEST_F(DamagedWal, IsNotOneWhoseLastTransactionLacksAFrame) {
  const auto withoutFrame = [&](std::size_t frame) {
    std::string wal = wal_;
    wal.replace(static_cast<std::size_t>(frames_[frame].at) - 24, kPageBytes + 24,
                std::string(kPageBytes + 24, '\0'));
    return wal;
  };
  std::vector<std::size_t> ends;  // frames that name the size of the database
  for (std::size_t i = 0; i < frames_.size(); ++i)
    if (wal_.substr(static_cast<std::size_t>(frames_[i].at) - 20, 4) != std::string(4, '\0'))
      ends.push_back(i);
  ASSERT_GT(ends.size(), 1u);
  const std::size_t first_of_last = ends[ends.size() - 2] + 1;
  ASSERT_LT(first_of_last, ends.back());
  const Result<std::string> cut_off = contentWith(withoutFrame(first_of_last));
  ASSERT_TRUE(cut_off) << cut_off.error().sentence();
  EXPECT_NE(*cut_off, content_);
  const Result<std::string> lost = contentWith(withoutFrame(first_of_last - 2));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, ErrorCode::Damaged);
}

TEST_F(DamagedWal, HasFramesUntilTheEndOfTheLastTransactionAlone) {
  EXPECT_FALSE(walOf(wal_).damaged);
  const auto last = static_cast<std::size_t>(frames_.back().at);
  const WalContent cut_off = walOf(wal_.substr(0, last + 10));
  EXPECT_FALSE(cut_off.damaged);
  EXPECT_LT(cut_off.frames.size(), frames_.size());
  EXPECT_TRUE(walOf(walWithBitOf(static_cast<std::size_t>(frames_[2].at) + 100)).damaged);
  for (const std::string& none : {std::string(), std::string("short"), std::string(5000, '\0')}) {
    EXPECT_TRUE(walOf(none).frames.empty());
    EXPECT_FALSE(walOf(none).damaged);
  }
}

}  // namespace
}  // namespace ostraka::store
