#include "batch/jpeg_image.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace ostraka::batch {
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

Result<cv::Mat> decodedOf(const std::string& bytes, int channels = 3) {
  return decodeJpeg(bytes, kSize, channels, "a.jpg");
}

TEST(DecodeJpeg, GivesTheValuesThatOpenCvGives) {
  for (const std::vector<int>& form : kForms)
    for (const int channels : {1, 3}) {
      const std::string bytes = jpegOf(form, channels);
      const std::vector<unsigned char> raw(bytes.begin(), bytes.end());
      for (const int wanted : {1, 3}) {
        const Result<cv::Mat> image = decodedOf(bytes, wanted);
        ASSERT_TRUE(image.has_value()) << image.error().sentence();
        const cv::Mat by_opencv =
            cv::imdecode(raw, wanted == 1 ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
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
  EXPECT_FALSE(decodeJpeg(bytes, {kSize.width + 1, kSize.height}, 3, "a.jpg").has_value());
  EXPECT_FALSE(decodedOf("\xFF\xD8\xFF\xD9").has_value());
}

}  // namespace
}  // namespace ostraka::batch
