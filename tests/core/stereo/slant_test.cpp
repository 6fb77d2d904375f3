#include "stereo/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ostraka::stereo {
namespace {

// A level square of 20 mm whose views, four to a point, see it higher by 0.03 mm times the tangent
// of their slant, each with an error of its own.
std::vector<SurfacePoint> seen(double factor_mm) {
  std::mt19937 random(5);
  std::normal_distribution<double> error(0, 0.02);
  std::uniform_real_distribution<double> tangent(0.2, 2.0);
  std::vector<SurfacePoint> points;
  for (int k = 0; k < 10000; ++k) {
    double t[4], height[4], mean_t = 0, mean = 0;
    for (int v = 0; v < 4; ++v) {
      t[v] = tangent(random);
      height[v] = factor_mm * t[v] + error(random);
      mean_t += t[v] / 4;
      mean += height[v] / 4;
    }
    SurfacePoint p;
    p.position = Eigen::Vector3d(0.2 * (k % 100), 0.2 * (k / 100), mean).cast<float>();
    p.normal = Eigen::Vector3f::UnitZ();
    p.footprint_mm = 0.24F;
    p.slant.mean = static_cast<float>(mean_t);
    for (int v = 0; v < 4; ++v) {
      p.slant.covariance += static_cast<float>((t[v] - mean_t) * (height[v] - mean));
      p.slant.variance += static_cast<float>((t[v] - mean_t) * (t[v] - mean_t));
    }
    points.push_back(p);
  }
  return points;
}

double meanHeight(const std::vector<SurfacePoint>& points) {
  double sum = 0;
  for (const SurfacePoint& p : points) sum += static_cast<double>(p.position.z());
  return sum / static_cast<double>(points.size());
}

TEST(Slant, IsTakenOutAsTheViewsThemselvesTellIt) {
  const std::vector<SurfacePoint> points = seen(0.03);
  EXPECT_NEAR(meanHeight(points), 0.033, 0.001);  // 0.03 times the mean tangent of 1.1
  EXPECT_NEAR(meanHeight(withoutSlant(points, {})), 0.033 * 0.05 / 1.05, 0.001);
}

TEST(Slant, IsLeftAloneWhereTheViewsAgree) {
  EXPECT_NEAR(meanHeight(withoutSlant(seen(0), {})), 0, 0.001);
}

TEST(Neighbourhoods, HoldNoMorePixelsOfPhotographsFromNear) {
  std::vector<SurfacePoint> points(3);
  const auto with = [&](float pixel_mm) {
    for (SurfacePoint& p : points) p.footprint_mm = pixel_mm;
    return neighbourhood_mm(points, 2.5F);
  };
  EXPECT_FLOAT_EQ(with(0.24F), 2.5F);
  EXPECT_FLOAT_EQ(with(0.8F), 2.5F);
  EXPECT_FLOAT_EQ(with(0.05F), 1.6F);  // 2.5 mm would hold 8,000 pixels
}

TEST(Slant, OfASingleViewIsNotKnown) {
  std::vector<SurfacePoint> points = seen(0.03);
  for (SurfacePoint& p : points) p.slant = {1.1F, 0, 0};
  EXPECT_EQ(meanHeight(withoutSlant(points, {})), meanHeight(points));
}

}  // namespace
}  // namespace ostraka::stereo
