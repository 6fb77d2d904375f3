#include "vessels/gloss.h"

#include <gtest/gtest.h>

#include <vector>

#include "vessels/noise.h"

namespace ostraka::vessels {
namespace {

// Schlick's approximation for glass: 0.04 at right angles, all at grazing incidence.
TEST(Fresnel, RisesFromFourPercentToAll) {
  EXPECT_NEAR(fresnel(1), 0.04, 1e-6);
  EXPECT_NEAR(fresnel(0.5f), 0.04 + 0.96 / 32, 1e-6);
  EXPECT_NEAR(fresnel(0), 1, 1e-6);
  EXPECT_EQ(fresnel(2), fresnel(1)) << "rounding beyond one";
  EXPECT_EQ(fresnel(-0.1f), fresnel(0));
}

TEST(StrewnReflection, IsTheMirrorsWhereNothingIsRough) {
  const Eigen::Vector3f normal(0, 0, 1), to_eye = Eigen::Vector3f(1, 0, 1).normalized();
  EXPECT_LT((mirrored(normal, to_eye) - Eigen::Vector3f(-1, 0, 1).normalized()).norm(), 1e-6);
  for (std::uint64_t k = 0; k < 100; ++k)
    EXPECT_LT(
        (strewnReflection(normal, to_eye, {1, 0}, mixed(k)) - mirrored(normal, to_eye)).norm(),
        1e-5);
}

TEST(StrewnReflection, StaysOutsideTheSurfaceAndSpreadsWithTheRoughness) {
  const Eigen::Vector3f normal = Eigen::Vector3f(1, 2, 2) / 3;
  const Eigen::Vector3f grazing = (normal.unitOrthogonal() + 0.1f * normal).normalized();
  std::vector<double> spreads;
  for (const float roughness : {0.05f, 0.3f, 1.f}) {
    double apart = 0;
    for (std::uint64_t k = 0; k < 500; ++k) {
      const Eigen::Vector3f ray = strewnReflection(normal, grazing, {1, roughness}, mixed(k));
      EXPECT_NEAR(ray.norm(), 1, 1e-4);
      EXPECT_GT(ray.dot(normal), 0);
      apart += (strewnReflection(normal, normal, {1, roughness}, mixed(k)) - normal).norm() / 500;
    }
    spreads.push_back(apart);
  }
  EXPECT_GT(spreads[1], 3 * spreads[0]);
}

}  // namespace
}  // namespace ostraka::vessels
