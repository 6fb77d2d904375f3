#include "cloud/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/core/evaluate/box.h"

namespace ostraka {
namespace {

TEST(Surface, MeasuresDistancesToABoxOverFaceEdgeCornerAndFromWithin) {
  const Surface surface(evaluate::boxMesh(50, 40, 6, 20));
  EXPECT_NEAR(surface.closest({25, 20, 7.5}).distance_mm, 1.5, 1e-9);  // over the upper face
  EXPECT_NEAR(surface.closest({-3, -4, 3}).distance_mm, 5.0, 1e-9);    // off an edge: 3, 4, 5
  EXPECT_NEAR(surface.closest({-2, -3, -6}).distance_mm, 7.0, 1e-9);   // off a corner: 2, 3, 6
  EXPECT_NEAR(surface.closest({25, 20, 5.9}).distance_mm, 0.1, 1e-6);  // 5.9 and 6 in float
  EXPECT_LT((surface.closest({25, 20, 7.5}).point - Eigen::Vector3d(25, 20, 6)).norm(), 1e-9);
}

TEST(Surface, AgreesWithTryingEveryTriangle) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> at(-10, 10), small(-2, 2);
  TriangleMesh mesh;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3f p(at(random), at(random), at(random));
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back(p + Eigen::Vector3f(small(random), small(random), small(random)));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Surface surface(mesh);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d q(at(random), at(random), at(random));
    double best = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles)
      best = std::min(best, (closestOnTriangle(q, mesh.vertices[t[0]].cast<double>(),
                                               mesh.vertices[t[1]].cast<double>(),
                                               mesh.vertices[t[2]].cast<double>()) -
                             q)
                                .norm());
    EXPECT_NEAR(surface.closest(q).distance_mm, best, 1e-12);
  }
}

TEST(Surface, TakesAMeshWithoutFacesAsPoints) {
  TriangleMesh points;
  points.vertices = {{0, 0, 0}, {10, 0, 0}};
  EXPECT_NEAR(Surface(points).closest({7, 4, 0}).distance_mm, 5.0, 1e-12);
}

TEST(Surface, GivesFiniteDistancesForTrianglesWithoutArea) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 0, 0}, {0, 1, 2}, {1, 1, 2}};
  EXPECT_NEAR(Surface(mesh).closest({1.5, 2, 0}).distance_mm, 2.0, 1e-12);
  EXPECT_NEAR(Surface(mesh).closest({5, 4, 0}).distance_mm, 5.0, 1e-12);
}

// 12 triangles, each ten thousand times: only their first ones are searched.
TEST(Surface, SearchesRepeatedTrianglesOnce) {
  const TriangleMesh box = evaluate::boxMesh(5, 4, 3, 1);
  TriangleMesh repeated = box;
  for (int round = 1; round < 10'000; ++round)
    for (const std::array<int, 3>& t : box.triangles)
      repeated.triangles.push_back({t[round % 3], t[(round + 1) % 3], t[(round + 2) % 3]});
  const Surface once(box), often(repeated);
  for (int i = 0; i < 20'000; ++i) {
    const Eigen::Vector3d query(i % 13 - 4, i % 17 - 6, i % 7 - 2);
    const SurfacePoint found = often.closest(query);
    ASSERT_EQ(found.distance_mm, once.closest(query).distance_mm);
    ASSERT_EQ(found.triangle, once.closest(query).triangle);
  }
}

TEST(Surface, HearsAStop) {
  std::stop_source stop;
  stop.request_stop();
  const std::vector<Eigen::Vector3d> queries(10, Eigen::Vector3d(100, 0, 0));
  for (const SurfacePoint& found :
       Surface(evaluate::boxMesh(5, 4, 3, 1)).closest(queries, 1, stop.get_token()))
    EXPECT_EQ(found.distance_mm, 0);
}

TEST(Surface, AnswersTheSameForAnyNumberOfThreads) {
  const Surface surface(evaluate::boxMesh(5, 4, 3, 7));
  std::vector<Eigen::Vector3d> queries;
  for (int i = 0; i < 5000; ++i) queries.emplace_back(i % 13 - 4, i % 17 - 6, i % 7 - 2);
  const auto one = surface.closest(queries, 1);
  for (const int threads : {3, 16}) {
    const auto many = surface.closest(queries, threads);
    for (std::size_t i = 0; i < queries.size(); ++i)
      ASSERT_EQ(one[i].distance_mm, many[i].distance_mm);
  }
}

}  // namespace
}  // namespace ostraka
