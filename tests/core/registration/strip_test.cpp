#include "registration/strip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

double meanHeight(const std::vector<Eigen::Vector3f>& points) {
  double sum = 0;
  for (const Eigen::Vector3f& p : points) sum += p.z();
  return sum / static_cast<double>(points.size());
}

TEST(Strip, IsTheBrokenWallWithoutTheFace) {
  const SimulatedSherd sherd = simulatedSherd({});
  const Strip strip = std::move(*prepareStrip(sherd.front, {}));
  ASSERT_GT(strip.fine.points.size(), 500u);
  ASSERT_EQ(strip.fine.normals.size(), strip.fine.points.size());
  int on_wall = 0;
  for (std::size_t i = 0; i < strip.fine.points.size(); ++i) {
    EXPECT_NEAR(strip.fine.normals[i].norm(), 1, 1e-4);
    EXPECT_LE(strip.fine.normals[i].z(), 0.86f);
    on_wall += strip.fine.points[i].z() < 4.8f ? 1 : 0;
  }
  EXPECT_GT(on_wall, 0.9 * static_cast<double>(strip.fine.points.size()));
  EXPECT_GT(strip.up.z(), 0.999);
  EXPECT_NEAR(strip.spacing_mm, 0.4, 0.1);
  // The wall is seen from 1.2 mm upwards, and the scan ends there.
  ASSERT_GT(strip.boundary.size(), 50u);
  EXPECT_LT(meanHeight(strip.boundary), 2);
  EXPECT_NEAR(meanHeight(strip.fine.points), 3.1, 0.4);
}

// Of a smooth wall: relief that is finer than a patch counts as noise, too.
TEST(Strip, KnowsTheNoiseOfItsPoints) {
  for (const double noise_mm : {0.02, 0.06}) {
    const SimulatedSherd disc = simulatedSherd({.relief = 0, .noise_mm = noise_mm});
    EXPECT_NEAR(prepareStrip(disc.front, {})->noise_mm, noise_mm, 0.4 * noise_mm);
  }
}

// The lowest band is fat and noisy in scans of photographs.
TEST(Strip, TrustsItsLowestBandLess) {
  const SimulatedSherd sherd = simulatedSherd({});
  const Strip strip = std::move(*prepareStrip(sherd.front, {}));
  for (std::size_t i = 0; i < strip.fine.points.size(); ++i) {
    const float height_mm = strip.fine.points[i].z();
    if (height_mm < 1.8f || height_mm > 2.2f) {
      EXPECT_EQ(strip.fine.weights[i] < 1, height_mm < 2) << height_mm;
    }
  }
}

TEST(Strip, HasACoarserOneOfItsOwnPoints) {
  const SimulatedSherd sherd = simulatedSherd({});
  StripOptions options;
  options.coarse_mm = 2;
  const Strip strip = std::move(*prepareStrip(sherd.front, options));
  EXPECT_LT(4 * strip.coarse.points.size(), strip.fine.points.size());
  EXPECT_GT(strip.coarse.points.size(), 50u);
  for (const Eigen::Vector3f& p : strip.coarse.points)
    EXPECT_EQ(strip.fine.points[static_cast<std::size_t>(strip.fine.tree.nearest(p).index)], p);
}

TEST(Strip, ScaledHasAllLengthsMultipliedAndNothingElse) {
  const SimulatedSherd sherd = simulatedSherd({});
  const Strip strip = std::move(*prepareStrip(sherd.front, {})), twice = scaled(strip, 2);
  EXPECT_DOUBLE_EQ(twice.noise_mm, 2 * strip.noise_mm);
  EXPECT_DOUBLE_EQ(twice.spacing_mm, 2 * strip.spacing_mm);
  EXPECT_DOUBLE_EQ(twice.radius_mm, 2 * strip.radius_mm);
  EXPECT_LT((twice.centre - 2 * strip.centre).norm(), 1e-9);
  EXPECT_EQ(twice.fine.normals, strip.fine.normals);
  EXPECT_EQ(twice.fine.weights, strip.fine.weights);
  ASSERT_EQ(twice.fine.points.size(), strip.fine.points.size());
  EXPECT_EQ(twice.fine.points[7], Eigen::Vector3f(2 * strip.fine.points[7]));
  EXPECT_EQ(twice.fine.points[static_cast<std::size_t>(
                twice.fine.tree.nearest(2 * strip.fine.points[7]).index)],
            twice.fine.points[7])
      << "its tree is over the new points";
  EXPECT_EQ(twice.boundary.size(), strip.boundary.size());
  EXPECT_EQ(twice.shell[3], Eigen::Vector3f(2 * strip.shell[3]));
}

TEST(Strip, NeedsNormalsAndAFracture) {
  scan::Scan scan = simulatedSherd({}).front;
  scan::Scan face = scan;
  face.cloud = {};
  for (std::size_t i = 0; i < scan.cloud.size(); ++i)
    if (scan.cloud.normals[i].z() > 0.99f) {
      face.cloud.points.push_back(scan.cloud.points[i]);
      face.cloud.normals.push_back(scan.cloud.normals[i]);
    }
  scan.cloud.normals.clear();
  for (const scan::Scan* poor : {&scan, &face}) {
    const auto none = prepareStrip(*poor, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotEnough);
    EXPECT_EQ(none.error().where, "f");
  }
}

}  // namespace
}  // namespace ostraka::registration
