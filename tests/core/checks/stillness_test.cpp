#include "checks/stillness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace ostraka::checks {
namespace {

// Two flat sherds on a plate that turns under two cameras, eight stops.
class Stillness : public testing::Test {
 protected:
  static rig::PosedImage photograph(int camera, int stop) {
    rig::PosedImage image;
    image.camera = camera;
    image.stop = stop;
    image.intrinsics = {800, 600, 1000, 1000, 399.5, 299.5, {}};
    const double azimuth = 2 * std::numbers::pi * stop / 8, up = camera == 0 ? 0.6 : 1.1;
    const Eigen::Vector3d centre(500 * std::cos(up) * std::cos(azimuth),
                                 500 * std::cos(up) * std::sin(azimuth), 500 * std::sin(up));
    const Eigen::Vector3d z = -centre.normalized(),
                          x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << x.transpose(), z.cross(x).transpose(), z.transpose();
    image.camera_from_plate.linear() = axes;
    image.camera_from_plate.translation() = -axes * centre;
    return image;
  }

  // Points of an elliptic sherd, 6 mm thick; share: how much of it is kept around its middle.
  static std::vector<Eigen::Vector3d> sherd(const Eigen::Vector2d& middle, double share) {
    std::vector<Eigen::Vector3d> points;
    for (double r = 0.05; r <= share; r += 0.05)
      for (double t = 0; t < 2 * std::numbers::pi; t += 0.05)
        for (const double z : {0.0, 3.0, 6.0})
          points.emplace_back(middle.x() + 25 * r * std::cos(t), middle.y() + 16 * r * std::sin(t),
                              z);
    return points;
  }

  void shoot(const Eigen::Vector2d& push, int from_stop) {
    for (int stop = 0; stop < 8; ++stop)
      for (int camera = 0; camera < 2; ++camera) {
        images_.push_back(photograph(camera, stop));
        cv::Mat1b mask(600, 800, uchar{0});
        for (int k = 0; k < 2; ++k) {
          const bool pushed = k == 1 && stop >= from_stop;
          std::vector<cv::Point> pixels;
          for (const Eigen::Vector3d& p :
               sherd(middles_[k] + (pushed ? push : Eigen::Vector2d(0, 0)), 1.0)) {
            const Eigen::Vector2d pixel = images_.back().project(p);
            pixels.emplace_back(cvRound(pixel.x()), cvRound(pixel.y()));
          }
          std::vector<cv::Point> hull;
          cv::convexHull(pixels, hull);
          cv::fillConvexPoly(mask, hull, 255);
        }
        masks_.push_back(mask);
      }
    // Stereo leaves a strip out all around.
    for (int k = 0; k < 2; ++k) {
      scan::Scan scan;
      scan.id = "f00" + std::to_string(k + 1);
      for (const Eigen::Vector3d& p : sherd(middles_[k], 0.85))
        scan.cloud.points.push_back(p.cast<float>());
      scans_.push_back(scan);
    }
  }

  const Eigen::Vector2d middles_[2] = {{-45, -20}, {40, 15}};
  std::vector<rig::PosedImage> images_;
  std::vector<cv::Mat1b> masks_;
  std::vector<scan::Scan> scans_;
};

TEST_F(Stillness, IsFoundWhereNothingMoved) {
  shoot({0, 0}, 8);
  EXPECT_TRUE(findMoved(images_, masks_, scans_, {.threads = 1}).empty());
}

TEST_F(Stillness, NamesTheSherdThatWasPushedTheStopAndHowFar) {
  shoot({2.4, -1.8}, 5);  // 3 mm
  const auto moved = findMoved(images_, masks_, scans_, {.threads = 2});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].scan, "f002");
  EXPECT_EQ(moved[0].from_stop, 5);
  EXPECT_NEAR(moved[0].by_mm, 3.0, 0.2);  // a pixel is 0.5 mm
}

TEST_F(Stillness, NamesThePhotographFromWhichASherdLiesElsewhereByHand) {
  shoot({2.4, -1.8}, 5);
  // One camera, now lower, now higher, one photograph after the other.
  for (std::size_t i = 0; i < images_.size(); ++i)
    images_[i].camera = 0, images_[i].stop = static_cast<int>(i);
  const auto moved = findMoved(images_, masks_, scans_, {.threads = 1});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].scan, "f002");
  EXPECT_EQ(moved[0].from_stop, 10);  // the first photograph of the sixth stop
  EXPECT_NEAR(moved[0].by_mm, 3.0, 0.3);
}

TEST_F(Stillness, TakesABadMaskOfTheLastPhotographsForNoPush) {
  shoot({2.4, -1.8}, 7);  // two photographs
  EXPECT_TRUE(findMoved(images_, masks_, scans_, {.threads = 1}).empty());
  EXPECT_EQ(findMoved(images_, masks_, scans_, {.least_beyond = 2, .threads = 1}).size(), 1U);
}

TEST_F(Stillness, NamesAPushThatOnlyThreePhotographsShow) {
  shoot({2.4, -1.8}, 6);
  images_.pop_back();
  masks_.pop_back();
  const auto moved = findMoved(images_, masks_, scans_, {.threads = 1});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].from_stop, 6);
}

TEST_F(Stillness, SaysNothingOfAPushTooSmallToMatter) {
  shoot({0.4, 0.3}, 4);
  EXPECT_TRUE(findMoved(images_, masks_, scans_, {.threads = 1}).empty());
}

TEST_F(Stillness, SaysNothingWhereTooFewPhotographsShowTheSherdApart) {
  shoot({2.4, -1.8}, 5);
  for (std::size_t i = 4; i < masks_.size(); ++i) masks_[i] = 255;  // one patch with everything
  EXPECT_TRUE(findMoved(images_, masks_, scans_, {.threads = 1}).empty());
}

}  // namespace
}  // namespace ostraka::checks
