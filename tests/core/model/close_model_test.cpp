#include <gtest/gtest.h>

#include <algorithm>

#include "cloud/ply.h"
#include "model/model.h"
#include "shapes.h"

namespace ostraka::model {
namespace {

QuietProgress quiet;

Result<SherdModel> closed(const PointCloud& front, const PointCloud& back, int threads = 1) {
  ModelOptions options;
  options.threads = threads;
  return closeModel(front, back, Eigen::Isometry3d::Identity(), options, quiet, {});
}

std::vector<float> errors(const TriangleMesh& mesh, const Eigen::Vector3f& size) {
  std::vector<float> d;
  for (const Eigen::Vector3f& v : mesh.vertices) d.push_back(distanceToBox(v, size));
  std::sort(d.begin(), d.end());
  return d;
}

TEST(CloseModel, ABoxFromTwoNoisySidesIsClosedAndRightInVolume) {
  const BoxScan scan;
  const auto model = closed(scanOfBox(scan, false, 1), scanOfBox(scan, true, 2));
  ASSERT_TRUE(model.has_value()) << model.error().what;
  Message why;
  EXPECT_TRUE(isClosedManifold(model->mesh, &why)) << why;
  EXPECT_NEAR(measure(model->mesh).volume_mm3, scan.size.prod(), 0.005 * scan.size.prod());
  const std::vector<float> d = errors(model->mesh, scan.size);
  EXPECT_LT(d[d.size() * 9 / 10], 0.04f);  // noise of 0.03 mm, smoothed
  EXPECT_LT(model->filled_share, 0.001);
  EXPECT_NEAR(model->noise_mm, 0.03, 0.01);
  EXPECT_LT(model->side_gap_mm, 0.03);
}

TEST(CloseModel, EdgesStaySharp) {
  const BoxScan scan{.noise_mm = 0.0f};
  const auto model = closed(scanOfBox(scan, false, 1), scanOfBox(scan, true, 2));
  ASSERT_TRUE(model.has_value());
  // The true edge above the middle of a long side: the nearest vertex shows how much was rounded.
  float nearest = 1e9f;
  for (const Eigen::Vector3f& v : model->mesh.vertices)
    if (std::abs(v[0]) < 8)
      nearest = std::min(
          nearest, (v - Eigen::Vector3f(v[0], 0.5f * scan.size[1], 0.5f * scan.size[2])).norm());
  EXPECT_LT(nearest, 0.1f);  // Poisson's rounding of a crease on such points
  const std::vector<float> d = errors(model->mesh, scan.size);
  EXPECT_LT(d[d.size() * 99 / 100], 0.1f);
}

TEST(CloseModel, AHoleIsFilledFlatAndMarked) {
  BoxScan scan, holed;
  holed.hole_mm = 6;
  const auto model = closed(scanOfBox(holed, false, 1), scanOfBox(scan, true, 2));
  ASSERT_TRUE(model.has_value());
  // The upper face lacks 36 mm2, of which a border of up to 0.7 mm counts as seen.
  EXPECT_GT(model->filled_mm2, 4.4 * 4.4);
  EXPECT_LT(model->filled_mm2, 40);
  for (std::size_t v = 0; v < model->mesh.vertices.size(); ++v) {
    const Eigen::Vector3f& p = model->mesh.vertices[v];
    if (std::abs(p[0]) < 1 && std::abs(p[1]) < 1 && p[2] > 0) {
      EXPECT_EQ(model->mesh.seen[v], 0);
      EXPECT_NEAR(p[2], 2.5f, 0.5f);
    }
    if (std::abs(p[0]) > 5) {
      EXPECT_EQ(model->mesh.seen[v], 1) << p.transpose();
    }
  }
}

TEST(CloseModel, FlyingPointsAndFinsDoNotBecomeSurface) {
  const BoxScan scan;
  PointCloud front = scanOfBox(scan, false, 1);
  std::mt19937 random(3);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 10001) / 10000.0f;
  };
  for (int i = 0; i < 40; ++i) {
    front.points.emplace_back(uniform(-14, 14), uniform(-11, 11), uniform(3.2f, 6));
    front.normals.emplace_back(0, 0, 1);
  }
  // The upper face drawn 1 mm past an edge, as stereo does at silhouettes.
  for (int i = 0; i < 120; ++i) {
    front.points.emplace_back(uniform(12, 13), uniform(-5, 5), 2.5f + uniform(-0.03f, 0.03f));
    front.normals.emplace_back(0, 0, 1);
  }
  const auto model = closed(front, scanOfBox(scan, true, 2));
  ASSERT_TRUE(model.has_value());
  const std::vector<float> d = errors(model->mesh, scan.size);
  EXPECT_LT(d.back(), 0.45f);
  EXPECT_GT(model->points_dropped, 100);
}

TEST(CloseModel, ADisagreementOfTheSidesLeavesOneWall) {
  const BoxScan scan;
  PointCloud back = scanOfBox(scan, true, 2);
  for (Eigen::Vector3f& p : back.points) p += Eigen::Vector3f(0.1f, 0.05f, 0);
  const auto model = closed(scanOfBox(scan, false, 1), back);
  ASSERT_TRUE(model.has_value());
  EXPECT_TRUE(isClosedManifold(model->mesh));
  const std::vector<float> d = errors(model->mesh, scan.size);
  EXPECT_LT(d.back(), 0.2f);  // a shift of 0.11 mm and a crease between
  EXPECT_NEAR(measure(model->mesh).volume_mm3, scan.size.prod(), 0.01 * scan.size.prod());
}

TEST(CloseModel, TheBytesDoNotDependOnTheThreads) {
  BoxScan scan;
  scan.size = {12, 9, 4};
  const PointCloud front = scanOfBox(scan, false, 1), back = scanOfBox(scan, true, 2);
  const auto one = closed(front, back, 1);
  ASSERT_TRUE(one.has_value());
  for (const int threads : {3, 16}) {
    const auto more = closed(front, back, threads);
    ASSERT_TRUE(more.has_value());
    EXPECT_EQ(formatPly(one->mesh, "plate_front"), formatPly(more->mesh, "plate_front"));
  }
}

TEST(CloseModel, ColoursComeFromTheScanThatSawThePlace) {
  BoxScan scan;
  scan.size = {12, 9, 4};
  PointCloud front = scanOfBox(scan, false, 1), back = scanOfBox(scan, true, 2);
  front.colors.assign(front.size(), Color{200, 100, 50});
  back.colors.assign(back.size(), Color{20, 30, 40});
  const auto model = closed(front, back);
  ASSERT_TRUE(model.has_value());
  for (std::size_t v = 0; v < model->mesh.vertices.size(); ++v) {
    const Eigen::Vector3f& p = model->mesh.vertices[v];
    if (std::abs(p[0]) > 5 || std::abs(p[1]) > 3.5f) continue;
    EXPECT_EQ(model->mesh.colors[v], p[2] > 0 ? (Color{200, 100, 50}) : (Color{20, 30, 40}));
  }
}

TEST(CloseModel, WhatCannotBeUsedIsSaid) {
  const PointCloud good = scanOfBox({}, false, 1);
  PointCloud bare = good;
  bare.normals.clear();
  EXPECT_EQ(closed(bare, good).error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(closed(good, PointCloud{}).error().code, ErrorCode::NotEnough);
  EXPECT_EQ(closed(subset(good, {0, 9, 99}), subset(good, {1})).error().code, ErrorCode::NotEnough);
}

// 80 points a side made a closed body with a length, a width and a thickness of nothing.
TEST(CloseModel, APointEveryFewMillimetresMakesNoModel) {
  const BoxScan sparse{.spacing_mm = 3};
  const PointCloud front = scanOfBox(sparse, false, 1), back = scanOfBox(sparse, true, 2);
  ASSERT_GT(front.size() + back.size(), 150u);
  ASSERT_LT(front.size() + back.size(), 250u);
  const auto model = closed(front, back);
  ASSERT_FALSE(model.has_value());
  EXPECT_EQ(model.error().code, ErrorCode::NotEnough);
  const BoxScan coarse{.spacing_mm = 1};
  EXPECT_TRUE(closed(scanOfBox(coarse, false, 1), scanOfBox(coarse, true, 2)).has_value());
}

TEST(CloseModel, PointsThatStandTwiceInTheFileChangeNothingMuch) {
  BoxScan scan;
  scan.size = {12, 9, 4};
  const auto twice = [](PointCloud cloud) {
    const std::size_t count = cloud.size();
    for (std::size_t i = 0; i < count; ++i) {
      cloud.points.push_back(cloud.points[i]);
      cloud.normals.push_back(cloud.normals[i]);
    }
    return cloud;
  };
  const auto model = closed(twice(scanOfBox(scan, false, 1)), twice(scanOfBox(scan, true, 2)));
  ASSERT_TRUE(model.has_value()) << model.error().sentence();
  EXPECT_NEAR(measure(model->mesh).volume_mm3, scan.size.prod(), 0.02 * scan.size.prod());
}

// Waves of 0.8 mm, 0.05 mm high: fine tool marks.
TEST(CloseModel, ReliefOfFinePixelsStays) {
  const BoxScan fine{.size = {8, 6, 3}, .spacing_mm = 0.08f, .noise_mm = 0.005f};
  const auto wave = [](float x) { return std::sin(2 * static_cast<float>(M_PI) * x / 0.8f); };
  PointCloud front = scanOfBox(fine, false, 1);
  for (std::size_t i = 0; i < front.size(); ++i)
    if (front.normals[i].z() > 0.7f) front.points[i].z() += 0.05f * wave(front.points[i].x());
  const auto model = closed(front, scanOfBox(fine, true, 2));
  ASSERT_TRUE(model.has_value());
  double height = 0, square = 0;
  for (const Eigen::Vector3f& p : model->mesh.vertices) {
    if (p.z() < 1.2f || std::abs(p.x()) > 3.2f || std::abs(p.y()) > 2) continue;
    height += wave(p.x()) * (p.z() - 1.5f);
    square += wave(p.x()) * wave(p.x());
  }
  EXPECT_GT(height / square, 0.04);
}

TEST(CloseModel, ItStopsOnRequest) {
  std::stop_source stop;
  stop.request_stop();
  const PointCloud good = scanOfBox({}, false, 1);
  const auto model =
      closeModel(good, good, Eigen::Isometry3d::Identity(), {}, quiet, stop.get_token());
  EXPECT_EQ(model.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::model
