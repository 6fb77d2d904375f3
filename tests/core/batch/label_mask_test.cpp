#include "batch/label_mask.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "batch_folder.h"

namespace ostraka::batch {
namespace {

class ReadLabelMask : public testing::Test {
 protected:
  // The mask of a picture that was written as `name`.
  cv::Mat1b maskOf(const std::string& name, const cv::Mat& picture) const {
    cv::imwrite((folder_.path() / name).string(), picture);
    const Result<cv::Mat1b> mask = readLabelMask(folder_.path() / name);
    EXPECT_TRUE(mask.has_value()) << mask.error().sentence();
    return mask ? *mask : cv::Mat1b();
  }
  static int inside(const cv::Mat1b& mask) { return mask.empty() ? -1 : cv::countNonZero(mask); }

  BatchFolder folder_;
};

TEST_F(ReadLabelMask, AnyLabelIsInsideHoweverDark) {
  cv::Mat1b labels(4, 5, uchar{0});
  labels(1, 2) = 1;
  labels(3, 4) = 200;
  const cv::Mat1b mask = maskOf("labels.png", labels);
  ASSERT_EQ(inside(mask), 2);
  EXPECT_EQ(mask(1, 2), 255);
  EXPECT_EQ(mask(3, 4), 255);
  cv::Mat1w wide(4, 5, ushort{0});
  wide(0, 0) = 1;  // vanishes in 8 bits
  EXPECT_EQ(inside(maskOf("wide.png", wide)), 1);
}

TEST_F(ReadLabelMask, AnAlphaChannelCountsAloneUnlessItIsTheSameAllOver) {
  cv::Mat4b cut(4, 5, cv::Vec4b(90, 90, 90, 0));
  cut(2, 2) = cv::Vec4b(0, 0, 0, 255);
  EXPECT_EQ(inside(maskOf("cut.png", cut)), 1);
  cv::Mat4b opaque(4, 5, cv::Vec4b(0, 0, 0, 255));
  opaque(0, 1) = cv::Vec4b(0, 0, 255, 255);
  opaque(0, 2) = cv::Vec4b(255, 0, 0, 255);
  EXPECT_EQ(inside(maskOf("opaque.png", opaque)), 2);
}

TEST_F(ReadLabelMask, InAJpegWhatIsNearerToWhiteIsInside) {
  cv::Mat1b grey(16, 16, uchar{30});
  grey.colRange(8, 16).setTo(220);  // blocks of 8 pixels: no ringing from one into the other
  EXPECT_EQ(inside(maskOf("grey.jpg", grey)), 8 * 16);
}

TEST_F(ReadLabelMask, WhatIsNoPictureIsUnusable) {
  folder_.write("text.png", "label");
  const Result<cv::Mat1b> mask = readLabelMask(folder_.path() / "text.png");
  ASSERT_FALSE(mask.has_value());
  EXPECT_EQ(mask.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::batch
