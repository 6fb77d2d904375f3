#include "registration/silhouettes.h"

#include <gtest/gtest.h>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

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

TEST(Silhouettes, ViewsThatDoNotSeeTheSherdSayNothing) {
  const SimulatedSherd sherd = simulatedSherd({});
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  const std::vector<SilhouetteView> views = {
      {camera(0, 0.6, Vector3d(900, 900, 0)), cv::Mat1b(500, 600, uchar{0})}};
  const SilhouetteWitness witness(*front, *back, views, {}, sherd.truth, {}, 1);
  EXPECT_EQ(witness.evidence(sherd.truth, front->centre, 6).pairs, 0);
}

}  // namespace
}  // namespace ostraka::registration
