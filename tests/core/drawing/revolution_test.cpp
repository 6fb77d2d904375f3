#include "drawing/revolution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::drawing {
namespace {

// A sector of a cone's wall and a ring on top of it, about an axis that stands off and leans.
std::vector<ProfilePoint> cone(const Eigen::Isometry3d& model_from_axis) {
  std::vector<ProfilePoint> points;
  for (double turn = -0.4; turn <= 0.4; turn += 0.02)
    for (double z = -40; z <= 0; z += 1) {
      const double r = 80 + 0.3 * z;
      points.push_back(
          {model_from_axis * Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), z), 0, 3, 1});
    }
  return points;
}

Eigen::Isometry3d leaningAxis() {
  Eigen::Isometry3d model_from_axis(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  model_from_axis.translation() = Eigen::Vector3d(10, -20, 30);
  return model_from_axis;
}

// The axis as found, seen from the true one: along z through the origin.
struct Found {
  double leaning = 0, beside_mm = 0;
};

Found seen(const Eigen::Isometry3d& model_from_axis, const Revolution::Fit& fit) {
  const Eigen::Isometry3d true_from_found =
      model_from_axis.inverse() * fit.axis_from_model.inverse();
  const Eigen::Vector3d through = true_from_found.translation(),
                        along = true_from_found.linear().col(2);
  const Eigen::Vector3d at_rim = through - through.z() / along.z() * along;
  return {along.head<2>().norm(), at_rim.head<2>().norm()};
}

TEST(Revolution, FindsTheAxisOfAConeFromASectorOfIt) {
  const Eigen::Isometry3d model_from_axis = leaningAxis();
  const Eigen::Isometry3d start = Revolution::moved(model_from_axis.inverse(), {0.1, -0.08, 9, -7});
  const Revolution::Fit fit = Revolution(cone(model_from_axis), start).solve(100);
  EXPECT_TRUE(fit.converged);
  const Found found = seen(model_from_axis, fit);
  EXPECT_LT(found.leaning, 2e-3);
  EXPECT_LT(found.beside_mm, 0.1);
}

// Chips and roots: a least-squares fit would lean towards them.
TEST(Revolution, HardlyFollowsPointsFarOffTheProfile) {
  const Eigen::Isometry3d model_from_axis = leaningAxis();
  std::vector<ProfilePoint> points = cone(model_from_axis);
  for (std::size_t i = 0; i < points.size() / 8; ++i) {  // all of them at one end of the sector
    const Eigen::Vector3d p = model_from_axis.inverse() * points[i].p;
    const double out = i % 3 == 0 ? 4 : 0;
    points[i].p = model_from_axis * (p + out * Eigen::Vector3d(p.x(), p.y(), 0).normalized());
  }
  const Eigen::Isometry3d start = Revolution::moved(model_from_axis.inverse(), {0.02, 0.02, 2, -2});
  const Found found = seen(model_from_axis, Revolution(points, start).solve(100));
  EXPECT_LT(found.leaning, 0.05);
  EXPECT_LT(found.beside_mm, 4);
}

TEST(Revolution, MeasuresACircleByItsMeanRadiusAndHeight) {
  // Radii 50 and 52 at heights 7 and 7.2 by turns: off by 1 and by 0.1.
  std::vector<ProfilePoint> points;
  for (int k = 0; k < 8; ++k) {
    const double turn = k * 0.25, r = 50 + 2 * (k % 2), z = 7 + 0.2 * (k % 2);
    points.push_back({{r * std::cos(turn), r * std::sin(turn), z}, Revolution::kCircle, 3, 1});
  }
  const Revolution::Fit fit = Revolution(points, Eigen::Isometry3d::Identity()).solve(0);
  ASSERT_EQ(fit.residuals.size(), 16);
  for (Eigen::Index k = 0; k < 8; ++k) {
    EXPECT_NEAR(fit.residuals[2 * k], k % 2 == 0 ? -1 : 1, 1e-9);
    EXPECT_NEAR(fit.residuals[2 * k + 1], k % 2 == 0 ? -0.1 : 0.1, 1e-9);
  }
  // Huber's loss at 0.3: 0.3 (2 * 1 - 0.3) = 0.51 and 0.01, half of the residuals each.
  EXPECT_NEAR(fit.cost, (0.51 + 0.01) / 2, 1e-9);
  EXPECT_FALSE(fit.converged);
}

}  // namespace
}  // namespace ostraka::drawing
