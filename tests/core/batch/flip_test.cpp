#include "batch/flip.h"

#include <gmock/gmock.h>

#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::Optional;

std::vector<std::int64_t> times(std::initializer_list<int> pauses_s) {
  std::vector<std::int64_t> ms{1'000'000};
  for (const int s : pauses_s) ms.push_back(ms.back() + 1000 * s);
  return ms;
}

// A JPEG that says when it was taken.
std::string taken(const std::string& time) {
  return std::string(
             "\xFF\xD8\xFF\xE1\0\x48"
             "Exif\0\0MM\0*\0\0\0\x08"
             "\0\x01\x87\x69\0\x04\0\0\0\x01\0\0\0\x1A\0\0\0\0"
             "\0\x01\x90\x03\0\x02\0\0\0\x14\0\0\0\x2C\0\0\0\0",
             56) +
         "2026:07:14 " + time + std::string("\0\xFF\xD9", 3);
}

TEST(Flip, IsTheLongestPauseWhereItStandsOut) {
  EXPECT_THAT(flipIn(times({5, 6, 5, 90, 5, 5, 6})), Optional(4U));
  EXPECT_THAT(flipIn(times({0, 0, 0, 90, 0, 0, 0})), Optional(4U)) << "bursts";
}

TEST(Flip, IsNotGuessedWhereNoPauseStandsOut) {
  EXPECT_EQ(flipIn(times({5, 6, 5, 7, 5, 5, 6})), std::nullopt);
  EXPECT_EQ(flipIn(times({5, 5, 5, 90, 5, 5, 60, 5, 5, 5})), std::nullopt) << "two pauses";
  EXPECT_EQ(flipIn(times({0, 0, 0, 0, 0, 0})), std::nullopt) << "a clock that stands still";
  EXPECT_EQ(flipIn(times({90, 5, 5, 5, 5})), std::nullopt) << "a first photograph is no side";
  EXPECT_EQ(flipIn(times({5, 90})), std::nullopt);
  EXPECT_EQ(flipIn({}), std::nullopt);
}

// Names that started again from 1 come before by name, and later by the clock.
TEST(Flip, OfASeriesGoesByTheClockNotByNames) {
  const BatchFolder folder;
  const char* names[] = {"b9998.jpg", "b9999.jpg", "c0000.jpg",
                         "a0001.jpg", "a0002.jpg", "a0003.jpg"};
  const char* at[] = {"09:30:00", "09:30:08", "09:30:15", "09:34:00", "09:34:07", "09:34:15"};
  std::vector<std::filesystem::path> files;
  for (int i = 5; i >= 0; --i) {
    folder.write(names[i], taken(at[i]));
    files.push_back(folder.path() / names[i]);
  }
  const Series series = seriesOf(files);
  ASSERT_TRUE(series.flip_found);
  EXPECT_EQ(series.first_back, 3U);
  EXPECT_EQ(series.files.front().filename(), "b9998.jpg");
  EXPECT_EQ(series.files.back().filename(), "a0003.jpg");
}

TEST(Flip, IsProposedAtAJumpOfTheNumbersWhereTimesAreMissing) {
  std::vector<std::filesystem::path> files;
  for (const int i : {4, 11, 12, 2, 3, 13, 14})
    files.push_back("IMG_" + std::to_string(i) + ".jpg");
  const Series series = seriesOf(files);
  EXPECT_FALSE(series.flip_found);
  EXPECT_EQ(series.first_back, 3U);
  EXPECT_EQ(series.files[3].filename(), "IMG_11.jpg");
  EXPECT_EQ(seriesOf({"1.jpg", "2.jpg", "3.jpg", "4.jpg"}).first_back, 2U);
  EXPECT_EQ(seriesOf({"x.jpg"}).first_back, 0U);
  EXPECT_EQ(seriesOf({}).first_back, 0U);
}

}  // namespace
}  // namespace ostraka::batch
