#include "registration/outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

// An ellipse of half axes 15 and 10 mm, points 0.3 mm apart.
std::vector<Vector3f> ellipse(double x0) {
  std::vector<Vector3f> points;
  for (double x = -20; x < 20; x += 0.3)
    for (double y = -20; y < 20; y += 0.3)
      if (x * x / 225 + y * y / 100 < 1)
        points.emplace_back(static_cast<float>(x + x0), static_cast<float>(y), 2.0f);
  return points;
}

TEST(Outline, OfADiscIsItsCircleWithNormalsOutward) {
  std::vector<Vector2f> disc;
  for (double x = -10; x <= 10; x += 0.1)
    for (double y = -10; y <= 10; y += 0.1)
      if (x * x + y * y < 64) disc.emplace_back(static_cast<float>(x), static_cast<float>(y));
  const Outline outline = outlineOf(coverageOf(disc, 0.25, 0.6));
  ASSERT_GT(outline.points.size(), 150u);  // 50 mm of line in cells of 0.25 mm
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    EXPECT_NEAR(outline.points[i].norm(), 8.0, 0.2);  // within a cell
    EXPECT_GT(outline.normals[i].dot(outline.points[i].normalized()), 0.95);
  }
}

TEST(Outline, TwoSidesOfOneSherdAreMovedOntoEachOther) {
  const std::vector<Vector3f> front = ellipse(0), back = ellipse(0.5);
  const Vector3d up = Vector3d::UnitZ(), pivot(0, 0, 2);
  Isometry3d pose = Isometry3d::Identity();
  for (int round = 0; round < 5; ++round) {
    OutlineFit fit = fitOutlines(front, back, 0.3, pose, up, pivot);
    ASSERT_GT(fit.pairs, 50);
    fit.evidence.information.diagonal().array() += 1e-3;  // height and tilt are not seen
    pose = changed(pose, -fit.evidence.information.ldlt().solve(fit.evidence.gradient), pivot);
  }
  EXPECT_NEAR(pose.translation().x(), -0.5, 0.03);
  EXPECT_NEAR(pose.translation().y(), 0, 0.03);
}

TEST(Outline, SparseSkirtsBeyondTheEdgeAreCutOff) {
  std::vector<Vector2f> square;
  for (double x = -10; x <= 10; x += 0.4)
    for (double y = -10; y <= 10; y += 0.4)
      square.emplace_back(static_cast<float>(x), static_cast<float>(y));
  for (double y = -10; y <= 10; y += 1.3)  // a skirt: one point in a millimetre
    for (double x = 10.7; x < 13; x += 1.3)
      square.emplace_back(static_cast<float>(x), static_cast<float>(y));
  const Outline outline = outlineOf(coverageOf(square, 0.52, 0.6));
  for (const Eigen::Vector2d& p : outline.points) EXPECT_LT(p.x(), 11.0);
}

TEST(Outline, TooFewPointsHaveNoOutline) {
  const std::vector<Vector2f> few(9, Vector2f(1, 1));
  EXPECT_TRUE(outlineOf(coverageOf(few, 0.25, 0.6)).points.empty());
}

}  // namespace
}  // namespace ostraka::registration
