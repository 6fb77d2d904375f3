#include "vessels/sherd.h"

#include <gtest/gtest.h>

#include <map>

namespace ostraka::vessels {
namespace {

VirtualSherd piece(SherdPart part, double radius_mm, std::uint64_t relief_seed = 4) {
  Random random(3);
  const Vessel vessel = Vessel::make(VesselForm::Jar, 6, random);
  BreakPlan plan;
  plan.part = part;
  plan.radius_mm = radius_mm;
  plan.s_mm = part == SherdPart::Wall  ? 130
              : part == SherdPart::Rim ? vessel.length() - 12
                                       : 0.8 * vessel.heel();
  plan.edge_mm = 0.7;
  plan.outline_seed = 9;
  plan.relief_seed = relief_seed;
  return breakOut(vessel, plan);
}

class EachPart : public testing::TestWithParam<SherdPart> {};

TEST_P(EachPart, IsAClosedOrientedManifold) {
  const TriangleMesh mesh = piece(GetParam(), 22).mesh;
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);                                    // one triangle on this side
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);  // one on the other, turned alike
  }
  // Euler: a sphere has V - E + F = 2.
  EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(edges.size()) / 2 +
                static_cast<int>(mesh.triangles.size()),
            2);
}

TEST_P(EachPart, HasAtMostSixtyThousandFacesWithUsefulEdges) {
  Random random(3);
  const Vessel vessel = Vessel::make(VesselForm::Jar, 6, random);
  BreakPlan plan;
  plan.part = GetParam();
  plan.s_mm = plan.part == SherdPart::Rim    ? vessel.length() - 25
              : plan.part == SherdPart::Base ? 30
                                             : 130;
  plan.radius_mm = 42;
  const VirtualSherd sherd = breakOut(vessel, plan);
  EXPECT_LE(sherd.mesh.triangles.size(), 60'000u);
  EXPECT_GT(sherd.mesh.triangles.size(), 45'000u);
}

INSTANTIATE_TEST_SUITE_P(Parts, EachPart,
                         testing::Values(SherdPart::Wall, SherdPart::Rim, SherdPart::Base));

TEST(Sherd, HasItsOriginInTheCentreOfMassAndFacesOutward) {
  const VirtualSherd sherd = piece(SherdPart::Wall, 22);
  Eigen::Vector3d centre;
  EXPECT_GT(enclosedVolume(sherd.mesh, &centre), 0);
  EXPECT_LT(centre.norm(), 1e-3);
}

TEST(Sherd, EnclosesAboutTheAreaOfItsWallTimesTheThickness) {
  const VirtualSherd sherd = piece(SherdPart::Wall, 22);
  // The outer face's triangles, by depth 0 at all corners; breaks lean in and out alike, and the
  // inner face of a jar is smaller by thickness / radius = 6 %: within 8 % of the mean.
  double outer = 0;
  for (const auto& t : sherd.mesh.triangles) {
    if (sherd.places[t[0]].depth > 0 || sherd.places[t[1]].depth > 0 ||
        sherd.places[t[2]].depth > 0)
      continue;
    const auto& v = sherd.mesh.vertices;
    outer += 0.5 * (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).norm();
  }
  EXPECT_NEAR(sherd.volume_mm3 / (outer * sherd.wall_mean_mm), 0.97, 0.08);
}

TEST(Sherd, LookAlikesShareTheOutlineButNotTheBreak) {
  const VirtualSherd a = piece(SherdPart::Wall, 22, 4), b = piece(SherdPart::Wall, 22, 5);
  EXPECT_NEAR(a.width_mm, b.width_mm, 1.5);
  EXPECT_NEAR(a.volume_mm3 / b.volume_mm3, 1, 0.05);
  EXPECT_EQ(a.mesh.triangles.size(), b.mesh.triangles.size());
  double squares = 0;
  int broken = 0;
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    if (a.places[i].broken == 0) continue;
    squares += (a.mesh.vertices[i] - b.mesh.vertices[i]).squaredNorm();
    ++broken;
  }
  const double rms = std::sqrt(squares / broken);
  EXPECT_GT(rms, 0.15);
  EXPECT_LT(rms, 2.5);
}

}  // namespace
}  // namespace ostraka::vessels
