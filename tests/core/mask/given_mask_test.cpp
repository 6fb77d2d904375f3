#include "mask/given_mask.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

namespace ostraka::mask {
namespace {

class GivenMask : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("given_mask_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path written(const cv::Mat& picture) {
    const std::filesystem::path path = folder_ / "mask.png";
    cv::imwrite(path.string(), picture);
    return path;
  }
  std::filesystem::path folder_;
};

TEST_F(GivenMask, EveryLabelOtherThanZeroIsInside) {
  cv::Mat1b labels(2, 3, uchar{0});
  labels(0, 1) = 1;
  labels(1, 2) = 8;
  const auto mask = readGivenMask(written(labels), 3, 2);
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ((*mask)(0, 1), 255);
  EXPECT_EQ((*mask)(1, 2), 255);
  EXPECT_EQ(cv::countNonZero(*mask), 2);
}

TEST_F(GivenMask, SixteenBitLabelsAboveAByteAreInside) {
  cv::Mat1w labels(2, 2, ushort{0});
  labels(1, 0) = 256;
  const auto mask = readGivenMask(written(labels), 2, 2);
  ASSERT_TRUE(mask.has_value());
  EXPECT_EQ((*mask)(1, 0), 255);
  EXPECT_EQ(cv::countNonZero(*mask), 1);
}

// A JPEG's ringing makes greys of 1 to 30 outside of a hard edge.
TEST_F(GivenMask, AJpegEndsAtItsEdgeAndNotWhereItRings) {
  cv::Mat1b truth(120, 160, uchar{0});
  truth(cv::Rect(43, 37, 70, 50)) = 255;
  const std::filesystem::path path = folder_ / "mask.jpg";
  cv::imwrite(path.string(), truth, {cv::IMWRITE_JPEG_QUALITY, 70});
  const auto mask = readGivenMask(path, 160, 120);
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ(cv::countNonZero(*mask != truth), 0);
}

TEST_F(GivenMask, AnAlphaChannelCountsAlone) {
  cv::Mat4b picture(1, 2, cv::Vec4b(9, 9, 9, 0));
  picture(0, 1)[3] = 255;
  const auto mask = readGivenMask(written(picture), 2, 1);
  ASSERT_TRUE(mask.has_value());
  EXPECT_EQ((*mask)(0, 0), 0);
  EXPECT_EQ((*mask)(0, 1), 255);
}

TEST_F(GivenMask, AnOpaqueAlphaChannelLeavesTheLabelsToTheColours) {
  cv::Mat4b picture(1, 2, cv::Vec4b(0, 0, 0, 255));
  picture(0, 1)[1] = 3;
  const auto mask = readGivenMask(written(picture), 2, 1);
  ASSERT_TRUE(mask.has_value());
  EXPECT_EQ((*mask)(0, 0), 0);
  EXPECT_EQ((*mask)(0, 1), 255);
}

TEST_F(GivenMask, AMissingFileIsNamedWithWhatWasExpected) {
  const auto mask = readGivenMask(folder_ / "none.png", 40, 30);
  ASSERT_FALSE(mask.has_value());
  EXPECT_EQ(mask.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(mask.error().sentence(),
              testing::AllOf(testing::HasSubstr("none.png"), testing::HasSubstr("40 x 30")));
}

TEST_F(GivenMask, AWrongSizeIsNamedWithWhatWasExpected) {
  const auto mask = readGivenMask(written(cv::Mat1b(5, 7, uchar{1})), 40, 30);
  ASSERT_FALSE(mask.has_value());
  EXPECT_THAT(mask.error().sentence(),
              testing::AllOf(testing::HasSubstr("mask.png"), testing::HasSubstr("7 x 5"),
                             testing::HasSubstr("40 x 30")));
}

TEST_F(GivenMask, ATruncatedFileIsAnError) {
  std::ofstream(folder_ / "mask.png") << "\x89PNG\r\n";
  const auto mask = readGivenMask(folder_ / "mask.png", 40, 30);
  ASSERT_FALSE(mask.has_value());
  EXPECT_EQ(mask.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::mask
