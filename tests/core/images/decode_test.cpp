#include "images/decode.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "images/tiff_image.h"

namespace ostraka::images {
namespace {

// What the bytes are counts, not the name; but for RAW files, which only their name tells.
TEST(DecodeImage, TakesEachKindByItsBytes) {
  const cv::Mat picture(12, 16, CV_8UC3, cv::Scalar(40, 80, 120));
  for (const std::string& bytes :
       {encodedJpeg(picture, {.quality = 100}), encodedPng(picture), encodedTiff(picture, 300)}) {
    const Result<cv::Mat> image = decodeImage(bytes, Values::Bgr, "photograph");
    ASSERT_TRUE(image.has_value()) << image.error().sentence();
    EXPECT_LE(cv::norm(*image, picture, cv::NORM_INF), 2);
    const Result<cv::Mat> grey = decodeImage(bytes, Values::Grey, "photograph");
    ASSERT_TRUE(grey.has_value()) << grey.error().sentence();
    // 0.299 * 120 + 0.587 * 80 + 0.114 * 40 = 87.4
    EXPECT_NEAR(grey->at<uchar>(6, 8), 87, 2);
    EXPECT_FALSE(decodeImage(bytes, Values::Bgr, "photograph.nef").has_value());
  }
}

TEST(DecodeImage, RefusesOtherKindsAndWhatIsCutOff) {
  for (const char* text : {"", "GIF89a......", "BM", "P5 2 2 255 abcd"})
    EXPECT_FALSE(decodeImage(text, Values::Bgr, "a.png").has_value()) << text;
  const std::string png = encodedPng(cv::Mat(12, 16, CV_8UC3, cv::Scalar(40, 80, 120)));
  const Result<cv::Mat> cut =
      decodeImage(std::string_view(png).substr(0, png.size() - 5), Values::Bgr, "a.png");
  ASSERT_FALSE(cut.has_value());
  EXPECT_THAT(cut.error().sentence().english(), testing::HasSubstr("a.png: The image file is"));
}

}  // namespace
}  // namespace ostraka::images
