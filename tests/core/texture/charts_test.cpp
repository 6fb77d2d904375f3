#include "texture/charts.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "block.h"
#include "texture/flat.h"

namespace ostraka::texture {
namespace {

double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                      .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                      .norm();
  return area;
}

double areaOf(const Chart& chart) {
  double area = 0;
  for (const auto& corners : chart.corners) area += crossOf(corners) / 2;
  return area;
}

// Each face once, none mirrored, none twice in one place.
void expectSound(const TriangleMesh& mesh, const std::vector<Chart>& charts, double cell_mm) {
  std::set<int> faces;
  for (const Chart& chart : charts) {
    ASSERT_EQ(chart.faces.size(), chart.corners.size());
    std::map<std::pair<int, int>, int> owner;
    int overlaps = 0;
    for (std::size_t i = 0; i < chart.faces.size(); ++i) {
      EXPECT_TRUE(faces.insert(chart.faces[i]).second) << "twice";
      EXPECT_GT(crossOf(chart.corners[i]), 0) << "mirrored";
      std::array<Eigen::Vector2d, 3> t;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GE(chart.corners[i][k].minCoeff(), -1e-4);
        EXPECT_LE((chart.corners[i][k] - chart.size).maxCoeff(), 1e-4);
        t[k] = chart.corners[i][k].cast<double>() / cell_mm;
      }
      // A little smaller, so that neighbours do not meet on their edge.
      const Eigen::Vector2d middle = (t[0] + t[1] + t[2]) / 3;
      for (Eigen::Vector2d& p : t) p = middle + 0.98 * (p - middle);
      forEachInside(t, 100000, 100000, 0, [&](int x, int y, const Eigen::Vector3d&) {
        if (!owner.try_emplace({x, y}, chart.faces[i]).second) ++overlaps;
      });
    }
    EXPECT_LE(overlaps, 0.01 * static_cast<double>(owner.size()));
  }
  EXPECT_EQ(faces.size(), mesh.triangles.size());
}

TEST(Charts, OfATileAreItsFacesAndItsFractureUnrolled) {
  const TriangleMesh tile = block({40, 30, 6}, 1);
  const std::vector<Chart> charts = chartsOf(tile, 0.2);
  expectSound(tile, charts, 0.2);
  ASSERT_GE(charts.size(), 4u);
  EXPECT_NEAR(areaOf(charts[0]), 40 * 30, 45) << "the front; single faces of its edge may go along";
  EXPECT_NEAR(areaOf(charts[1]), 40 * 30, 45);
  EXPECT_NEAR(charts[0].size.x(), 40, 1e-3) << "as it lies in the front's photographs";
  EXPECT_NEAR(charts[0].size.y(), 30, 1e-3);
  double fracture = 0;
  for (std::size_t i = 2; i < charts.size(); ++i) {
    EXPECT_LE(charts[i].size.x(), 42) << "in rows no longer than the faces";
    fracture += areaOf(charts[i]);
  }
  EXPECT_NEAR(fracture, 2 * (40 + 30) * 6, 0.15 * 2 * (40 + 30) * 6);
  EXPECT_LE(charts.size(), 10u) << "few, so that a person can read them";
}

TEST(Charts, OfABentSherdKeepItsArea) {
  // A wall of a jar of 60 mm: 50 mm of its way around.
  const TriangleMesh wall = block({50, 40, 7}, 1, [](const Eigen::Vector3f& p) {
    const float angle = p.x() / 60, radius = 53 + p.z();
    return Eigen::Vector3f(radius * std::sin(angle), p.y(), radius * std::cos(angle) - 53);
  });
  const std::vector<Chart> charts = chartsOf(wall, 0.2);
  expectSound(wall, charts, 0.2);
  double area = 0;
  for (const Chart& chart : charts) area += areaOf(chart);
  EXPECT_GT(area, 0.9 * areaOf(wall));
  EXPECT_LE(charts.size(), 10u);
}

TEST(Charts, OfABallAndOfARingHoldEachFaceOnce) {
  const TriangleMesh ball = block({20, 20, 20}, 1, [](const Eigen::Vector3f& p) {
    const Eigen::Vector3f c = p - Eigen::Vector3f(0, 0, 10);
    return Eigen::Vector3f(10 * c.normalized());
  });
  expectSound(ball, chartsOf(ball, 0.2), 0.2);
  // A tube: its inside turns away from every outline.
  TriangleMesh ring;
  const int n = 60, m = 24;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / m;
      ring.vertices.push_back(Eigen::Vector3d((20 + 5 * std::cos(b)) * std::cos(a),
                                              (20 + 5 * std::cos(b)) * std::sin(a), 5 * std::sin(b))
                                  .cast<float>());
      const int p = i * m + k, q = (i + 1) % n * m + k;
      const int p1 = i * m + (k + 1) % m, q1 = (i + 1) % n * m + (k + 1) % m;
      ring.triangles.insert(ring.triangles.end(), {{p, q, q1}, {p, q1, p1}});
    }
  expectSound(ring, chartsOf(ring, 0.2), 0.2);
}

TEST(Charts, OfNothingAreNone) {
  EXPECT_TRUE(chartsOf({}, 0.2).empty());
}

}  // namespace
}  // namespace ostraka::texture
