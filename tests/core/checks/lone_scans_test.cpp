#include "checks/lone_scans.h"

#include <gmock/gmock.h>

namespace ostraka::checks {
namespace {

scan::Scan slab(const std::string& id, int width_mm, int depth_mm) {
  scan::Scan scan;
  scan.id = id;
  for (int x = 0; x < 2 * width_mm; ++x)
    for (int y = 0; y < 2 * depth_mm; ++y)
      scan.cloud.points.emplace_back(0.25f + 0.5f * static_cast<float>(x),
                                     0.25f + 0.5f * static_cast<float>(y), 5.f);
  return scan;
}

TEST(PerhapsTouching, NamesTheTwoOfTheOtherSideThatAreAsLargeTogether) {
  const scan::Scan both = slab("b004", 40, 60), first = slab("f001", 30, 40),
                   second = slab("f002", 40, 32), small = slab("f007", 20, 20);
  const scan::Scan* lone[] = {&both};
  const scan::Scan* others[] = {&small, &first, &second};
  const std::vector<Message> words = perhapsTouching(lone, others);
  ASSERT_EQ(words.size(), 1u);
  EXPECT_THAT(words[0], testing::HasSubstr("b004 may be two sherds that touch, f001 and f002 of"));
  EXPECT_TRUE(perhapsTouching(others, lone).empty()) << "one alone is no two";
}

TEST(PerhapsTouching, SaysNothingOfOtherSizes) {
  const scan::Scan lone = slab("b004", 40, 60), first = slab("f001", 40, 40),
                   second = slab("f002", 40, 36);
  const scan::Scan* one[] = {&lone};
  const scan::Scan* others[] = {&first, &second};
  EXPECT_TRUE(perhapsTouching(one, others).empty());
}

}  // namespace
}  // namespace ostraka::checks
