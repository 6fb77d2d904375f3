#include "base/uuid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace ostraka {
namespace {

TEST(Uuid, AnIdIsAUuidOfVersionSevenThatBeginsWithTheTime) {
  const std::string id = newId(0x019f5ff639c0);
  EXPECT_TRUE(isUuid(id)) << id;
  EXPECT_EQ(id.substr(0, 13), "019f5ff6-39c0");
  EXPECT_EQ(id[14], '7');
  EXPECT_NE(std::string("89ab").find(id[19]), std::string::npos);
}

TEST(Uuid, IdsOfTheSameMillisecondDiffer) {
  std::set<std::string> ids;
  for (int i = 0; i < 1000; ++i) ids.insert(newId(1));
  EXPECT_EQ(ids.size(), 1000u);
}

TEST(Uuid, WhatIsNoUuidIsSeen) {
  EXPECT_FALSE(isUuid(""));
  EXPECT_FALSE(isUuid("019f5ff6-39c0-7b3a-9c55-2f7e8d104ab"));
  EXPECT_FALSE(isUuid("019f5ff6-39c0-7b3a-9c55-2f7e8d104abg"));
  EXPECT_FALSE(isUuid("019f5ff6x39c0-7b3a-9c55-2f7e8d104ab6"));
}

}  // namespace
}  // namespace ostraka
