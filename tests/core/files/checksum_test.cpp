#include "files/checksum.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "files/files.h"

namespace ostraka {
namespace {

TEST(Checksum, OfAFileInPiecesIsThatOfItsBytes) {
  const auto path = std::filesystem::path(testing::TempDir()) /
                    ("ostraka_checksum_" + std::to_string(::getpid()));
  for (const std::size_t size : {0u, 5u, 1u << 20, (3u << 20) + 7u}) {
    std::string bytes(size, 'x');
    for (std::size_t i = 0; i < size; i += 1000) bytes[i] = static_cast<char>(i);
    std::ofstream(path, std::ios::binary) << bytes;
    Result<OpenFile> file = OpenFile::open(path);
    ASSERT_TRUE(file);
    std::string read;
    const Result<Checksum> sum = checksumOf(*file, {}, [&](std::string_view piece) -> Result<void> {
      read += piece;
      return {};
    });
    ASSERT_TRUE(sum);
    EXPECT_EQ(sum->sha256, sha256(bytes)) << size;
    EXPECT_EQ(sum->bytes, static_cast<std::int64_t>(size));
    EXPECT_EQ(read, bytes);
  }
  Result<OpenFile> file = OpenFile::open(path);
  const auto refusing = [](std::string_view) -> Result<void> { return Error::unusable("no"); };
  EXPECT_EQ(checksumOf(*file, {}, refusing).error().what, "no");
  std::stop_source stop;
  stop.request_stop();
  file = OpenFile::open(path);
  EXPECT_EQ(checksumOf(*file, stop.get_token()).error().code, ErrorCode::Cancelled);
  std::filesystem::remove(path);
}

TEST(Checksum, OfPngAndZipIsThatOfTheStandard) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32(""), 0U);
}

}  // namespace
}  // namespace ostraka
