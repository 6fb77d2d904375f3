#include "images/jpeg_image.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include <jpeglib.h>  // after cstdio, which it leaves to its user

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace ostraka::images {
namespace {

constexpr ImageSize kSize{301, 205};  // neither is a multiple of a block

// Noise that is smoothed a little, as a photograph's is.
std::string jpegOf(std::vector<int> options, int channels = 3) {
  cv::Mat image(kSize.height, kSize.width, CV_8UC(channels));
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(image, image, {5, 5}, 1.0);
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(".jpg", image, bytes, options));
  return {bytes.begin(), bytes.end()};
}

const std::vector<std::vector<int>> kForms = {
    {cv::IMWRITE_JPEG_QUALITY, 98},
    {cv::IMWRITE_JPEG_QUALITY, 60},
    {cv::IMWRITE_JPEG_QUALITY, 85, cv::IMWRITE_JPEG_RST_INTERVAL, 4},
    {cv::IMWRITE_JPEG_QUALITY, 85, cv::IMWRITE_JPEG_PROGRESSIVE, 1},
    {cv::IMWRITE_JPEG_QUALITY, 85, cv::IMWRITE_JPEG_OPTIMIZE, 1}};

Result<cv::Mat> decodedOf(const std::string& bytes, Values values = Values::Bgr) {
  return decodeJpeg(bytes, kSize, values, "a.jpg");
}

TEST(DecodeJpeg, GivesTheValuesThatOpenCvGives) {
  for (const std::vector<int>& form : kForms)
    for (const int channels : {1, 3}) {
      const std::string bytes = jpegOf(form, channels);
      const std::vector<unsigned char> raw(bytes.begin(), bytes.end());
      for (const Values wanted : {Values::Grey, Values::Bgr, Values::AsStored}) {
        const Result<cv::Mat> image = decodedOf(bytes, wanted);
        ASSERT_TRUE(image.has_value()) << image.error().sentence();
        const cv::Mat by_opencv = cv::imdecode(raw, wanted == Values::Grey  ? cv::IMREAD_GRAYSCALE
                                                    : wanted == Values::Bgr ? cv::IMREAD_COLOR
                                                                            : cv::IMREAD_UNCHANGED);
        ASSERT_EQ(image->type(), by_opencv.type());
        EXPECT_EQ(cv::norm(*image, by_opencv, cv::NORM_INF), 0);
      }
    }
}

// As a bad cluster of a memory card leaves it.
TEST(DecodeJpeg, RefusesAnImageWithAHole) {
  for (const std::vector<int>& form : kForms) {
    std::string bytes = jpegOf(form);
    bytes.replace(bytes.size() / 2, bytes.size() / 6, bytes.size() / 6, '\0');
    const Result<cv::Mat> image = decodedOf(bytes);
    ASSERT_FALSE(image.has_value()) << testing::PrintToString(form);
    EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
    EXPECT_THAT(image.error().sentence().english(), testing::HasSubstr("a.jpg: The JPEG image is"));
  }
}

TEST(DecodeJpeg, TakesWhatCamerasFillUpBehindTheImage) {
  const std::string bytes = jpegOf({});
  for (const std::string& filling : {std::string(600, '\0'), std::string(36, 'x')}) {
    std::string filled = bytes;
    filled.insert(filled.size() - 2, filling);
    const Result<cv::Mat> image = decodedOf(filled);
    ASSERT_TRUE(image.has_value()) << image.error().sentence();
    EXPECT_EQ(cv::norm(*image, *decodedOf(bytes), cv::NORM_INF), 0);
  }
}

TEST(DecodeJpeg, RefusesAnImageOfAnotherSizeAndOneWithoutImage) {
  const std::string bytes = jpegOf({});
  EXPECT_FALSE(
      decodeJpeg(bytes, {kSize.width + 1, kSize.height}, Values::Bgr, "a.jpg").has_value());
  EXPECT_FALSE(decodedOf("\xFF\xD8\xFF\xD9").has_value());
}

TEST(EncodedJpeg, GivesTheBytesThatOpenCvGives) {
  for (const int channels : {1, 3})
    for (const int quality : {60, 85, 95}) {
      const Result<cv::Mat> image = decodedOf(jpegOf({}, channels), Values::AsStored);
      std::vector<unsigned char> by_opencv;
      cv::imencode(".jpg", *image, by_opencv, {cv::IMWRITE_JPEG_QUALITY, quality});
      EXPECT_TRUE(encodedJpeg(*image, {.quality = quality}) ==
                  std::string(by_opencv.begin(), by_opencv.end()))
          << channels << " " << quality;
    }
}

// A red that touches a blue: halved, their border is 2 pixels wide.
TEST(EncodedJpeg, KeepsColoursInFullWhereToldTo) {
  cv::Mat3b image(kSize.height, kSize.width, cv::Vec3b(0, 0, 255));
  image.colRange(151, kSize.width) = cv::Vec3b(255, 0, 0);
  const auto offBy = [&](bool halved) {
    const std::string bytes = encodedJpeg(image, {.quality = 100, .halved_colors = halved});
    return cv::norm(*decodedOf(bytes), image, cv::NORM_INF);
  };
  EXPECT_LE(offBy(false), 3);
  EXPECT_GE(offBy(true), 20);
}

// Four channels, which a printer's file holds as 255 less the ink: a full black, half a cyan.
TEST(DecodeJpeg, TurnsAPrintersInksIntoColours) {
  jpeg_compress_struct job;
  jpeg_error_mgr errors;
  job.err = jpeg_std_error(&errors);
  jpeg_create_compress(&job);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&job, &bytes, &size);
  job.image_width = 32;
  job.image_height = 16;
  job.input_components = 4;
  job.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&job);
  jpeg_set_quality(&job, 100, TRUE);
  jpeg_start_compress(&job, TRUE);
  std::vector<unsigned char> row;
  for (int x = 0; x < 32; ++x)
    row.insert(row.end(), {static_cast<unsigned char>(x < 16 ? 255 : 127), 255, 255,
                           static_cast<unsigned char>(x < 16 ? 0 : 255)});
  for (int y = 0; y < 16; ++y) {
    unsigned char* rows = row.data();
    jpeg_write_scanlines(&job, &rows, 1);
  }
  jpeg_finish_compress(&job);
  jpeg_destroy_compress(&job);
  const std::string file(reinterpret_cast<char*>(bytes), size);
  std::free(bytes);
  const Result<cv::Mat> image = decodeJpeg(file, {32, 16}, Values::Bgr, "a.jpg");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_LE(cv::norm(image->at<cv::Vec3b>(8, 2), cv::Vec3b(0, 0, 0), cv::NORM_INF), 2);
  EXPECT_LE(cv::norm(image->at<cv::Vec3b>(8, 28), cv::Vec3b(255, 255, 127), cv::NORM_INF), 2);
  const std::vector<unsigned char> raw(file.begin(), file.end());
  EXPECT_EQ(cv::norm(*image, cv::imdecode(raw, cv::IMREAD_COLOR), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace ostraka::images
