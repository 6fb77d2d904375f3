#include "colour/chart.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "rendered_chart.h"

namespace ostraka::colour {
namespace {

using Corners = std::vector<cv::Point2f>;

const Corners kAslant{{560, 380}, {960, 430}, {930, 690}, {520, 640}};

// Vignetting of a fifth in the corners, a lens's blur, noise of three levels.
cv::Mat3b photographWith(const cv::Mat3f& chart, const Corners& corners, double exposure = 1) {
  cv::Mat3f scene = sceneWithSherds();
  lay(chart, corners, scene);
  for (int y = 0; y < scene.rows; ++y)
    for (int x = 0; x < scene.cols; ++x) {
      const double off = (std::pow(x - 800, 2) + std::pow(y - 600, 2)) / 1e6;
      scene(y, x) *= static_cast<float>(exposure * (1 - 0.2 * off));
    }
  cv::GaussianBlur(scene, scene, {}, 1.5);
  return photographed(scene, 3);
}

cv::Mat3f whole() {
  return chartOf(photographedPatches(camera()));
}

TEST(FindChart, RecoversTheCamerasMatrixHoweverTheChartLies) {
  Corners turned = kAslant;  // by half a turn and by a quarter
  std::rotate(turned.begin(), turned.begin() + 2, turned.end());
  const Corners upright{{640, 800}, {690, 420}, {960, 460}, {900, 830}};
  for (const Corners& corners : {kAslant, turned, upright}) {
    const std::optional<Chart> chart = findChart(photographWith(whole(), corners));
    ASSERT_TRUE(chart.has_value()) << corners.front();
    EXPECT_EQ(chart->clipped, 0);
    const Result<Correction> found = correctionBy(*chart);
    ASSERT_TRUE(found.has_value()) << found.error().sentence();
    EXPECT_LT((found->matrix * camera() - Eigen::Matrix3d::Identity()).norm(), 0.08);
    EXPECT_LT(found->median, 0.8);
    EXPECT_LT(found->within_95, 1.5);
  }
}

TEST(FindChart, FindsNoneWhereThereIsNone) {
  EXPECT_FALSE(findChart(photographed(sceneWithSherds(), 3)).has_value());
  cv::Mat3f board(1200, 1600, cv::Vec3f(0.8f, 0.8f, 0.8f));
  for (int i = 0; i < 48; i += 2)
    cv::rectangle(board, cv::Rect(200 + 150 * (i % 8 + i / 8 % 2), 150 + 150 * (i / 8), 150, 150),
                  {0.02, 0.02, 0.02}, -1);
  EXPECT_FALSE(findChart(photographed(board, 3)).has_value());
}

TEST(FindChart, CountsThePatchesThatAreOverexposed) {
  const std::optional<Chart> chart = findChart(photographWith(whole(), kAslant, 1.9));
  ASSERT_TRUE(chart.has_value());
  EXPECT_GE(chart->clipped, 1) << "white";
  EXPECT_LE(chart->clipped, 6);
  const Result<Correction> refused = correctionBy(*chart);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::NotEnough);
}

// By a sheet of paper, or a sherd: where it is still found it is not used.
TEST(FindChart, AHalfCoveredChartIsNotUsed) {
  for (const cv::Rect& hidden : {cv::Rect(325, 0, 325, 450), cv::Rect(0, 0, 650, 225)}) {
    cv::Mat3f chart = whole();
    chart(hidden).setTo(cv::Scalar(0.3, 0.4, 0.45));
    const std::optional<Chart> found = findChart(photographWith(chart, kAslant));
    if (!found) continue;
    const Result<Correction> refused = correctionBy(*found);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::NotEnough);
  }
}

}  // namespace
}  // namespace ostraka::colour
