#include "mask/plate_agreement.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ostraka::mask {
namespace {

rig::PosedImage lookingDown(double tilt) {
  rig::PosedImage image;
  image.intrinsics = {40, 30, 60, 60, 19.5, 14.5, {}};
  image.camera_from_plate.linear() =
      Eigen::AngleAxisd(M_PI - tilt, Eigen::Vector3d::UnitX()).matrix();
  image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 300);
  return image;
}

struct Pair {
  rig::PosedImage own = lookingDown(0.3), other = lookingDown(0.8);
  cv::Mat3f own_residual = cv::Mat3f(30, 40, cv::Vec3f::all(-0.5F));
  cv::Mat3f other_residual = own_residual.clone();
  cv::Mat1b allowed = cv::Mat1b(30, 40, uchar{255});
  cv::Mat1f log_odds = cv::Mat1f(30, 40, 1.F);

  // At the pixel that sees the plate's centre.
  float weigh(bool bare) {
    const std::array<PlateView, 1> others{PlateView{&other, &other_residual}};
    weighAgreement(
        {&own, &own_residual}, others, [bare](double, double) { return bare; }, allowed, log_odds);
    return log_odds(15, 20);
  }
};

TEST(PlateAgreement, TheSameDarkeningInBothCamerasIsAShadow) {
  EXPECT_FLOAT_EQ(Pair().weigh(true), 1 - 6);  // the most that a pair may say
}

TEST(PlateAgreement, LitPlateInTheOtherCameraSpeaksForASherd) {
  Pair pair;
  pair.other_residual.setTo(0);
  // What is left is that something hides the plate from the other camera, three times in ten.
  EXPECT_NEAR(pair.weigh(true), 1 - std::log(0.3), 1e-3);
}

TEST(PlateAgreement, SaysNothingWhereASherdMayStand) {
  EXPECT_EQ(Pair().weigh(false), 1);
}

TEST(PlateAgreement, SaysNothingOutsideTheAllowedPart) {
  Pair pair;
  pair.allowed.setTo(0);
  EXPECT_EQ(pair.weigh(true), 1);
}

TEST(PlateAgreement, SaysNothingOfLitPixels) {
  Pair pair;
  pair.own_residual.setTo(0.2F);
  EXPECT_EQ(pair.weigh(true), 1);
}

}  // namespace
}  // namespace ostraka::mask
