#include "vessels/rest.h"

#include <gtest/gtest.h>

#include "vessels/sherd.h"

namespace ostraka::vessels {
namespace {

// Lowest height of the body when tilted by a small angle about an axis through the lowest contact:
// at rest the centre of mass may only rise, whichever way it is tilted.
double heightOfCentre(const TriangleMesh& mesh, const Eigen::Matrix3d& turn) {
  double floor = 1e9;
  for (const Eigen::Vector3f& v : mesh.vertices)
    floor = std::min(floor, (turn * v.cast<double>()).z());
  return -floor;
}

TEST(Rest, ABoxLiesOnTheFaceNearestToItsUnderside) {
  TriangleMesh box;  // 10 x 20 x 6 about the origin
  for (int i = 0; i < 8; ++i)
    box.vertices.emplace_back(i & 1 ? 5.f : -5.f, i & 2 ? 10.f : -10.f, i & 4 ? 3.f : -3.f);
  const Eigen::Isometry3d pose = restPose(box, Eigen::Vector3d(0.2, 0.1, 1));
  EXPECT_NEAR(pose.translation().z(), 3, 1e-6);
  EXPECT_NEAR((pose.linear() * Eigen::Vector3d::UnitZ()).z(), 1, 1e-9);
}

TEST(Rest, ASherdTouchesThePlateAndIsStableOnEitherSide) {
  Random random(5);
  const Vessel vessel = Vessel::make(VesselForm::Bowl, 5, random);
  BreakPlan plan;
  plan.s_mm = 80;
  plan.radius_mm = 18;
  plan.edge_mm = 0.8;
  const VirtualSherd sherd = breakOut(vessel, plan);
  for (const double up : {1.0, -1.0}) {
    const Eigen::Isometry3d pose = restPose(sherd.mesh, {0, 0, up});
    double floor = 1e9;
    for (const Eigen::Vector3f& v : sherd.mesh.vertices)
      floor = std::min(floor, (pose * v.cast<double>()).z());
    EXPECT_NEAR(floor, 0, 1e-6);
    EXPECT_GT(up * pose.linear()(2, 2), 0.8);
    const double height = heightOfCentre(sherd.mesh, pose.linear());
    for (int k = 0; k < 16; ++k) {
      const double angle = 6.283185307 * k / 16;
      const Eigen::AngleAxisd tilt(0.002, Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
      EXPECT_GT(heightOfCentre(sherd.mesh, tilt * pose.linear()), height - 1e-6) << up << " " << k;
    }
  }
}

}  // namespace
}  // namespace ostraka::vessels
