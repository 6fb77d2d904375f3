#include <gmock/gmock.h>

#include "batch/batch.h"
#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::HasSubstr;

constexpr const char* kGood = R"({"unit":"mm","lengths":[{"side":"back","length":50,"ends":[
  [{"file":"cam1_image001.tif","pixel":[10,20]},{"file":"cam1_image004.tif","pixel":[11,21.5]}],
  [{"file":"cam1_image001.tif","pixel":[90,20]},{"file":"cam1_image004.tif","pixel":[95,25]}]]}]})";

TEST(KnownLength, IsReadWithItsMarks) {
  const BatchFolder folder;
  folder.write("scale.json", kGood);
  const auto lengths = readKnownLengths(folder.path() / "scale.json");
  ASSERT_TRUE(lengths.has_value()) << lengths.error().sentence();
  ASSERT_EQ(lengths->size(), 1u);
  EXPECT_EQ(lengths->front().side, Side::Back);
  EXPECT_EQ(lengths->front().length_mm, 50);
  ASSERT_EQ(lengths->front().ends[0].size(), 2u);
  EXPECT_EQ(lengths->front().ends[0][1].file, "cam1_image004.tif");
  EXPECT_EQ(lengths->front().ends[0][1].pixel, Eigen::Vector2d(11, 21.5));
}

TEST(KnownLength, IsRefusedWithTheReasonAndTheFile) {
  const BatchFolder folder;
  const std::pair<std::string, std::string> changes[] = {
      {R"("unit":"mm")", R"("unit":"cm")"},
      {R"("side":"back")", R"("side":"top")"},
      {R"("length":50)", R"("length":-5)"},
      {R"("pixel":[10,20])", R"("pixel":[10])"},
      {R"(,{"file":"cam1_image004.tif","pixel":[11,21.5]})", ""}};
  const char* words[] = {"unit", "'side'", "'length'", "'pixel'", "two photographs"};
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    std::string text = kGood;
    text.replace(text.find(changes[i].first), changes[i].first.size(), changes[i].second);
    folder.write("scale.json", text);
    const auto lengths = readKnownLengths(folder.path() / "scale.json");
    ASSERT_FALSE(lengths.has_value()) << text;
    EXPECT_THAT(lengths.error().sentence(), HasSubstr(words[i]));
    EXPECT_THAT(lengths.error().sentence(), HasSubstr("scale.json"));
  }
}

}  // namespace
}  // namespace ostraka::batch
