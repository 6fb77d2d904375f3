#include "registration/bilateral_boundary_icp.h"

#include <gtest/gtest.h>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

TEST(BilateralBoundaryIcp, FindsTheKnownPoseFromHalfAMillimetreOff) {
  const SimulatedSherd sherd = simulatedSherd({});
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  const auto fit = bilateralBoundaryIcp(*front, *back, startOff(sherd, 0.5, 0.02), {}, {});
  ASSERT_TRUE(fit.has_value()) << fit.error().what;
  // The paper's method ends at 0.08-0.3 mm on clean scans: point to point on a grid of 0.4 mm
  // hardly holds the height of a steep wall.
  EXPECT_LT(rms_mm(fit->front_from_back, sherd.truth, sherd.back), 0.3);
  EXPECT_EQ(fit->scale, 1.0);
}

TEST(BilateralBoundaryIcp, FindsTheScaleOfASideWithoutAKnownLength) {
  SimulatedSherd sherd = simulatedSherd({});
  for (Eigen::Vector3f& p : sherd.back.cloud.points) p /= 1.03f;
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  BilateralBoundaryIcpOptions options;
  options.free_scale = true;
  const auto fit = bilateralBoundaryIcp(*front, *back, sherd.truth, options, {});
  ASSERT_TRUE(fit.has_value()) << fit.error().what;
  EXPECT_NEAR(fit->scale, 1.03, 0.003);  // 0.06 mm on 20 mm
}

TEST(BilateralBoundaryIcp, SidesThatDoNotMeetAreRefused) {
  const SimulatedSherd sherd = simulatedSherd({});
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  Eigen::Isometry3d far = sherd.truth;
  far.pretranslate(Eigen::Vector3d(200, 0, 0));
  const auto fit = bilateralBoundaryIcp(*front, *back, far, {}, {});
  ASSERT_FALSE(fit.has_value());
  EXPECT_EQ(fit.error().code, ErrorCode::NotEnough);
}

}  // namespace
}  // namespace ostraka::registration
