#include "mask/raised.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <random>

namespace ostraka::mask {
namespace {

constexpr double kHalf = 15, kTop = 6;  // a block of the plate's own colour, mm

/// Two photographs of a grey plate with a grey block on it: mottle of either strength.
struct Plane {
  batch::Plate plate;
  std::vector<rig::PosedImage> images;
  std::vector<cv::Mat> photographs;

  explicit Plane(double mottle) {
    plate.diameter_mm = 120;
    for (const double tilt : {0.7, 1.05}) {
      rig::PosedImage image;
      image.camera = static_cast<int>(images.size());
      image.intrinsics = {400, 300, 780, 780, 199.5, 149.5, {}};
      image.camera_from_plate.linear() =
          Eigen::AngleAxisd(M_PI / 2 + tilt, Eigen::Vector3d::UnitX()).matrix();
      image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 300);
      images.push_back(image);
      photographs.push_back(photograph(image, mottle));
    }
  }

  // Grains of 1.5 mm without any repetition, of mean 0.
  static double grain(double x, double y) {
    static const cv::Mat1f table = [] {
      cv::Mat1f values(256, 256);
      std::mt19937 random(3);
      for (float& value : values) value = std::uniform_real_distribution<float>(-1, 1)(random);
      return values;
    }();
    const double u = x / 1.5 + 128, v = y / 1.5 + 128;
    const int c = static_cast<int>(u), r = static_cast<int>(v);
    const double a = u - c, b = v - r;
    return (table(r, c) * (1 - a) + table(r, c + 1) * a) * (1 - b) +
           (table(r + 1, c) * (1 - a) + table(r + 1, c + 1) * a) * b;
  }

  static cv::Mat photograph(const rig::PosedImage& image, double mottle) {
    std::mt19937 random(7 + image.camera);
    std::normal_distribution<double> noise(0, 1);
    const Eigen::Isometry3d back = image.camera_from_plate.inverse();
    const Eigen::Vector3d eye = back.translation();
    cv::Mat photograph(300, 400, CV_8UC3);
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x) {
        const Eigen::Vector2d n =
            image.intrinsics.unproject({static_cast<double>(x), static_cast<double>(y)});
        const Eigen::Vector3d way = back.linear() * n.homogeneous();
        Eigen::Vector3d p = eye + (kTop - eye.z()) / way.z() * way;
        const bool top = std::max(std::abs(p.x()), std::abs(p.y())) < kHalf;
        if (!top) p = eye - eye.z() / way.z() * way;
        const double shift = top ? 40 : 0;  // another part of the grain
        const double value = 100 * (1 + mottle * grain(p.x() + shift, p.y() - shift));
        for (int c = 0; c < 3; ++c)
          photograph.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uchar>(value + noise(random));
      }
    return photograph;
  }

  std::vector<cv::Mat1f> weigh(std::size_t count = 2) const {
    const rig::PosedImage* posed[] = {&images[0], &images[1]};
    const cv::Mat* shots[] = {&photographs[0], &photographs[1]};
    return weighHeights(std::span(posed).first(count), std::span(shots).first(count), plate, 80);
  }

  // Mean odds over a square of plate points at a height, as image i sees them.
  double mean(const cv::Mat1f& odds, std::size_t i, const Eigen::Vector3d& middle,
              double half) const {
    double sum = 0;
    int count = 0;
    for (double dx = -half; dx <= half; dx += 0.5)
      for (double dy = -half; dy <= half; dy += 0.5, ++count) {
        const Eigen::Vector2d p = images[i].project(middle + Eigen::Vector3d(dx, dy, 0));
        sum += odds(static_cast<int>(p.y() / 2), static_cast<int>(p.x() / 2));
      }
    return sum / count;
  }
};

TEST(WeighHeights, TellABlockFromThePlateOfTheSameColour) {
  const Plane scene(0.25);
  const std::vector<cv::Mat1f> odds = scene.weigh();
  ASSERT_EQ(odds.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(odds[i].size(), cv::Size(200, 150));
    EXPECT_GT(scene.mean(odds[i], i, {0, 0, kTop}, 8), 2) << "photograph " << i;
    EXPECT_LT(scene.mean(odds[i], i, {38, 0, 0}, 8), -1) << "photograph " << i;
  }
}

TEST(WeighHeights, DoNotReachBeyondTheBlock) {
  const Plane scene(0.25);
  const std::vector<cv::Mat1f> odds = scene.weigh();
  for (std::size_t i = 0; i < 2; ++i)
    for (double along = -10; along <= 10; along += 0.5) {
      // To the sides, where neither photograph has the block before the plate.
      const Eigen::Vector2d p = scene.images[i].project({kHalf + 2, along, 0});
      EXPECT_LE(odds[i](static_cast<int>(p.y() / 2), static_cast<int>(p.x() / 2)), 0.F);
    }
}

TEST(WeighHeights, SayNothingWhereThereIsNoTexture) {
  const Plane scene(0);
  const std::vector<cv::Mat1f> odds = scene.weigh();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(scene.mean(odds[i], i, {0, 0, kTop}, 8), 0, 0.2);
    EXPECT_NEAR(scene.mean(odds[i], i, {38, 0, 0}, 8), 0, 0.2);
  }
}

TEST(WeighHeights, SayNothingOfOnePhotograph) {
  const Plane scene(0.25);
  const std::vector<cv::Mat1f> odds = scene.weigh(1);
  ASSERT_EQ(odds.size(), 1U);
  EXPECT_EQ(cv::countNonZero(odds[0]), 0);
}

TEST(WeighHeights, TakeCellsOfTwoPixelsButNoFinerOnesThanThePlatesPictureHas) {
  const Plane scene(0);
  EXPECT_DOUBLE_EQ(sweepPitch_mm(scene.images[0], scene.plate), 2 * 300.0 / 780);
  // From 40 mm, on a sheet of half a metre: cells of 0.1 mm would be 24 million to a photograph.
  rig::PosedImage near = scene.images[0];
  near.camera_from_plate.translation().z() = 40;
  batch::Plate sheet;
  sheet.diameter_mm = 500;
  EXPECT_DOUBLE_EQ(sweepPitch_mm(near, sheet), 500.0 / 1600);
}

TEST(HeightsInTheLight, SayNothingInADeepShadow) {
  // From left to right all of the plate's light, a half, a quarter, a tenth.
  cv::Mat3f residual(2, 8);
  constexpr float kLight[] = {1, 0.5F, 0.25F, 0.1F};
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 8; ++x) residual(y, x) = cv::Vec3f::all(std::log(kLight[x / 2]));
  const cv::Mat1f odds = heightsInTheLight(cv::Mat1f(1, 4, 3.F), residual);
  ASSERT_EQ(odds.size(), cv::Size(8, 2));
  EXPECT_FLOAT_EQ(odds(0, 1), 3);
  EXPECT_FLOAT_EQ(odds(1, 3), 3);
  EXPECT_NEAR(odds(0, 5), 2, 1e-5);  // 2 - 4 / 3 of it
  EXPECT_FLOAT_EQ(odds(1, 7), 0);
}

}  // namespace
}  // namespace ostraka::mask
