#include "virtualrig/layout.h"

#include <gtest/gtest.h>

#include "cloud/nearest.h"
#include "virtualrig/setup.h"

namespace ostraka::virtualrig {
namespace {

// Smallest distance between the vertices of two sherds as they lie.
double gapBetween(const vessels::VirtualSherd& a, const Eigen::Isometry3d& pose_a,
                  const vessels::VirtualSherd& b, const Eigen::Isometry3d& pose_b) {
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& v : a.mesh.vertices)
    points.push_back((pose_a * v.cast<double>()).cast<float>());
  const KdTree tree(points);
  float nearest = 1e9f;
  for (const Eigen::Vector3f& v : b.mesh.vertices)
    nearest =
        std::min(nearest, tree.nearest((pose_b * v.cast<double>()).cast<float>()).squared_distance);
  return std::sqrt(nearest);
}

TEST(Layout, LaysTouchingPairsAgainstEachOtherAndAllOthersApart) {
  SimulateOptions options;
  options.seed = 32;
  options.sherds = 5;
  options.touching = 2;
  options.output = "unused";
  options.threads = 1;
  const auto sherds = *makeSherds(options);
  vessels::Random random(9);
  const Result<Layout> layout = layOut(sherds, options, random);
  ASSERT_TRUE(layout) << layout.error().what;
  for (const auto* poses : {&layout->front, &layout->back})
    for (std::size_t i = 0; i < sherds.size(); ++i)
      for (std::size_t j = i + 1; j < sherds.size(); ++j) {
        const double gap = gapBetween(sherds[i], (*poses)[i], sherds[j], (*poses)[j]);
        if (i % 2 == 0 && j == i + 1 && j < 4)
          EXPECT_LT(gap, 0.36) << i << " and " << j;  // their vertices are 0.5 mm apart
        else
          EXPECT_GT(gap, 2.5) << i << " and " << j;  // 4 mm, less the cells' diagonal
      }
}

TEST(Layout, RefusesASherdLargerThanThePlate) {
  SimulateOptions options;
  options.seed = 32;
  options.sherds = 1;
  options.output = "unused";
  options.threads = 1;
  std::vector<vessels::VirtualSherd> sherds = *makeSherds(options);
  for (Eigen::Vector3f& v : sherds[0].mesh.vertices) v *= 6;  // some 40 cm on a plate of 33
  vessels::Random random(9);
  const Result<Layout> layout = layOut(sherds, options, random);
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::virtualrig
