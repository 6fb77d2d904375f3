#include "images/image_header.h"

#include <gmock/gmock.h>

#include <random>

#include "base/limits.h"
#include "tests/core/batch/batch_folder.h"

namespace ostraka::images {
namespace {

using testing::HasSubstr;

std::string encoded(const std::string& ending, int width, int height) {
  std::vector<unsigned char> bytes;
  cv::Mat picture(height, width, CV_8UC3);
  cv::randu(picture, 0, 255);
  cv::imencode(ending, picture, bytes);
  return {bytes.begin(), bytes.end()};
}

class EveryFormat : public testing::TestWithParam<const char*> {};

TEST_P(EveryFormat, GivesTheSizeThatWasEncoded) {
  const auto size = imageSize(encoded(GetParam(), 61, 37), "x");
  ASSERT_TRUE(size.has_value()) << size.error().sentence();
  EXPECT_EQ(*size, (ImageSize{61, 37}));
}

TEST_P(EveryFormat, IsRecognisedAsCutOffWhereverItIsCut) {
  const std::string whole = encoded(GetParam(), 61, 37);
  for (std::size_t length = 0; length + 2 < whole.size(); length += 97)
    EXPECT_FALSE(imageSize(std::string_view(whole).substr(0, length), "x").has_value()) << length;
}

TEST_P(EveryFormat, SurvivesChangedBytes) {
  const std::string whole = encoded(GetParam(), 24, 16);
  std::mt19937 random(7);
  for (int round = 0; round < 5000; ++round) {
    std::string damaged = whole;
    for (int k = 0; k < 4; ++k)
      damaged[random() % std::min<std::size_t>(damaged.size(), 400)] = static_cast<char>(random());
    const auto size = imageSize(damaged, "x");
    if (size) {
      EXPECT_LE(static_cast<std::uint64_t>(size->width) * size->height, limits::kImagePixels.most);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::Values(".jpg", ".png", ".tif"));

// Telephones write 200 megapixels; a small file can claim a thousand.
TEST(CheckedSize, TakesWhatSensorsHaveAndNoMore) {
  EXPECT_TRUE(checkedSize(16320, 12240, "a.jpg").has_value());
  const Result<ImageSize> bomb = checkedSize(32000, 32000, "a.jpg");
  ASSERT_FALSE(bomb.has_value());
  EXPECT_THAT(bomb.error().sentence().english(),
              HasSubstr("a.jpg: The image header states a size"));
}

TEST(ImageSize, RefusesAJpegWithMoreScansThanAnyCameraWrites) {
  const std::string whole = encoded(".jpg", 61, 37);
  const auto with = [&](std::uint64_t scans) {
    std::string more = whole.substr(0, whole.size() - 2);  // before the end of the image
    for (std::uint64_t i = 1; i < scans; ++i)
      more += std::string("\xFF\xDA\0\x08\x01\x01\0\x01\x3F\0\x7F", 11);
    return more + "\xFF\xD9";
  };
  EXPECT_TRUE(imageSize(with(limits::kJpegScans.most), "x"));
  EXPECT_THAT(imageSize(with(limits::kJpegScans.most + 1), "x").error().what,
              HasSubstr("JPEG image is damaged"));
}

TEST(ImageSize, ReadsBigEndianTiffByHand) {
  // MM, one directory at 8: width 3, height 2 (SHORT), one strip of 6 bytes at offset 70.
  std::string t("MM\0*\0\0\0\x08\0\x04", 10);
  const auto entry = [&](char tag, const std::string& count_and_value, char type) {
    t += std::string("\x01", 1) + tag + std::string(1, '\0') + type + count_and_value;
  };
  entry('\x00', std::string("\0\0\0\x01\0\x03\0\0", 8), 3);
  entry('\x01', std::string("\0\0\0\x01\0\x02\0\0", 8), 3);
  entry('\x11', std::string("\0\0\0\x01\0\0\0\x46", 8), 4);
  entry('\x17', std::string("\0\0\0\x01\0\0\0\x06", 8), 4);
  t.resize(76, '\0');
  const auto size = imageSize(t, "x");
  ASSERT_TRUE(size.has_value()) << size.error().sentence();
  EXPECT_EQ(*size, (ImageSize{3, 2}));
  EXPECT_THAT(imageSize(std::string_view(t).substr(0, 75), "x").error().what,
              HasSubstr("truncated"));
}

TEST(ImageSize, RefusesWhatIsNoImage) {
  EXPECT_THAT(imageSize("", "x").error().what, HasSubstr("empty"));
  EXPECT_THAT(imageSize("GIF89a...", "x").error().what, HasSubstr("Not a JPEG, PNG, TIFF"));
}

TEST(ImageSize, RefusesALyingSize) {
  std::string png = encoded(".png", 8, 8);
  png.replace(16, 4, "\x7F\xFF\xFF\xFF");
  EXPECT_THAT(imageSize(png, "x").error().what, HasSubstr("states a size"));
}

}  // namespace
}  // namespace ostraka::images
