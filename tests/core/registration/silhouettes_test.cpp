#include "registration/silhouettes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Looks at the target from `azimuth` and `elevation`, 400 mm away, at 4 pixels per mm.
rig::PosedImage camera(double azimuth, double elevation, const Vector3d& target) {
  rig::PosedImage image;
  image.intrinsics = {
      .width = 600, .height = 500, .fx = 1600, .fy = 1600, .cx = 300, .cy = 250, .distortion = {}};
  const Vector3d away(std::cos(azimuth) * std::cos(elevation),
                      std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const Vector3d z = -away, x = z.cross(Vector3d::UnitZ()).normalized(), y = z.cross(x);
  Eigen::Matrix3d rows;
  rows << x.transpose(), y.transpose(), z.transpose();
  image.camera_from_plate.linear() = rows;
  image.camera_from_plate.translation() = -rows * (target + 400 * away);
  return image;
}

cv::Mat1b maskOf(const rig::PosedImage& image, const scan::Scan& a, const Isometry3d& plate_from_a,
                 const scan::Scan& b, const Isometry3d& plate_from_b) {
  cv::Mat1b mask(image.intrinsics.height, image.intrinsics.width, uchar{0});
  const auto draw = [&](const scan::Scan& scan, const Isometry3d& pose) {
    for (const Eigen::Vector3f& p : scan.cloud.points) {
      const Eigen::Vector2d u = image.project(pose * p.cast<double>());
      cv::circle(mask, {static_cast<int>(std::lround(u.x())), static_cast<int>(std::lround(u.y()))},
                 1, 255, cv::FILLED);
    }
  };
  draw(a, plate_from_a);
  draw(b, plate_from_b);
  return mask;
}

struct Views {
  std::vector<SilhouetteView> front, back;
};

// Three elevations: at a single one a fatness of all outlines looks like a height.
Views viewsOf(const SimulatedSherd& sherd) {
  const Isometry3d same = Isometry3d::Identity();
  Views views;
  for (int k = 0; k < 12; ++k) {
    const double azimuth = 0.5236 * k, elevation = 0.44 + 0.33 * (k % 3);
    const rig::PosedImage f = camera(azimuth, elevation, Vector3d(0, 0, 2));
    views.front.push_back({f, maskOf(f, sherd.front, same, sherd.back, sherd.truth)});
    const rig::PosedImage b = camera(azimuth, elevation, sherd.truth.inverse() * Vector3d(0, 0, 2));
    views.back.push_back({b, maskOf(b, sherd.front, sherd.truth.inverse(), sherd.back, same)});
  }
  return views;
}

TEST(Silhouettes, MoveTheBackToWhereThePhotographsShowIt) {
  const SimulatedSherd sherd = simulatedSherd({.noise_mm = 0});
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  const Views views = viewsOf(sherd);
  Isometry3d pose = sherd.truth;
  pose.pretranslate(Vector3d(0.4, -0.2, 0.4));
  const double before = rms_mm(pose, sherd.truth, sherd.back);
  const SilhouetteConstraint constraint(*front, *back, views.front, views.back, pose, 1);
  for (const double reach_px : {6.0, 4.5, 3.5, 3.0, 3.0, 3.0}) {
    const Vector3d pivot = front->centre;
    OutlineFit fit = constraint.evidence(pose, pivot, reach_px);
    ASSERT_GT(fit.pairs, 200);
    fit.evidence.information.diagonal().array() += 1e-3;
    pose = changed(pose, -fit.evidence.information.ldlt().solve(fit.evidence.gradient), pivot);
  }
  // Whole-pixel masks, a pixel too fat, of 4 pixels per mm: less than half a pixel is left.
  EXPECT_LT(rms_mm(pose, sherd.truth, sherd.back), std::min(0.10, before / 5));
}

TEST(Silhouettes, KnowTheHeightNoBetterThanLowerEdgesErr) {
  const SimulatedSherd sherd = simulatedSherd({.noise_mm = 0});
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  const Views views = viewsOf(sherd);
  const SilhouetteConstraint constraint(*front, *back, views.front, views.back, sherd.truth, 1);
  Matrix6 information = constraint.evidence(sherd.truth, front->centre, 3).evidence.information;
  information.diagonal().array() += 1e-3;
  const Vector6 sd = information.inverse().diagonal().cwiseSqrt();
  // Half a pixel along a face that looks down is 0.125 mm of height at 4 pixels per mm, and the two
  // sides err each on its own: 0.125 / sqrt(2).
  EXPECT_GT(sd[5], 0.088);
  EXPECT_LT(sd[3], 0.05);
  EXPECT_LT(sd[4], 0.05);
}

TEST(Silhouettes, ViewsThatDoNotSeeTheSherdSayNothing) {
  const SimulatedSherd sherd = simulatedSherd({});
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  const std::vector<SilhouetteView> views = {
      {camera(0, 0.6, Vector3d(900, 900, 0)), cv::Mat1b(500, 600, uchar{0})}};
  const SilhouetteConstraint constraint(*front, *back, views, {}, sherd.truth, 1);
  EXPECT_EQ(constraint.evidence(sherd.truth, front->centre, 6).pairs, 0);
}

}  // namespace
}  // namespace ostraka::registration
