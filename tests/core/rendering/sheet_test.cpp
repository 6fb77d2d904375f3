#include "rendering/sheet.h"

#include <gtest/gtest.h>

using namespace ostraka;
using namespace ostraka::rendering;

// Markers are stated in the paper's own plane, wherever it lies above the table.
TEST(Sheet, ItsFrameIsThatOfThePapersMiddle) {
  vessels::Random random(3);
  const SheetSurface sheet(rig::SheetSize::A4, 4, random);
  const Eigen::Isometry3d plate_from_table = sheet.tableFromPlate().inverse();
  EXPECT_GT(std::abs(sheet.height({0, 0})), 0.2);  // of 4 mm: it does not lie on the table there
  for (const Eigen::Vector2f& p : {Eigen::Vector2f(0, 0), Eigen::Vector2f(2, 0),
                                   Eigen::Vector2f(0, -2), Eigen::Vector2f(-1.5F, 1.5F)}) {
    const Eigen::Vector3d on_paper(p.x(), p.y(), sheet.height(p));
    EXPECT_NEAR((plate_from_table * on_paper).z(), 0, 0.01);  // 4 mm x (2 / 105)^2
  }
  EXPECT_NEAR((plate_from_table * Eigen::Vector3d(0, 0, sheet.height({0, 0}))).norm(), 0, 1e-6);
}

TEST(Sheet, AFlatOneLiesInTheTablesFrame) {
  vessels::Random random(3);
  const SheetSurface sheet(rig::SheetSize::A4, 0, random);
  EXPECT_TRUE(sheet.tableFromPlate().isApprox(Eigen::Isometry3d::Identity()));
}
