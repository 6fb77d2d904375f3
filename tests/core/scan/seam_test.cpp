#include "scan/seam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ostraka::scan {
namespace {

constexpr int kColumns = 42, kRows = 22;  // with a free border
constexpr int kBreak = 18;                // the last column before the surface breaks off

Plan wholePlan() {
  Plan plan;
  plan.filled = cv::Mat1b(kRows, kColumns, uchar{0});
  plan.filled(cv::Rect(1, 1, kColumns - 2, kRows - 2)) = 255;
  return plan;
}

// A surface whose height depends on the column, mm; its normals point upwards, tilted by the slope.
SeenSurface surfaceOf(
    const std::function<double(int)>& height_mm,
    const std::function<double(int)>& slope = [](int) { return 0.0; }) {
  SeenSurface surface{cv::Mat1f(kRows, kColumns, std::numeric_limits<float>::quiet_NaN()),
                      cv::Mat3f(kRows, kColumns, cv::Vec3f())};
  for (int y = 1; y + 1 < kRows; ++y)
    for (int x = 1; x + 1 < kColumns; ++x) {
      surface.height_mm(y, x) = static_cast<float>(height_mm(x));
      const Eigen::Vector3f n = Eigen::Vector3d(-slope(x), 0, 1).normalized().cast<float>();
      surface.normal(y, x) = {n.x(), n.y(), n.z()};
    }
  return surface;
}
double flat(int) {
  return 5;
}
double step(int x) {
  return x <= kBreak ? 5 : 3;
}

// Cores in the third columns from the left and the right.
cv::Mat1i twoCores() {
  cv::Mat1i cores(kRows, kColumns, 0);
  cores(cv::Rect(3, 1, 1, kRows - 2)) = 1;
  cores(cv::Rect(38, 1, 1, kRows - 2)) = 2;
  return cores;
}

// The two parts, where the left one ends behind a column.
cv::Mat1i partsUpTo(int column) {
  cv::Mat1i parts(kRows, kColumns, 0);
  parts(cv::Rect(1, 1, kColumns - 2, kRows - 2)) = 2;
  parts(cv::Rect(1, 1, column, kRows - 2)) = 1;
  return parts;
}

TEST(Plan, TellsTheCellOfAPoint) {
  Plan plan;
  plan.origin = {10, 20};
  EXPECT_EQ(plan.cellOf({11.2f, 20.6f, 7}), cv::Point(2, 1));
}

TEST(SurfaceFromAbove, IsTheMeanOfTheUppermostLayer) {
  const Plan plan = wholePlan();
  PointCloud piece;
  for (const float z : {2.f, 5.f, 4.7f}) piece.points.emplace_back(1.2f, 1.1f, z);
  piece.normals = {{0, 0, -1}, {1, 0, 0}, {0, 0, 1}};
  const SeenSurface seen = surfaceFromAbove(piece, plan);
  EXPECT_NEAR(seen.height_mm(2, 2), 4.85, 1e-5) << "what lies 3 mm below is another surface";
  EXPECT_NEAR(seen.normal(2, 2)[0], std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(seen.normal(2, 2)[2], std::sqrt(0.5), 1e-5);
  EXPECT_TRUE(std::isnan(seen.height_mm(5, 5)));
}

TEST(PartsReached, MeetInTheMiddleOrWhereTheSurfaceBreaksOff) {
  const Plan plan = wholePlan();
  const SeenSurface smooth = surfaceOf(flat), broken = surfaceOf(step);
  for (const SeenSurface* surface : {static_cast<const SeenSurface*>(nullptr), &smooth}) {
    const cv::Mat1i parts = partsReached(plan, twoCores(), surface);
    EXPECT_EQ(parts(10, 20), 1);
    EXPECT_EQ(parts(10, 21), 2);
  }
  const cv::Mat1i parts = partsReached(plan, twoCores(), &broken);
  for (int y = 1; y + 1 < kRows; ++y) {
    EXPECT_EQ(parts(y, kBreak), 1);
    EXPECT_EQ(parts(y, kBreak + 1), 2);
  }
  EXPECT_EQ(parts(0, 5), 0) << "nothing is beside the piece";
}

TEST(Seam, IsTheLastColumnOfTheFirstPart) {
  const std::vector<cv::Point> seam = seamBetween(partsUpTo(kBreak), 1, 2);
  ASSERT_EQ(seam.size(), static_cast<std::size_t>(kRows - 2));
  for (const cv::Point& p : seam) EXPECT_EQ(p.x, kBreak);
  EXPECT_EQ(seamBetween(partsUpTo(kBreak), 2, 1).front().x, kBreak + 1);
  EXPECT_TRUE(seamBetween(partsUpTo(kBreak), 1, 3).empty());
}

TEST(BrokenShare, IsAllOfAStepAKinkOrAGrooveAndNothingOfASmoothFace) {
  const cv::Mat1i parts = partsUpTo(kBreak);
  EXPECT_EQ(brokenShare(parts, 1, 2, surfaceOf(flat)), 0);
  EXPECT_EQ(brokenShare(parts, 1, 2, surfaceOf(step)), 1);
  EXPECT_EQ(brokenShare(parts, 1, 2, surfaceOf([](int x) { return x == kBreak ? 4.0 : 5.0; })), 1)
      << "a groove of a millimetre";
  EXPECT_EQ(brokenShare(parts, 1, 2, surfaceOf([](int x) { return x == kBreak ? 4.7 : 5.0; })), 0)
      << "a scratch";
  // A roof: 15 degrees up, then 15 degrees down; and a slope that goes on.
  const double slope = std::tan(15 * M_PI / 180);
  EXPECT_EQ(brokenShare(parts, 1, 2,
                        surfaceOf([&](int x) { return -slope * 0.5 * std::abs(x - kBreak - 0.5); },
                                  [&](int x) { return x <= kBreak ? slope : -slope; })),
            1);
  EXPECT_EQ(
      brokenShare(parts, 1, 2,
                  surfaceOf([&](int x) { return slope * 0.5 * x; }, [&](int) { return slope; })),
      0);
}

TEST(BrokenShare, OfPartsThatDoNotMeetIsOneAndOfAnUnseenSurfaceNothing) {
  EXPECT_EQ(brokenShare(partsUpTo(kBreak), 1, 3, surfaceOf(flat)), 1);
  SeenSurface unseen = surfaceOf(flat);
  unseen.height_mm = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(brokenShare(partsUpTo(kBreak), 1, 2, unseen), 0);
}

}  // namespace
}  // namespace ostraka::scan
