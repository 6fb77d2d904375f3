#include "cloud/level_of_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace ostraka {
namespace {

using Eigen::Vector3f;

// A square of the plane through the origin with this normal's tilt about x.
std::vector<Vector3f> grid(float size, float step, float tilt_rad, const Vector3f& corner) {
  std::vector<Vector3f> points;
  for (float a = 0; a < size; a += step)
    for (float b = 0; b < size; b += step)
      points.push_back(corner + Vector3f(a, b * std::cos(tilt_rad), b * std::sin(tilt_rad)));
  return points;
}

double mean(const std::vector<float>& values, std::size_t from, std::size_t to) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(from),
                         values.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
         static_cast<double>(to - from);
}

// A wavy sheet of n by n squares, two triangles each.
TriangleMesh sheet(int n) {
  TriangleMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      mesh.vertices.emplace_back(0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y),
                                 std::sin(0.05f * static_cast<float>(x)));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int i = y * (n + 1) + x;
      mesh.triangles.push_back({i, i + 1, i + n + 2});
      mesh.triangles.push_back({i, i + n + 2, i + n + 1});
    }
  return mesh;
}

TEST(LevelOfDetail, LocalSpacingIsTheStepOfADenseAndOfASparsePart) {
  std::vector<Vector3f> points = grid(20, 0.2f, 0, {0, 0, 0});
  const std::size_t dense = points.size();
  for (const Vector3f& p : grid(20, 0.5f, 0, {40, 0, 0})) points.push_back(p);
  const std::vector<float> spacing = localSpacing(points);
  ASSERT_EQ(spacing.size(), points.size());
  EXPECT_NEAR(mean(spacing, 0, dense), 0.2, 0.04);  // edges of the parts count a cell that is cut
  EXPECT_NEAR(mean(spacing, dense, points.size()), 0.5, 0.12);
}

TEST(LevelOfDetail, LocalSpacingOfATiltedPlaneIsNoMoreThanHalfAsLargeAgain) {
  for (const float tilt : {0.0f, 0.4f, 0.785f, 1.2f}) {
    const std::vector<float> spacing = localSpacing(grid(20, 0.2f, tilt, {0, 0, 0}));
    const double found = mean(spacing, 0, spacing.size());
    EXPECT_GT(found, 0.18) << tilt;
    EXPECT_LT(found, 0.30) << tilt;  // larger would blur, smaller would leave holes
  }
}

TEST(LevelOfDetail, APointFarFromAllOthersDoesNotBecomeAPlate) {
  std::vector<Vector3f> points = grid(20, 0.2f, 0, {0, 0, 0});
  points.emplace_back(10, 10, 8);
  EXPECT_LT(localSpacing(points).back(), 5 * 0.2f);
}

TEST(LevelOfDetail, NoPointsAndOnePointAreClouds) {
  EXPECT_TRUE(localSpacing({}).empty());
  const std::vector<float> one = localSpacing({{1, 2, 3}});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_TRUE(std::isfinite(one[0]));
  EXPECT_GT(one[0], 0);
}

TEST(LevelOfDetail, SampledIndicesRiseAndReachAllParts) {
  const std::vector<int> some = sampledIndices(1000, 100);
  ASSERT_EQ(some.size(), 100u);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i] / 10, static_cast<int>(i));
  std::set<int> steps;
  for (std::size_t i = 1; i < some.size(); ++i) steps.insert(some[i] - some[i - 1]);
  EXPECT_GT(steps.size(), 5u) << "an even step draws stripes over points that lie in rows";
  EXPECT_EQ(sampledIndices(7, 100).size(), 7u);
  EXPECT_TRUE(sampledIndices(0, 100).empty());
}

TEST(LevelOfDetail, CoarseTrianglesCoverTheSheetWithFewOfItsVertices) {
  const TriangleMesh mesh = sheet(200);
  const std::vector<std::array<int, 3>> coarse = coarseTriangles(mesh, 8000);
  EXPECT_LE(coarse.size(), 8000u * 3 / 2);
  EXPECT_GE(coarse.size(), 8000u / 3);
  double area = 0;  // seen from above
  for (const auto& t : coarse) {
    const Vector3f a = mesh.vertices[static_cast<std::size_t>(t[0])];
    const Vector3f u = mesh.vertices[static_cast<std::size_t>(t[1])] - a;
    const Vector3f v = mesh.vertices[static_cast<std::size_t>(t[2])] - a;
    area += 0.5 * (u.x() * v.y() - u.y() * v.x());  // negative: the triangle is turned over
  }
  EXPECT_NEAR(area, 20.0 * 20.0, 0.05 * 400);  // its border moves inwards by half a cube
}

TEST(LevelOfDetail, AMeshWithFewTrianglesIsKeptWhole) {
  const TriangleMesh mesh = sheet(10);
  EXPECT_EQ(coarseTriangles(mesh, 1000), mesh.triangles);
}

}  // namespace
}  // namespace ostraka
