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
  cv::Mat1b own_hull = cv::Mat1b(7, 10, uchar{0}), other_hull = own_hull.clone();

  // At the pixel that sees the plate's centre.
  float weigh(bool bare) {
    const std::array<PlateView, 1> others{PlateView{&other, &other_residual, &other_hull, 4}};
    weighAgreement(
        {&own, &own_residual, &own_hull, 4}, others, [bare](double, double) { return bare; },
        allowed, log_odds);
    return log_odds(15, 20);
  }
};

TEST(PlateAgreement, TheSameDarkeningInBothCamerasIsAShadow) {
  // Equal residuals of -0.5: 1 / ((2 pi)^1.5 sqrt(0.0034) 0.001025) = 1062 against a shadow of any
  // depth, 0.2 / (3 * 2 pi * 0.001525) = 6.96, and a sherd, 0.066.
  EXPECT_NEAR(Pair().weigh(true), 1 - std::log(0.03 + 0.97 * 1062 / 7.02), 0.01);
}

TEST(PlateAgreement, LitPlateInTheOtherCameraSpeaksForASherd) {
  Pair pair;
  pair.other_residual.setTo(0);
  // What is left is that the line of sight was not open after all, three times in a hundred.
  EXPECT_NEAR(pair.weigh(true), 1 - std::log(0.03), 1e-3);
}

TEST(PlateAgreement, LitPlateBesideLitPlateIsHardlyNews) {
  Pair pair;
  pair.own_residual.setTo(0);
  pair.other_residual.setTo(0);
  // Half of all that a camera sees is lit plate, so the second witness counts twice at most.
  EXPECT_NEAR(pair.weigh(true), 1 - std::log(2), 0.05);
}

TEST(PlateAgreement, ACameraThatMaySeeASherdInsteadIsNoWitness) {
  Pair pair;
  pair.other_hull.setTo(3);
  EXPECT_EQ(pair.weigh(true), 1);
}

TEST(PlateAgreement, SaysNothingWhereEitherPhotographDoesNotKnowThePlate) {
  const cv::Mat1b known(7, 10, uchar{255}), unknown(7, 10, uchar{0});
  const auto weighed = [](const cv::Mat1b* own_plate, const cv::Mat1b* other_plate) {
    Pair pair;
    const std::array<PlateView, 1> others{
        PlateView{&pair.other, &pair.other_residual, &pair.other_hull, 4, {}, other_plate}};
    weighAgreement(
        {&pair.own, &pair.own_residual, &pair.own_hull, 4, {}, own_plate}, others,
        [](double, double) { return true; }, pair.allowed, pair.log_odds);
    return pair.log_odds(15, 20);
  };
  EXPECT_EQ(weighed(&unknown, &known), 1);
  EXPECT_EQ(weighed(&known, &unknown), 1);
  EXPECT_EQ(weighed(&known, &known), Pair().weigh(true));
}

TEST(PlateAgreement, SaysNothingWhereASherdMayStand) {
  EXPECT_EQ(Pair().weigh(false), 1);
}

TEST(PlateAgreement, SaysNothingOutsideTheAllowedPart) {
  Pair pair;
  pair.allowed.setTo(0);
  EXPECT_EQ(pair.weigh(true), 1);
}

}  // namespace
}  // namespace ostraka::mask
