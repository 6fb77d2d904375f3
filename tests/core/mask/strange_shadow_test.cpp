#include "mask/strange_shadow.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace ostraka::mask {
namespace {

// 20 x 20 samples of 2 mm: 6 mm around a sherd are three samples. OpenCV's ellipse of 7 x 7 has
// rows of 1, 5, 7, 7, 7, 5, 1 samples: 33 that do not count, 367 that do.
class Darkened : public testing::Test {
 protected:
  double share(int reduction = 1) const {
    return darkenedShare(residual, group, plate, reduction, 2.0 / reduction);
  }
  cv::Mat3f residual = cv::Mat3f::zeros(20, 20);
  cv::Mat1b group = cv::Mat1b::zeros(20, 20);
  cv::Mat1b plate = cv::Mat1b(20, 20, std::uint8_t{255});
};

TEST_F(Darkened, IsTheShareOfTheBarePlateThatLacksAFifthOfItsLight) {
  group(10, 10) = 1;
  EXPECT_EQ(share(), 0);
  residual.rowRange(0, 5).setTo(cv::Scalar::all(-0.26));  // exp(-0.26) = 0.77
  EXPECT_NEAR(share(), 100.0 / 367, 1e-9);
  residual.rowRange(0, 5).setTo(cv::Scalar::all(-0.24));  // exp(-0.24) = 0.79
  EXPECT_EQ(share(), 0);
  residual.rowRange(0, 5).setTo(cv::Scalar::all(0.5));
  EXPECT_EQ(share(), 0) << "a light patch is no shadow";
}

TEST_F(Darkened, LeavesOutWhatLiesBesideASherdOrBesideThePlate) {
  group(10, 10) = 1;
  residual.rowRange(9, 12).colRange(8, 13).setTo(cv::Scalar::all(-2));
  EXPECT_EQ(share(), 0) << "the sherd's own shadow";
  plate.rowRange(0, 10).setTo(0);
  residual.rowRange(0, 10).setTo(cv::Scalar::all(-2));
  EXPECT_NEAR(share(), 0, 1e-9);
  residual.row(19).setTo(cv::Scalar::all(-1));
  // Ten rows are left, less the ellipse's lower four: 7, 7, 5, 1.
  EXPECT_NEAR(share(), 20.0 / (200 - 20), 1e-9);
}

TEST_F(Darkened, LooksAtOnePixelOfEachSample) {
  residual = cv::Mat3f::zeros(40, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 20; ++x) residual(y, x) = cv::Vec3f::all(-1);
  EXPECT_NEAR(share(2), 0.5, 1e-9);
}

TEST_F(Darkened, IsNothingWhereNoPlateIsBare) {
  residual.setTo(cv::Scalar::all(-3));
  group.setTo(1);
  EXPECT_EQ(share(), 0);
}

TEST(StrangeShadows, AreAllNamedHoweverManyThereAre) {
  EXPECT_NE(warningOf({{"cam0_pos03.jpg", 12}})
                .english()
                .find("on the plate in cam0_pos03.jpg (12 % of the bare plate); keep"),
            std::string::npos);
  for (const int count : {2, 9, 10, 81, 82, 200}) {
    std::vector<StrangeShadow> shadows;
    std::string names;
    for (int i = 0; i < count; ++i) {
      shadows.push_back({"p" + std::to_string(i), i});
      names += (i > 0 ? ", p" : "p") + std::to_string(i) + " (" + std::to_string(i) +
               " % of the bare plate)";
    }
    EXPECT_NE(warningOf(shadows).english().find("on the plate in " + names + "; keep"),
              std::string::npos)
        << count;
  }
}

}  // namespace
}  // namespace ostraka::mask
