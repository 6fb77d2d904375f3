#include "calibration/intrinsics.h"

#include <gmock/gmock.h>

#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

std::vector<TargetView> boardViews(double tilt, double noise_px) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 1);
  const auto noise = [&](auto& generator) { return noise_px * normal(generator); };
  const rig::Intrinsics camera = rig::lens(2600);
  std::vector<TargetView> views;
  for (int k = 0; k < 10; ++k) {
    const Eigen::Isometry3d pose =
        rig::rigid({tilt * std::cos(k), tilt * std::sin(k), 0.3 * k},
                   {20.0 * (k % 3 - 1) - 60, 15.0 * (k % 4 - 2) - 40, 700.0 + 5 * k});
    TargetView& view = views.emplace_back();
    view.file = "view" + std::to_string(k);
    for (int i = 0; i < 48; ++i) {
      view.points.emplace_back(22.0 * (i % 8), 22.0 * (i / 8), 0);
      view.pixels.push_back(camera.project(pose * view.points.back()) +
                            Eigen::Vector2d(noise(random), noise(random)));
    }
  }
  return views;
}

TEST(CalibrateIntrinsics, FindsTheLensOfTiltedViews) {
  const auto report = calibrateIntrinsics(boardViews(0.5, 0.03), 1600, 1200);
  ASSERT_TRUE(report.has_value()) << report.error().sentence();
  EXPECT_NEAR(report->intrinsics.fx, 2600, 2.6);  // 0.1 %
  EXPECT_TRUE(report->focal_determined);
  EXPECT_NEAR(report->intrinsics.distortion[0], -0.06, 0.01);
  EXPECT_EQ(report->intrinsics.distortion[4], 0);  // not determined, so not used
  EXPECT_TRUE(report->advice.empty());
}

TEST(CalibrateIntrinsics, SaysThatFrontalViewsDoNotDetermineTheFocalLength) {
  const auto report = calibrateIntrinsics(boardViews(0.01, 0.2), 1600, 1200);
  ASSERT_TRUE(report.has_value()) << report.error().sentence();
  EXPECT_FALSE(report->focal_determined);
  EXPECT_THAT(report->advice, testing::Contains(testing::HasSubstr("not determined")));
}

TEST(CalibrateIntrinsics, NamesTheWorstViewAndSetsEmptyOnesAside) {
  std::vector<TargetView> views = boardViews(0.5, 0.03);
  for (Eigen::Vector2d& pixel : views[4].pixels) pixel.x() += pixel.y() > 600 ? 0.5 : -0.5;
  views.push_back({"empty.jpg", {}, {}});
  const auto report = calibrateIntrinsics(views, 1600, 1200);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->files[report->worst_view], "view4");
  EXPECT_THAT(report->set_aside, testing::ElementsAre(testing::HasSubstr("empty.jpg")));
}

TEST(CalibrateIntrinsics, NeedsThreeViews) {
  const std::vector<TargetView> views = boardViews(0.5, 0);
  const auto report = calibrateIntrinsics(std::span(views).first(2), 1600, 1200);
  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, ErrorCode::NotEnough);
}

}  // namespace
}  // namespace ostraka::calibration
