#include "scan/fracture.h"

#include <gtest/gtest.h>

#include <numbers>

#include "slabs.h"

namespace ostraka::scan {
namespace {

TEST(FindFracture, MarksTheWallsAndNotTheFace) {
  const PointCloud cloud = test::box(0, 0, 30, 30, 6);
  const std::vector<std::uint8_t> fracture = findFracture(cloud, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(fracture.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    const float inside = std::min({p.x(), p.y(), 30 - p.x(), 30 - p.y()});
    if (std::abs(cloud.normals[i].z()) < 0.5f) {
      EXPECT_EQ(fracture[i], 1);
    }
    if (inside > 2.5f) {
      EXPECT_EQ(fracture[i], 0);
    }
  }
}

TEST(FindFracture, IsTheSameHoweverTheScanIsTurned) {
  const PointCloud cloud = test::box(0, 0, 30, 24, 6);
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.rotate(Eigen::AngleAxisd(2.2, Eigen::Vector3d(1, -2, 0.5).normalized()));
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const auto a = findFracture(cloud, up),
             b = findFracture(transformed(cloud, turn), turn.linear() * up);
  int different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
  EXPECT_LT(different, static_cast<int>(cloud.size() / 20));  // the raster's cells turn too
}

TEST(FindFracture, IsEmptyWithoutNormals) {
  PointCloud cloud = test::box(0, 0, 30, 30, 6);
  cloud.normals.clear();
  for (const std::uint8_t r : findFracture(cloud, Eigen::Vector3d::UnitZ())) EXPECT_EQ(r, 0);
}

TEST(EstimateUp, FacesTheViewer) {
  EXPECT_GT(estimateUp(test::box(0, 0, 40, 30, 6)).z(), 0.999);
  const Eigen::Isometry3d flip(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  EXPECT_LT(estimateUp(transformed(test::box(0, 0, 40, 30, 6), flip)).z(), -0.999);
}

TEST(EstimateUp, FacesTheViewerOfATallPieceToo) {
  EXPECT_GT(estimateUp(test::box(0, 0, 60, 8, 12)).z(), 0.9);  // thinnest sideways
}

}  // namespace
}  // namespace ostraka::scan
