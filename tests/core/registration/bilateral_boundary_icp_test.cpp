#include "registration/bilateral_boundary_icp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

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

// Without masks: the boundary is the row of points at which the scan ends below.
TEST(BilateralBoundaryIcp, TakesThePapersBoundaryInsteadOfTheStrips) {
  const SimulatedSherd sherd = simulatedSherd({});
  const StripOptions paper{.boundary = Boundary::Paper};
  const auto front = prepareStrip(sherd.front, paper), back = prepareStrip(sherd.back, paper);
  const auto lowest = std::count_if(front->boundary.begin(), front->boundary.end(),
                                    [](const Eigen::Vector3f& p) { return p.z() < 2.2f; });
  EXPECT_GT(front->boundary.size(), 200u) << "of 330 that go round";
  EXPECT_GT(static_cast<double>(lowest), 0.8 * static_cast<double>(front->boundary.size()));
  const auto fit = bilateralBoundaryIcp(*front, *back, startOff(sherd, 0.5, 0.02), {}, {});
  ASSERT_TRUE(fit.has_value()) << fit.error().what;
  EXPECT_LT(rms_mm(fit->front_from_back, sherd.truth, sherd.back), 0.35) << "as of the strip's";
}

// A hole in a face is an end of the scan, but none of the sherd.
TEST(BilateralBoundaryIcp, ThePapersBoundaryAsksTheMasksOfTheSide) {
  const SimulatedSherd sherd = simulatedSherd({});
  SilhouetteView above;
  above.camera.intrinsics = {600, 500, 1600, 1600, 300, 250, {}};  // 4 pixels per mm
  above.camera.camera_from_plate.translate(Eigen::Vector3d(0, 0, 400));
  above.camera.camera_from_plate.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  above.mask = cv::Mat1b(500, 600, uchar{0});
  scan::Scan holed = sherd.front;
  holed.cloud = {};
  for (std::size_t i = 0; i < sherd.front.cloud.size(); ++i) {
    const Eigen::Vector3f& p = sherd.front.cloud.points[i];
    const Eigen::Vector2d at = above.camera.project(p.cast<double>());
    cv::circle(above.mask, {cvRound(at.x()), cvRound(at.y())}, 2, 255, cv::FILLED);
    if (p.head<2>().norm() < 4) continue;
    holed.cloud.points.push_back(p);
    holed.cloud.normals.push_back(sherd.front.cloud.normals[i]);
  }
  const auto atTheHole = [](const Strip& strip) {
    return std::count_if(strip.boundary.begin(), strip.boundary.end(),
                         [](const Eigen::Vector3f& p) { return p.head<2>().norm() < 6; });
  };
  const StripOptions paper{.boundary = Boundary::Paper};
  const auto alone = prepareStrip(holed, paper), seen = prepareStrip(holed, paper, {&above, 1});
  ASSERT_TRUE(alone.has_value() && seen.has_value());
  EXPECT_GT(atTheHole(*alone), 20);
  EXPECT_EQ(atTheHole(*seen), 0);
  EXPECT_GT(seen->boundary.size(), 200u);
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

// Points that meet nothing widen the front's boundary alone: its extents, a seventh larger than the
// back's, forbid the true scale of 1.
TEST(BilateralBoundaryIcp, TheScaleStaysWithinWhatTheExtentsOfTheBoundariesAllow) {
  const SimulatedSherd sherd = simulatedSherd({});
  auto front = prepareStrip(sherd.front, {});
  const auto back = prepareStrip(sherd.back, {});
  BilateralBoundaryIcpOptions options;
  options.free_scale = true;
  const auto free = bilateralBoundaryIcp(*front, *back, sherd.truth, options, {});
  ASSERT_TRUE(free.has_value()) << free.error().what;
  EXPECT_NEAR(free->scale, 1, 0.01);
  const std::size_t count = front->boundary.size();
  for (std::size_t k = 0; k < 3 * count / 10; ++k) {
    const float side = k % 4 < 2 ? 32.f : -32.f;
    front->boundary.emplace_back(k % 2 == 0 ? side : 0.f, k % 2 == 0 ? 0.f : side, 2.f);
  }
  const auto bounded = bilateralBoundaryIcp(*front, *back, sherd.truth, options, {});
  ASSERT_TRUE(bounded.has_value()) << bounded.error().what;
  EXPECT_GT(bounded->scale, 1.03);
  EXPECT_LT(bounded->scale, 1.25);
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
