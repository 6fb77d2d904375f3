#include "scan/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "slabs.h"

namespace ostraka::scan {
namespace {

/// Two sherds, plate points with noise, a marker, a crumb and flying points.
PointCloud plate() {
  PointCloud cloud = test::box(-60, 40, 30, 25, 6);
  test::append(cloud, test::box(10, -50, 40, 20, 5));
  test::append(cloud, test::box(80, 80, 4, 4, 4));  // crumb
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 0.08f);
  std::uniform_real_distribution<float> anywhere(-120, 120), high(5, 30);
  for (int i = 0; i < 20000; ++i) {
    cloud.points.emplace_back(anywhere(random), anywhere(random), noise(random));
    cloud.normals.push_back(Eigen::Vector3f::UnitZ());
  }
  for (int i = 0; i < 30; ++i) {
    cloud.points.emplace_back(anywhere(random), anywhere(random), high(random));
    cloud.normals.push_back(Eigen::Vector3f::UnitX());
  }
  return cloud;
}

Result<SplitResult> split(const PointCloud& cloud, SplitOptions options = {}) {
  QuietProgress quiet;
  return splitScans(cloud, batch::Side::Front, options, quiet);
}

TEST(SplitScans, FindsTheSherdsAndLeavesPlateCrumbAndFlyersOut) {
  const auto found = split(plate());
  ASSERT_TRUE(found.has_value()) << found.error().what;
  ASSERT_EQ(found->scans.size(), 2u);
  EXPECT_EQ(found->scans[0].id, "f001");
  // All but the lowest row of the walls, which is within the plate's own noise.
  EXPECT_NEAR(static_cast<double>(found->scans[0].cloud.size()),
              static_cast<double>(test::box(-60, 40, 30, 25, 6).size()), 250);
  EXPECT_EQ(found->scans[0].fracture.size(), found->scans[0].cloud.size());
  ASSERT_EQ(found->warnings.size(), 1u);  // of the crumb
}

TEST(SplitScans, ASliverIsACrumbHoweverLong) {
  PointCloud cloud = test::box(-60, 40, 30, 25, 6);
  test::append(cloud, test::box(10, -50, 15, 2, 3));  // the foot of a sherd, or a shadow's edge
  test::append(cloud, test::box(60, -50, 11, 9, 3));  // as long, but a sherd
  const auto found = split(cloud);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_EQ(found->scans.size(), 2u);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_NE(found->warnings[0].english().find("small object of 15 mm at x 18"), std::string::npos)
      << found->warnings[0];
}

TEST(SplitScans, APieceAsLargeAsASherdIsNamedHoweverFewItsPoints) {
  PointCloud cloud = test::box(-60, 40, 30, 25, 6);
  const auto addGrid = [&](double x, double y, int columns, int rows) {
    for (int c = 0; c < columns; ++c)
      for (int r = 0; r < rows; ++r) {
        cloud.points.push_back(Eigen::Vector3d(x + 1.1 * c, y + 1.1 * r, 3).cast<float>());
        cloud.normals.push_back(Eigen::Vector3f::UnitZ());
      }
  };
  addGrid(20, -50, 10, 9);  // 9.9 x 8.8 mm, 90 mm2 seen from above
  addGrid(60, -50, 4, 4);   // smaller than any sherd
  const auto found = split(cloud);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_EQ(found->scans.size(), 1u);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_EQ(found->warnings[0],
            "A sparse object of 90 points at x 25, y -46 mm was left out; if it is a sherd, "
            "photograph it closer.");
}

TEST(SplitScans, ASherdInADipOfTheSheetKeepsItsFoot) {
  PointCloud cloud = test::box(40, 0, 30, 25, 6);
  for (Eigen::Vector3f& p : cloud.points) p.z() -= 1.5F;
  const auto count = [&](const SplitOptions& options) {
    const auto found = split(cloud, options);
    return found && found->scans.size() == 1 ? found->scans[0].cloud.size() : 0;
  };
  SplitOptions bent;
  bent.ground.reach_mm = 40;
  bent.ground.coefficients_mm[0] = -1.5;  // x^2: at the sherd's middle
  const std::size_t cut = count({}), whole = count(bent);
  EXPECT_GT(static_cast<double>(cut), 0);
  EXPECT_GT(static_cast<double>(whole - cut), 0.1 * static_cast<double>(cloud.size()));
  bent.ground.coefficients_mm[0] = 3;  // the paper gave way, or it would stand in it
  EXPECT_EQ(count(bent), cut);
}

// The same plate in a unit that is a third of a millimetre's: nothing may be lost for it.
TEST(SplitScans, WithoutAScaleACrumbIsOneBesideTheUsualSherd) {
  PointCloud cloud = test::box(-60, 40, 15, 12, 4);  // a third of a sherd of 45 x 36 mm
  test::append(cloud, test::box(10, -50, 14, 13, 4));
  test::append(cloud, test::box(50, 0, 8, 5, 2));  // a small sherd, as of 23 x 14 mm beside them
  const auto in_mm = split(cloud);
  ASSERT_TRUE(in_mm.has_value());
  EXPECT_EQ(in_mm->scans.size(), 2u);
  EXPECT_TRUE(in_mm->doubtful.empty());
  SplitOptions relative;
  relative.lengths = Lengths::Relative;
  const auto found = split(cloud, relative);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->scans.size(), 3u);
  EXPECT_TRUE(found->doubtful.empty());
}

TEST(SplitScans, WithoutAScaleWhatIsLeftOutIsNamedAndInDoubt) {
  SplitOptions relative;
  relative.lengths = Lengths::Relative;
  const auto found = split(plate(), relative);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->scans.size(), 2u);
  ASSERT_EQ(found->doubtful.size(), 1u);  // 5.7 mm where the usual sherd has 800 mm2
  EXPECT_EQ(found->warnings, found->doubtful);
  EXPECT_NE(found->doubtful[0].english().find(
                "of the typical sherd's length was left out of the front side"),
            std::string::npos);
}

// A strip of a sherd's upper edge, 2 mm beside it: it cannot be a sherd, for it stands on nothing.
TEST(SplitScans, WhatHoversBesideASherdBelongsToIt) {
  PointCloud sherd = test::box(-60, 40, 60, 50, 9);
  PointCloud strip;
  for (float x = -55; x < -35; x += 0.5f)
    for (const float z : {5.f, 5.5f, 6.f, 6.5f}) {
      strip.points.emplace_back(x, 38.f, z);
      strip.normals.push_back(-Eigen::Vector3f::UnitY());
    }
  PointCloud cloud = sherd;
  test::append(cloud, test::box(30, -40, 30, 20, 5));
  const auto without = split(cloud);
  test::append(cloud, strip);
  const auto found = split(cloud);
  ASSERT_TRUE(without.has_value() && found.has_value());
  ASSERT_EQ(found->scans.size(), 2u);
  EXPECT_TRUE(found->warnings.empty());
  EXPECT_EQ(found->scans[0].cloud.size(), without->scans[0].cloud.size() + strip.size());
  EXPECT_EQ(found->scans[1].cloud.size(), without->scans[1].cloud.size());
}

// The same strip on the plate may be a sliver of its own.
TEST(SplitScans, WhatLiesOnThePlateBesideASherdIsNotJoinedToIt) {
  PointCloud cloud = test::box(-60, 40, 60, 50, 9);
  const auto without = split(cloud);
  test::append(cloud, test::box(-55, 34, 20, 3, 3));
  const auto found = split(cloud);
  ASSERT_TRUE(without.has_value() && found.has_value());
  EXPECT_EQ(found->scans[0].cloud.size(), without->scans[0].cloud.size());
}

TEST(SplitScans, NumbersDoNotDependOnTheOrderOfThePoints) {
  PointCloud cloud = plate();
  const auto a = split(cloud);
  std::vector<int> order(cloud.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(order.size() - 1 - i);
  const auto b = split(subset(cloud, order));
  ASSERT_TRUE(a.has_value() && b.has_value());
  ASSERT_EQ(a->scans.size(), b->scans.size());
  for (std::size_t k = 0; k < a->scans.size(); ++k) {
    EXPECT_EQ(a->scans[k].cloud.size(), b->scans[k].cloud.size());
  }
}

TEST(SplitScans, CutsTwoTouchingSherdsAtTheirNeckAndSaysSo) {
  PointCloud cloud = test::box(0, 0, 30, 25, 6);
  test::append(cloud, test::box(29, 21, 30, 25, 5));  // the corners overlap by 1 x 4 mm
  const auto found = split(cloud);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->scans.size(), 2u);
  ASSERT_FALSE(found->warnings.empty());
  EXPECT_NE(found->warnings[0].english().find("touch"), std::string::npos);
}

TEST(SplitScans, KeepsASherdWithAWaistWhole) {
  PointCloud cloud = test::box(0, 0, 30, 20, 6);
  test::append(cloud, test::box(30, 5, 6, 10, 6));  // a waist of half the width
  test::append(cloud, test::box(36, 0, 30, 20, 6));
  EXPECT_EQ(split(cloud)->scans.size(), 1u);
}

// A shadow's border that a mask holds: stereo finds it on the plate, with some noise above.
TEST(SplitScans, TakesANoisyStainOnThePlateForFlat) {
  PointCloud cloud = test::box(-60, 40, 30, 25, 6);
  PointCloud shadow = test::box(20, -40, 25, 20, 1);
  for (std::size_t i = 0; i < shadow.size(); i += 20) shadow.points[i].z() = 2.4f;
  test::append(cloud, shadow);
  const auto found = split(cloud);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->scans.size(), 1u);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_NE(found->warnings[0].english().find("flat"), std::string::npos);
}

TEST(SplitScans, SaysWhatIsWrongWithItsInput) {
  PointCloud bare = test::box(0, 0, 30, 25, 6);
  bare.normals.clear();
  EXPECT_EQ(split(bare).error().code, ErrorCode::UnusableInput);
  PointCloud low = test::box(0, 0, 30, 25, 0.1);
  EXPECT_EQ(split(low).error().code, ErrorCode::NotEnough);
}

}  // namespace
}  // namespace ostraka::scan
