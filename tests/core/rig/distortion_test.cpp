#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "rig/camera.h"

namespace ostraka::rig {
namespace {

constexpr double kSheared = 0.0007;  // of tangential and prism terms, as lenses have them

const std::vector<Distortion>& lenses() {
  static const std::vector<Distortion> all{
      {{-0.12, 0.09, kSheared, -kSheared, -0.02}, Lens::Standard},
      {{1.3, 0.4, kSheared, -kSheared, 0.05, 1.6, 0.7, 0.1}, Lens::Full},
      {{1.3, 0.4, kSheared, 0.0002, 0.05, 1.6, 0.7, 0.1, 0.003, -0.001, -0.002, 0.004}, Lens::Full},
      {{0.03, -0.01, 0.004, -0.001}, Lens::Fisheye}};
  return all;
}

std::vector<cv::Point3d> places() {
  std::vector<cv::Point3d> points;
  for (const double x : {-0.7, -0.2, 0.0, 0.4})
    for (const double y : {-0.5, 0.0, 0.6}) points.emplace_back(2 * x, 2 * y, 2);
  return points;
}

Intrinsics behind(const Distortion& lens) {
  return {1600, 1200, 900, 880, 803, 596, lens};
}

TEST(Distortion, ProjectsAsOpenCvDoes) {
  for (const Distortion& lens : lenses()) {
    const Intrinsics camera = behind(lens);
    const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    const std::vector<cv::Point3d> points = places();
    std::vector<cv::Point2d> pixels;
    const cv::Vec3d none(0, 0, 0);
    if (lens.lens == Lens::Fisheye)
      cv::fisheye::projectPoints(points, pixels, none, none, k, lens.list());
    else
      cv::projectPoints(points, none, none, k, lens.list(), pixels);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d ours = camera.project({points[i].x, points[i].y, points[i].z});
      EXPECT_NEAR(ours.x(), pixels[i].x, 1e-9) << lens.list().size() << " terms, point " << i;
      EXPECT_NEAR(ours.y(), pixels[i].y, 1e-9) << lens.list().size() << " terms, point " << i;
    }
  }
}

// Its own iteration ends at 1e-8 or so of x/z.
TEST(Distortion, IsUndoneAsOpenCvDoes) {
  for (const Distortion& lens : lenses()) {
    const Intrinsics camera = behind(lens);
    const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    const std::vector<cv::Point2d> pixels{{803, 596}, {900, 500}, {300, 900}, {1500, 1100}};
    std::vector<cv::Point2d> rays;
    const cv::TermCriteria ends(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 500, 1e-12);
    if (lens.lens == Lens::Fisheye)
      cv::fisheye::undistortPoints(pixels, rays, k, lens.list());
    else
      cv::undistortPoints(pixels, rays, k, lens.list(), cv::noArray(), cv::noArray(), ends);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Eigen::Vector2d ours = camera.unproject({pixels[i].x, pixels[i].y});
      EXPECT_NEAR(ours.x(), rays[i].x, 1e-6) << lens.list().size() << " terms, pixel " << i;
      EXPECT_NEAR(ours.y(), rays[i].y, 1e-6) << lens.list().size() << " terms, pixel " << i;
    }
  }
}

TEST(Distortion, ComesBackFromThePicture) {
  for (const Distortion& lens : lenses())
    for (const cv::Point3d& p : places()) {
      const Eigen::Vector2d n(p.x / p.z, p.y / p.z);
      EXPECT_LT((lens.unbent(lens.bent(n)) - n).norm(), 1e-9) << lens.list().size();
    }
  const Distortion& fisheye = lenses().back();
  const Eigen::Vector2d rim(std::tan(1.4), 0);  // 80 degrees off the axis
  EXPECT_LT((fisheye.unbent(fisheye.bent(rim)) - rim).norm(), 1e-9);
}

TEST(Distortion, HasTheSlopeOfItsDifferences) {
  const double step = 1e-6;
  for (const Distortion& lens : lenses()) {
    const Eigen::Vector2d n(0.4, -0.3);
    const Eigen::Matrix2d slope = lens.slope(n);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d aside = step * Eigen::Vector2d::Unit(k);
      const Eigen::Vector2d difference = (lens.bent(n + aside) - lens.bent(n - aside)) / (2 * step);
      EXPECT_LT((slope.col(k) - difference).norm(), 1e-8) << lens.list().size();
    }
  }
}

// r - 0.3 r^3 grows up to r^2 = 1 / 0.9, where it is 2/3 r.
TEST(Distortion, ReachesAsFarAsItsRadiusGrows) {
  const Distortion barrel{{-0.3}, Lens::Standard};
  const double fold = 1 / std::sqrt(0.9);
  EXPECT_NEAR(barrel.reach(), fold, 1e-9);
  EXPECT_LT((barrel.unbent({2, 0}) - Eigen::Vector2d(fold, 0)).norm(), 1e-6) << "no ray is there";
  const double near = 0.99 * fold;
  EXPECT_NEAR(barrel.unbent(barrel.bent({0, near})).y(), near, 1e-9) << "slow, and yet found";
  EXPECT_GT(Distortion{}.reach(), 14);
  // (1 - 4 r^2) below the fraction is 0 at r = 0.5.
  EXPECT_NEAR((Distortion{{0, 0, 0, 0, 0, -4}, Lens::Full}.reach()), 0.5, 1e-9);
  // t - t^3 / 3 grows up to an angle of 1.
  EXPECT_NEAR((Distortion{{-1.0 / 3}, Lens::Fisheye}.reach()), std::tan(1), 1e-9);
}

TEST(Distortion, ListsAsManyTermsAsItsModelHas) {
  const std::vector<std::size_t> counts{5, 8, 12, 4};
  for (std::size_t k = 0; k < counts.size(); ++k) EXPECT_EQ(lenses()[k].list().size(), counts[k]);
}

}  // namespace
}  // namespace ostraka::rig
