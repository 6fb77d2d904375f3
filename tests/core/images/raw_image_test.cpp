// DNG files put together by hand after Adobe's specification 1.4: a sensor's values, uncompressed.
#include "images/raw_image.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "batch/exif.h"
#include "batch/photograph.h"
#include "images/decode.h"
#include "tests/core/batch/batch_folder.h"

namespace ostraka::images {
namespace {

using testing::HasSubstr;

enum class Dng { Byte = 1, Ascii = 2, Short = 3, Long = 4, Rational = 5, SignedRational = 10 };

std::string little(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xFF);
  return text;
}

struct DngField {
  int tag;
  Dng type;
  std::uint32_t count;
  std::string value;
};

// A red, green, green, blue sensor of 16 bits, orientation 6 ("turn by 90 degrees"), with its
// values as the file has them. TIFF's compression 1 is none, 7 a lossless JPEG.
std::string dngOf(int width, int height, int compression, const std::string& sensels) {
  const auto shorts = [](std::initializer_list<int> values) {
    std::string text;
    for (const int v : values) text += little(static_cast<std::uint64_t>(v), 2);
    return text;
  };
  std::string ones, identity;
  for (int i = 0; i < 3; ++i) ones += little(1, 4) + little(1, 4);
  for (int i = 0; i < 9; ++i) identity += little(i % 4 == 0 ? 1 : 0, 4) + little(1, 4);
  const std::string model = std::string("Made by hand") + '\0';
  std::vector<DngField> fields{
      {254, Dng::Long, 1, little(0, 4)},
      {256, Dng::Long, 1, little(static_cast<std::uint64_t>(width), 4)},
      {257, Dng::Long, 1, little(static_cast<std::uint64_t>(height), 4)},
      {258, Dng::Short, 1, shorts({16})},
      {259, Dng::Short, 1, shorts({compression})},
      {262, Dng::Short, 1, shorts({32803})},  // colour filter array
      {271, Dng::Ascii, 13, model},
      {272, Dng::Ascii, 13, model},
      {273, Dng::Long, 1, {}},  // where the strip is; below
      {274, Dng::Short, 1, shorts({6})},
      {277, Dng::Short, 1, shorts({1})},
      {278, Dng::Long, 1, little(static_cast<std::uint64_t>(height), 4)},
      {279, Dng::Long, 1, little(sensels.size(), 4)},
      {284, Dng::Short, 1, shorts({1})},
      {33421, Dng::Short, 2, shorts({2, 2})},
      {33422, Dng::Byte, 4, std::string("\0\1\1\2", 4)},
      {50706, Dng::Byte, 4, std::string("\1\4\0\0", 4)},
      {50708, Dng::Ascii, 13, model},
      {50714, Dng::Short, 1, shorts({0})},
      {50717, Dng::Short, 1, shorts({65535})},
      {50721, Dng::SignedRational, 9, identity},
      {50728, Dng::Rational, 3, ones},
      {50778, Dng::Short, 1, shorts({21})},
  };
  const std::size_t behind_at = 8 + 2 + 12 * fields.size() + 4;
  std::size_t behind_size = 0;
  for (const DngField& f : fields) behind_size += f.value.size() > 4 ? f.value.size() : 0;
  std::string head = "II" + little(42, 2) + little(8, 4) + little(fields.size(), 2), behind;
  for (DngField& f : fields) {
    if (f.tag == 273) f.value = little(behind_at + behind_size, 4);
    head += little(static_cast<std::uint64_t>(f.tag), 2) +
            little(static_cast<std::uint64_t>(f.type), 2) + little(f.count, 4);
    if (f.value.size() > 4) {
      head += little(behind_at + behind.size(), 4);
      behind += f.value;
    } else {
      head += f.value + std::string(4 - f.value.size(), '\0');
    }
  }
  return head + little(0, 4) + behind + sensels;
}

// The left half saw `left` on all sensels, the right half `right`.
std::string dng(int width, int height, int left, int right) {
  std::string values;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      values += little(static_cast<std::uint64_t>(x < width / 2 ? left : right), 2);
  return dngOf(width, height, 1, values);
}

// A lossless JPEG (ITU-T T.81, process 14) of 65535 x 65535 values, each of one bit: no difference.
// They end after `bytes` of these.
std::string losslessJpeg(std::size_t bytes) {
  const std::string header("\xFF\xD8\xFF\xC3\0\x0B\x10\xFF\xFF\xFF\xFF\1\x11\0\0", 15);
  const std::string codes =
      std::string("\xFF\xC4\0\x14\0\1", 6) + std::string(15, '\0') + std::string(1, '\0');
  return header + codes + std::string("\xFF\xDA\0\x08\1\0\0\1\0\0", 10) + std::string(bytes, '\0');
}

TEST(RawImage, IsDevelopedWithoutTurningOrBrighteningIt) {
  // Half of the light that the sensor can hold is shown as 188 (sRGB), a tenth as 89.
  const std::string bytes = dng(160, 120, 32768, 6554);
  const auto size = imageSize(bytes, "a.DNG");
  ASSERT_TRUE(size.has_value()) << size.error().sentence();
  EXPECT_EQ(*size, (ImageSize{160, 120}));
  const auto image = decodeImage(bytes, Values::Bgr, "a.DNG");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  ASSERT_EQ(image->size(), cv::Size(160, 120));
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(image->at<cv::Vec3b>(60, 40)[c], 188, 2);
    EXPECT_NEAR(image->at<cv::Vec3b>(60, 120)[c], 89, 2);
  }
}

TEST(RawImage, OfAFileIsReadByItsEnding) {
  const batch::BatchFolder folder;
  folder.write("a.dng", dng(160, 120, 32768, 6554));
  const auto image = batch::readPhotograph(folder.path() / "a.dng");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_EQ(image->cols, 160);
  EXPECT_EQ(batch::readExif(folder.path() / "a.dng").make, "Made by hand");
  EXPECT_TRUE(hasRawEnding("IMG_1.CR2"));
  EXPECT_FALSE(hasRawEnding("a.tif"));
}

TEST(RawImage, IsRecognisedAsCutOff) {
  const std::string whole = dng(160, 120, 32768, 6554);
  for (const double share : {0.05, 0.3, 0.6, 0.95}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    const auto size = imageSize(whole.substr(0, length), "a.dng");
    ASSERT_FALSE(size.has_value()) << share;
    EXPECT_EQ(size.error().code, ErrorCode::UnusableInput);
  }
}

TEST(RawImage, ThatStatesMorePixelsThanItsBytesHoldIsCutOffAtOnce) {
  const auto began = std::chrono::steady_clock::now();
  // 360 million pixels in 200 bytes; and in a million, where unpacking meets the end of the file.
  for (const std::size_t bytes : {200u, 1'000'000u})
    for (const auto& error :
         {imageSize(dngOf(60000, 6000, 7, losslessJpeg(bytes)), "a.dng").error(),
          decodeImage(dngOf(60000, 6000, 7, losslessJpeg(bytes)), Values::Bgr, "a.dng").error()})
      EXPECT_THAT(error.what, HasSubstr("truncated")) << bytes;
  // Unpacked to the end, each takes 6 s.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(3));
}

TEST(RawImage, GivesItsSizeWithoutUnpackingWhereItStatesTheLengthOfItsValues) {
  // 6,000 bytes of a lossless JPEG for 64 x 48 pixels of 16 bits: more than half; none are missing.
  std::string damaged = dngOf(64, 48, 7, losslessJpeg(6000));
  const auto jpeg = damaged.find("\xFF\xD8\xFF\xC3");
  damaged[jpeg] = 'x';
  EXPECT_EQ(*imageSize(damaged, "a.dng"), (ImageSize{64, 48}));
  EXPECT_FALSE(decodeImage(damaged, Values::Bgr, "a.dng").has_value());
}

TEST(RawImage, OfAnotherKindIsRefused) {
  for (const char* bytes : {"", "no image", "II*"}) {
    const auto image = decodeImage(bytes, Values::Bgr, "a.nef");
    ASSERT_FALSE(image.has_value());
    EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
  }
}

TEST(RawImage, SurvivesChangedBytes) {
  const std::string whole = dng(64, 48, 32768, 6554);
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    std::string damaged = whole;
    for (int k = 0; k < 4; ++k)
      damaged[random() % std::min<std::size_t>(damaged.size(), 420)] = static_cast<char>(random());
    const auto image = decodeImage(damaged, Values::Bgr, "a.dng");
    if (!image) {
      EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
    }
  }
}

}  // namespace
}  // namespace ostraka::images
