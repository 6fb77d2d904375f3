#include "archive/zip.h"

#include <gtest/gtest.h>

namespace ostraka::archive {
namespace {

using namespace std::string_literals;

TEST(Zip, IsAsTheNoteOnTheFormatSays) {
  const Result<std::string> zip = zipped({{"a", "123456789"}, {"b/c", ""}});
  ASSERT_TRUE(zip);
  EXPECT_EQ(zip->substr(0, 10), "PK\x03\x04\x14\x00\x00\x00\x00\x00"s);
  EXPECT_EQ(zip->substr(14, 4), "\x26\x39\xF4\xCB"s) << "the check value of CRC-32: CBF43926";
  EXPECT_EQ(zip->substr(18, 12), "\x09\0\0\0\x09\0\0\0\x01\0\0\0"s);
  EXPECT_EQ(zip->substr(30, 10), "a123456789");
  const std::size_t central = zip->find("PK\x01\x02"s), end = zip->find("PK\x05\x06"s);
  ASSERT_NE(central, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  EXPECT_EQ(central, 40u + 30u + 3u) << "both entries, headers of 30 bytes, stand before it";
  EXPECT_EQ(end + 22, zip->size());
  EXPECT_EQ(static_cast<unsigned char>((*zip)[end + 10]), 2) << "entries";
  EXPECT_EQ(static_cast<unsigned char>((*zip)[end + 16]), central);
}

}  // namespace
}  // namespace ostraka::archive
