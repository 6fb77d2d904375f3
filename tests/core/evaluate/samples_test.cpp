#include "evaluate/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "box.h"

namespace ostraka::evaluate {
namespace {

TEST(AreaSamples, LieOnTheMeshOnePerSquareOfTheSpacing) {
  const TriangleMesh box = boxMesh(50, 40, 6, 3);
  const double area = 2 * (50 * 40 + 50 * 6 + 40 * 6);
  const SurfaceSamples samples = areaSamples(box, 0.5, 1);
  EXPECT_NEAR(static_cast<double>(samples.points.size()), area / 0.25, 2.0);
  std::size_t upper = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Eigen::Vector3d& p = samples.points[i];
    const double off = std::min({std::abs(p.x()), std::abs(p.x() - 50), std::abs(p.y()),
                                 std::abs(p.y() - 40), std::abs(p.z()), std::abs(p.z() - 6)});
    ASSERT_LT(off, 1e-5);
    upper += samples.normals[i].z() > 0.99;
  }
  // Slices of equal area leave at most one sample's doubt at each of a side's ends.
  EXPECT_NEAR(static_cast<double>(upper), 50 * 40 / 0.25, 20);
}

TEST(AreaSamples, AreNeverFewerThanTwoThousandNorMoreThanAsked) {
  EXPECT_EQ(areaSamples(boxMesh(1, 1, 1), 1.0, 1).points.size(), 2000u);
  EXPECT_EQ(areaSamples(boxMesh(50, 50, 50), 0.1, 1, 3000).points.size(), 3000u);
}

}  // namespace
}  // namespace ostraka::evaluate
