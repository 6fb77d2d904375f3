#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "model/contouring.h"
#include "model/model.h"
#include "shapes.h"

namespace ostraka::model {
namespace {

TEST(Measures, ATurnedBoxHasItsSidesAreaVolumeAndCentre) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(40, -20, 7))
      .rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Measures m = measure(transformed(boxMesh({30, 20, 5}), pose));
  EXPECT_NEAR(m.length_mm, 30, 1e-4);
  EXPECT_NEAR(m.width_mm, 20, 1e-4);
  EXPECT_NEAR(m.area_mm2, 2 * (600 + 150 + 100), 1e-2);
  EXPECT_NEAR(m.volume_mm3, 3000, 1e-2);
  EXPECT_LT((m.centroid - Eigen::Vector3d(40, -20, 7)).norm(), 1e-4);
}

// Of any size, also one that no int holds in pixels.
TEST(Measures, ARasterHasNoMorePixelsThanTheLimit) {
  const Raster usual = rasterOver({50.2, 40}, 24);
  EXPECT_EQ(usual.columns, 1205);
  EXPECT_EQ(usual.rows, 960);
  EXPECT_EQ(usual.per_mm, 24);
  for (const Eigen::Vector2d& size : {Eigen::Vector2d(1e3, 1e3), Eigen::Vector2d(1e8, 1e8),
                                      Eigen::Vector2d(1e12, 1), Eigen::Vector2d(1, 1e30)}) {
    const Raster raster = rasterOver(size, 24);
    EXPECT_LT(raster.per_mm, 24) << size.transpose();
    // A pixel that is begun counts whole.
    EXPECT_LE((raster.columns - 1.0) * (raster.rows - 1.0), 1.001 * limits::kRasterPixels.most);
    EXPECT_LE(std::max(raster.columns, raster.rows), 1 + static_cast<int>(limits::kImageSide.most));
    EXPECT_GE(std::min(raster.columns, raster.rows), 1);
  }
}

TEST(Measures, AModelInAnotherUnitTakesNoMoreMemoryThanOneInMillimetres) {
  const Measures thin = measure(boxMesh({1e8F, 1, 1}));
  EXPECT_NEAR(thin.length_mm, 1e8, 100);
  EXPECT_EQ(thin.holes_mm2, 0);
}

TEST(Measures, AModelLargerThanAnyVesselIsRefused) {
  EXPECT_TRUE(checkExtent(boxMesh({1999, 900, 30}), "7").has_value());
  for (const float size : {2001.F, 1e8F, 1e30F}) {
    const Result<void> refused = checkExtent(boxMesh({5, size, 5}), "7");
    ASSERT_FALSE(refused.has_value()) << size;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, "7");
  }
}

TEST(Measures, AModelSmallerThanAnySherdIsRefusedWithItsProbableUnit) {
  EXPECT_TRUE(checkExtent(boxMesh({3.1F, 1, 1}), "7").has_value());
  EXPECT_TRUE(checkExtent({}, "7").has_value()) << "what is empty has no unit";
  const auto refusal = [](const Eigen::Vector3f& size) {
    const Result<void> refused = checkExtent(boxMesh(size), "7");
    EXPECT_FALSE(refused.has_value());
    return refused ? std::string() : refused.error().what.english();
  };
  EXPECT_NE(refusal({0.05F, 0.04F, 0.005F}).find("(metres)"), std::string::npos);
  EXPECT_NE(refusal({2.5F, 2, 0.5F}).find("(centimetres)"), std::string::npos);
}

// A plate of 24 x 18 x 4 mm on a grid: many small faces. taken: where it is positive, nothing is
// left.
template <class Taken>
TriangleMesh plateWithout(const Taken& taken) {
  Grid grid;
  grid.cell_mm = 0.5f;
  grid.size = {60, 48, 20};
  const Eigen::Vector3f centre(14.6f, 11.7f, 4.6f), size(24, 18, 4);
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 60; ++x) {
        const Eigen::Vector3f p = grid.node(x, y, z) - centre;
        const Eigen::Vector3f q = p.cwiseAbs() - 0.5f * size;
        grid.values.push_back(std::max(q.maxCoeff(), taken(p)));
      }
  return contour(grid);
}

TEST(Measures, ThicknessIsThatOfTheWallNotOfTheBreaks) {
  const Measures m = measure(plateWithout([](const Eigen::Vector3f&) { return -1.F; }));
  // The grid chamfers the edges a little.
  EXPECT_NEAR(m.thickness_min_mm, 4, 0.06);
  EXPECT_NEAR(m.thickness_mean_mm, 4, 0.02);
  EXPECT_NEAR(m.thickness_max_mm, 4, 0.02);
}

// With a hole of this radius drilled through it, and a hollow beside it.
TriangleMesh drilledPlate(float radius) {
  return plateWithout([radius](const Eigen::Vector3f& p) {
    const float hollow = 2 - (p - Eigen::Vector3f(-7, 0, 2)).norm();
    return std::max(radius - p.head<2>().norm(), hollow);
  });
}

TEST(Measures, AHoleIsWhatOneSeesRightThroughAndAHollowIsNone) {
  EXPECT_EQ(measure(drilledPlate(0)).holes_mm2, 0);
  EXPECT_NEAR(measure(drilledPlate(2)).holes_mm2, M_PI * 4, 2.5);  // cells of 0.5 mm, drawn full
  EXPECT_NEAR(measure(drilledPlate(3)).holes_mm2, M_PI * 9, 4);
}

TEST(Measures, AMeshWithoutFacesMeasuresNothing) {
  EXPECT_EQ(measure(TriangleMesh{}).area_mm2, 0);
}

}  // namespace
}  // namespace ostraka::model
