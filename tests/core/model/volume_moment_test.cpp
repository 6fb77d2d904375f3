#include "model/volume_moment.h"

#include <gtest/gtest.h>

#include <utility>

#include "shapes.h"

namespace ostraka::model {
namespace {

TEST(VolumeMoment, OfABoxIsItsProductAboutItsMiddle) {
  TriangleMesh box = boxMesh({4, 3, 2});
  for (Eigen::Vector3f& p : box.vertices) p += Eigen::Vector3f(100, -50, 1);
  const VolumeMoment found = volumeMoment(box);
  EXPECT_NEAR(found.volume_mm3, 24, 1e-9);
  EXPECT_TRUE(found.centre.isApprox(Eigen::Vector3d(100, -50, 1), 1e-12));
}

// (0,0,0), (1,0,0), (0,1,0), (0,0,1): a sixth of the cube, its centre at a quarter.
TEST(VolumeMoment, OfAnInsideOutTetrahedronIsNegativeAboutTheSameMiddle) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EXPECT_NEAR(volumeMoment(mesh).volume_mm3, 1.0 / 6, 1e-12);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(volumeMoment(mesh).volume_mm3, -1.0 / 6, 1e-12);
  EXPECT_TRUE(volumeMoment(mesh).centre.isApprox(Eigen::Vector3d::Constant(0.25), 1e-12));
}

TEST(VolumeMoment, WithoutVolumeIsTheFirstVertex) {
  TriangleMesh flat;
  flat.vertices = {{5, 6, 7}, {6, 6, 7}, {5, 7, 7}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_EQ(volumeMoment(flat).volume_mm3, 0);
  EXPECT_EQ(volumeMoment(flat).centre, Eigen::Vector3d(5, 6, 7));
}

}  // namespace
}  // namespace ostraka::model
