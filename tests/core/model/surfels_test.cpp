#include "model/surfels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "shapes.h"

namespace ostraka::model {
namespace {

// Both scans of a small box, the back as its own frame has it.
class MergedBox : public testing::Test {
 protected:
  MergedBox() {
    box.size = {10, 8, 4};
    front_from_back.translation() = Eigen::Vector3d(3, -2, 1);
    front_from_back.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
    front = scanOfBox(box, false, 1);
    back = transformed(scanOfBox(box, true, 2), front_from_back.inverse());
  }
  Result<Surfels> merged(int threads = 1) const {
    return mergedSurfels(front, back, front_from_back, 0, threads, {});
  }
  static double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
  BoxScan box;
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  PointCloud front, back;
};

TEST_F(MergedBox, LieOnTheBoxCloserThanThePointsThatTheyAreMadeOf) {
  const Result<Surfels> surfels = merged();
  ASSERT_TRUE(surfels.has_value());
  std::vector<float> off;
  for (const Eigen::Vector3f& p : surfels->points) off.push_back(distanceToBox(p, box.size));
  EXPECT_LT(mean(off), 0.018);  // of noise of 0.03: its mean size is 0.024
  EXPECT_LT(*std::max_element(off.begin(), off.end()), 0.2);
  for (const Eigen::Vector3f& n : surfels->normals) EXPECT_NEAR(n.norm(), 1, 1e-4);
}

TEST_F(MergedBox, ShareItsSurfaceAndKnowTheirNoise) {
  const Result<Surfels> surfels = merged();
  ASSERT_TRUE(surfels.has_value());
  ASSERT_EQ(surfels->area.size(), surfels->size());
  ASSERT_EQ(surfels->noise.size(), surfels->size());
  ASSERT_EQ(surfels->confidence.size(), surfels->size());
  const double surface = 2 * (10 * 8 + 10 * 4 + 8 * 4);  // mm2
  EXPECT_NEAR(std::accumulate(surfels->area.begin(), surfels->area.end(), 0.0), surface,
              0.15 * surface);
  EXPECT_NEAR(surfels->spacing_mm, 0.35, 0.12);
  EXPECT_NEAR(surfels->noise_mm, 0.03, 0.015);
  EXPECT_LT(surfels->side_gap_mm, 0.05);
  for (const float c : surfels->confidence) {
    EXPECT_GT(c, 0);
    EXPECT_LE(c, 1);
  }
}

TEST_F(MergedBox, DropOutliersAndCountThem) {
  const int before = merged().value().dropped;
  for (const Eigen::Vector3f& p :
       {Eigen::Vector3f(9, 9, 9), Eigen::Vector3f(-20, 0, 0), Eigen::Vector3f(0, 0, 7)}) {
    front.points.push_back(p);
    front.normals.emplace_back(0, 0, 1);
  }
  const Result<Surfels> surfels = merged();
  ASSERT_TRUE(surfels.has_value());
  EXPECT_EQ(surfels->dropped, before + 3);
  for (const Eigen::Vector3f& p : surfels->points) EXPECT_LT(distanceToBox(p, box.size), 0.5);
}

TEST_F(MergedBox, AreTheSameWithAnyNumberOfThreads) {
  const Surfels one = merged().value();
  for (const int threads : {3, 16}) {
    const Surfels other = merged(threads).value();
    EXPECT_EQ(other.points, one.points);
    EXPECT_EQ(other.area, one.area);
  }
}

TEST_F(MergedBox, NeedPoints) {
  front = back = {};
  const Result<Surfels> surfels = merged();
  ASSERT_FALSE(surfels.has_value());
  EXPECT_EQ(surfels.error().code, ErrorCode::NotEnough);
}

TEST(Surfels, ThatAreKeptComeInTheGivenOrderAndTheOthersAreCounted) {
  Surfels s;
  for (int i = 0; i < 4; ++i) {
    const float v = static_cast<float>(i);
    s.points.emplace_back(v, 0, 0);
    s.normals.emplace_back(0, v, 0);
    s.noise.push_back(v);
    s.confidence.push_back(10 + v);
    s.area.push_back(20 + v);
  }
  s.dropped = 5;
  s.keep({3, 1});
  ASSERT_EQ(s.size(), 2U);
  EXPECT_EQ(s.points[0].x(), 3);
  EXPECT_EQ(s.normals[1].y(), 1);
  EXPECT_EQ(s.noise, (std::vector<float>{3, 1}));
  EXPECT_EQ(s.confidence, (std::vector<float>{13, 11}));
  EXPECT_EQ(s.area, (std::vector<float>{23, 21}));
  EXPECT_EQ(s.dropped, 7);
}

}  // namespace
}  // namespace ostraka::model
