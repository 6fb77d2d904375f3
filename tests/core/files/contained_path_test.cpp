#include "files/contained_path.h"

#include <gtest/gtest.h>

namespace ostraka {
namespace {

TEST(ContainedPath, IsPartsBetweenSingleSlashes) {
  const Result<ContainedPath> path = ContainedPath::parse("data/sherds/É 1.json");
  ASSERT_TRUE(path) << path.error().sentence();
  EXPECT_EQ(path->text(), "data/sherds/É 1.json");
  EXPECT_EQ(path->parts(), (std::vector<std::string>{"data", "sherds", "É 1.json"}));
  EXPECT_EQ(path->below().text(), "sherds/É 1.json");
  EXPECT_EQ(path->below().parts().size(), 2u);
  for (const char* plain : {"a", "..a", "a..", ".hidden", "a/...", "a b"})
    EXPECT_TRUE(ContainedPath::parse(plain)) << plain;
}

TEST(ContainedPath, LeadsNowhereElse) {
  using namespace std::string_literals;
  for (const std::string& bad : {""s,
                                 "/"s,
                                 "/etc/passwd"s,
                                 ".."s,
                                 "../a"s,
                                 "a/.."s,
                                 "a/../b"s,
                                 "."s,
                                 "./a"s,
                                 "a/."s,
                                 "a//b"s,
                                 "a/"s,
                                 "a\\b"s,
                                 "C:/a"s,
                                 "a\nb"s,
                                 "a\tb"s,
                                 "a\x01"
                                 "b"s,
                                 "a\x7F"s,
                                 "a\0b"s,
                                 std::string(256, 'a'),
                                 "a/" + std::string(256, 'b')}) {
    const Result<ContainedPath> path = ContainedPath::parse(bad);
    ASSERT_FALSE(path) << bad;
    EXPECT_EQ(path.error().code, ErrorCode::UnusableInput);
  }
  std::string deep = "a";
  while (deep.size() <= 4096) deep += "/a";
  EXPECT_FALSE(ContainedPath::parse(deep));
}

}  // namespace
}  // namespace ostraka
