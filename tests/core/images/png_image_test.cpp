#include "images/png_image.h"

#include <gmock/gmock.h>
#include <png.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace ostraka::images {
namespace {

// Noise that is smoothed a little, as a photograph's is.
cv::Mat pictureOf(int type, cv::Size size = {61, 37}) {
  cv::Mat picture(size, type);
  cv::RNG random(7);
  random.fill(picture, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(type) == CV_16U ? 65535 : 255);
  cv::GaussianBlur(picture, picture, {5, 5}, 1.0);
  return picture;
}

// As libpng writes what OpenCV does not: rows as the kind wants them, interlaced.
std::string pngOf(int kind, int bits, bool with_transparency) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp job, png_bytep from, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(job))
            ->append(reinterpret_cast<const char*>(from), count);
      },
      nullptr);
  constexpr int kWidth = 24, kHeight = 17;
  png_set_IHDR(png, info, kWidth, kHeight, bits, kind, PNG_INTERLACE_ADAM7,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::mt19937 random(3);
  std::vector<png_color> palette(std::size_t{1} << std::min(bits, 8));
  std::vector<png_byte> clear(palette.size(), 255);
  for (png_color& colour : palette)
    colour = {static_cast<png_byte>(random()), static_cast<png_byte>(random()),
              static_cast<png_byte>(random())};
  clear[1] = 0;
  png_color_16 one{};
  if (kind == PNG_COLOR_TYPE_PALETTE)
    png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  if (with_transparency && kind == PNG_COLOR_TYPE_PALETTE)
    png_set_tRNS(png, info, clear.data(), 2, nullptr);
  else if (with_transparency)
    png_set_tRNS(png, info, nullptr, 0, &one);
  png_write_info(png, info);
  std::vector<std::vector<png_byte>> rows(kHeight,
                                          std::vector<png_byte>(png_get_rowbytes(png, info)));
  std::vector<png_bytep> pointers;
  for (std::vector<png_byte>& row : rows) {
    for (png_byte& value : row) value = static_cast<png_byte>(random());
    pointers.push_back(row.data());
  }
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

void expectOpenCvsValues(const std::string& bytes, const std::string& what) {
  const std::vector<unsigned char> raw(bytes.begin(), bytes.end());
  for (const auto& [values, flags] :
       {std::pair(Values::Bgr, cv::IMREAD_COLOR), std::pair(Values::Grey, cv::IMREAD_GRAYSCALE),
        std::pair(Values::AsStored, cv::IMREAD_UNCHANGED)}) {
    const Result<cv::Mat> image = decodePng(bytes, values, "a.png");
    ASSERT_TRUE(image.has_value()) << what << image.error().sentence();
    const cv::Mat by_opencv = cv::imdecode(raw, flags);
    ASSERT_EQ(image->type(), by_opencv.type()) << what << flags;
    ASSERT_EQ(image->size(), by_opencv.size()) << what << flags;
    EXPECT_EQ(cv::norm(*image, by_opencv, cv::NORM_INF), 0) << what << flags;
  }
}

TEST(DecodePng, GivesTheValuesThatOpenCvGives) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3, CV_16UC4}) {
    std::vector<unsigned char> bytes;
    cv::imencode(".png", pictureOf(type), bytes);
    expectOpenCvsValues({bytes.begin(), bytes.end()}, "type " + std::to_string(type) + " ");
  }
}

TEST(DecodePng, DoesSoForEveryKindOfPng) {
  const std::vector<std::pair<int, std::vector<int>>> kinds = {
      {PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}},
      {PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}},
      {PNG_COLOR_TYPE_RGB, {8, 16}},
      {PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}},
      {PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}}};
  for (const auto& [kind, depths] : kinds)
    for (const int bits : depths)
      for (const bool with_transparency : {false, true}) {
        if (with_transparency && (kind & PNG_COLOR_MASK_ALPHA) != 0) continue;
        expectOpenCvsValues(pngOf(kind, bits, with_transparency),
                            "kind " + std::to_string(kind) + ", bits " + std::to_string(bits) +
                                (with_transparency ? ", tRNS " : " "));
      }
}

TEST(DecodePng, RefusesWhatIsDamagedWithoutReadingBeyondIt) {
  std::vector<unsigned char> raw;
  cv::imencode(".png", pictureOf(CV_8UC3), raw);
  const std::string whole(raw.begin(), raw.end());
  for (std::size_t length = 0; length < whole.size() - 12; length += 61)
    EXPECT_FALSE(decodePng(std::string_view(whole).substr(0, length), Values::Bgr, "a.png"));
  std::mt19937 random(5);
  for (int round = 0; round < 500; ++round) {
    std::string damaged = whole;
    for (int k = 0; k < 3; ++k) damaged[8 + random() % 400] = static_cast<char>(random());
    const Result<cv::Mat> image = decodePng(damaged, Values::AsStored, "a.png");
    if (!image) {
      EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
    }
  }
}

TEST(EncodedPng, GivesTheBytesThatOpenCvGives) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4})
    for (const int effort : {1, 3, 6}) {
      const cv::Mat picture = pictureOf(type);
      std::vector<unsigned char> by_opencv;
      cv::imencode(".png", picture, by_opencv, {cv::IMWRITE_PNG_COMPRESSION, effort});
      EXPECT_TRUE(encodedPng(picture, effort) == std::string(by_opencv.begin(), by_opencv.end()))
          << type << " " << effort;
    }
}

// 300 pixels an inch of 25.4 mm are 11,811 a metre (0x2E23).
TEST(EncodedPng, StatesItsResolution) {
  const std::string size("\0\0\x2E\x23", 4);
  EXPECT_THAT(encodedPng(pictureOf(CV_8UC1), 3, 300),
              testing::HasSubstr("pHYs" + size + size + '\1'));
  EXPECT_THAT(encodedPng(pictureOf(CV_8UC1)), testing::Not(testing::HasSubstr("pHYs")));
}

TEST(EncodedPng, TakesAPartOfALargerPicture) {
  const cv::Mat picture = pictureOf(CV_8UC3);
  const cv::Mat part = picture(cv::Rect(10, 5, 21, 13));
  EXPECT_EQ(encodedPng(part), encodedPng(part.clone()));
}

}  // namespace
}  // namespace ostraka::images
