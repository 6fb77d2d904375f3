#include "mask/masks.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace ostraka::mask {
namespace {

class CheckedViews : public testing::Test {
 protected:
  CheckedViews() {
    for (int i = 0; i < 3; ++i) {
      rig::PosedImage image;
      image.file = "cam0_pos0" + std::to_string(i) + ".jpg";
      image.intrinsics.width = 40;
      image.intrinsics.height = 30;
      images.push_back(image);
      photographs.emplace_back(30, 40, CV_8UC3, cv::Scalar::all(0));
    }
  }
  Result<void> checked() const {
    return checkViews(images, photographs, message("Take more photographs."));
  }
  std::vector<rig::PosedImage> images;
  std::vector<cv::Mat> photographs;
};

TEST_F(CheckedViews, PassWhereEachPhotographFitsItsCamera) {
  EXPECT_TRUE(checked());
}

TEST_F(CheckedViews, SayHowManyPosesAndPhotographsThereAre) {
  photographs.pop_back();
  const Result<void> refused = checked();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(refused.error().what.english(),
            "3 poses are given for 2 photographs; give one pose for each.");
}

TEST_F(CheckedViews, OfTwoAreTooFewWithTheCallersSentence) {
  photographs.pop_back();
  images.pop_back();
  const Result<void> refused = checked();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::NotEnough);
  EXPECT_EQ(refused.error().what.english(), "Take more photographs.");
}

TEST_F(CheckedViews, NameThePhotographThatIsTurnedOrReducedOrGrey) {
  const cv::Mat wrong[] = {cv::Mat(40, 30, CV_8UC3), cv::Mat(15, 20, CV_8UC3),
                           cv::Mat(30, 40, CV_8UC1), cv::Mat(30, 40, CV_16UC3), cv::Mat()};
  for (const cv::Mat& photograph : wrong) {
    photographs[1] = photograph;
    const Result<void> refused = checked();
    ASSERT_FALSE(refused) << photograph.size() << " " << photograph.type();
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, "cam0_pos01.jpg");
  }
}

}  // namespace
}  // namespace ostraka::mask
