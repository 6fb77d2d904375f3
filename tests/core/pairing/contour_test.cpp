#include "pairing/contour.h"

#include <gtest/gtest.h>

#include <numbers>

#include "synthetic_sherd.h"

namespace ostraka::pairing {
namespace {

constexpr double kPi = std::numbers::pi;

PointCloud disc(double radius, double height) {
  PointCloud cloud;
  for (double x = -radius; x <= radius; x += 0.4) {
    for (double y = -radius; y <= radius; y += 0.4) {
      if (x * x + y * y <= radius * radius) {
        cloud.points.push_back(Eigen::Vector3d(x, y, height).cast<float>());
        cloud.normals.push_back(Eigen::Vector3f::UnitZ());
      }
    }
  }
  return cloud;
}

TEST(TraceContour, OfADiscHasItsLengthAreaAndHeight) {
  const auto contour = traceContour(disc(20, 5), Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(contour.has_value());
  // The outermost grid points lie up to one step of 0.4 mm inside, 0.2 on the average.
  EXPECT_NEAR(contour->area_mm2, kPi * 19.8 * 19.8, 0.01 * kPi * 400);
  EXPECT_NEAR(contour->perimeter_mm, 2 * kPi * 19.8, 0.03 * 2 * kPi * 20);
  const Eigen::Isometry3d scan_from_plane = contour->plane_from_scan.inverse();
  for (const double h : contour->heights) {
    EXPECT_NEAR((scan_from_plane * Eigen::Vector3d(0, 0, h)).z(), 5, 1e-4);
  }
}

TEST(TraceContour, DoesNotChangeWhenScanAndAxisAreTurned) {
  const PointCloud cloud = test::SlabSherd(5).seenFrom(1);
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()));
  turned.pretranslate(Eigen::Vector3d(100, -50, 30));
  const auto a = traceContour(cloud, Eigen::Vector3d::UnitZ());
  const auto b =
      traceContour(transformed(cloud, turned), turned.linear() * Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(a.has_value() && b.has_value());
  EXPECT_NEAR(a->area_mm2, b->area_mm2, 0.05);
  EXPECT_NEAR(a->perimeter_mm, b->perimeter_mm, 0.1);
}

TEST(TraceContour, LeavesFlyingPointsAside) {
  PointCloud cloud = disc(20, 5);
  const double area = traceContour(cloud, Eigen::Vector3d::UnitZ())->area_mm2;
  for (int i = 0; i < 40; ++i) {  // 0.5 % of the points, up to 1.5 mm outside, alone
    const double phi = 2 * kPi * i / 40;
    cloud.points.push_back(
        Eigen::Vector3d(21.5 * std::cos(phi), 21.5 * std::sin(phi), 5).cast<float>());
    cloud.normals.push_back(Eigen::Vector3f::UnitZ());
  }
  EXPECT_NEAR(traceContour(cloud, Eigen::Vector3d::UnitZ())->area_mm2, area, 0.5);
}

TEST(TraceContour, RefusesAHandfulOfPoints) {
  PointCloud few;
  few.points.assign(19, Eigen::Vector3f::Zero());
  const auto contour = traceContour(few, Eigen::Vector3d::UnitZ());
  ASSERT_FALSE(contour.has_value());
  EXPECT_EQ(contour.error().code, ErrorCode::NotEnough);
}

TEST(Resampled, StepsEvenlyAlongAClosedLine) {
  const std::vector<Eigen::Vector2d> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const auto points = resampled(square, 8);
  ASSERT_EQ(points.size(), 8u);
  EXPECT_NEAR((points[1] - Eigen::Vector2d(1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((points[7] - Eigen::Vector2d(0, 1)).norm(), 0, 1e-12);
}

TEST(Mirrored, KeepsTheSenseOfRotation) {
  const std::vector<Eigen::Vector2d> triangle = {{0, 0}, {2, 0}, {0, 1}};
  const auto m = mirrored(triangle);
  EXPECT_NEAR(signedArea(m), 1, 1e-12);
}

TEST(SignedArea, IsNegativeForALineThatRunsClockwise) {
  const std::vector<Eigen::Vector2d> square = {{1, 1}, {1, 3}, {4, 3}, {4, 1}};
  EXPECT_NEAR(signedArea(square), -6, 1e-12);
  EXPECT_EQ(signedArea({}), 0);
}

}  // namespace
}  // namespace ostraka::pairing
