#include "rig/edge_width.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ostraka::rig {
namespace {

constexpr double kFrom = 30, kTo = 70;
const std::array<Eigen::Vector2d, 4> kSquare{Eigen::Vector2d(kFrom, kFrom),
                                             Eigen::Vector2d(kTo, kFrom), Eigen::Vector2d(kTo, kTo),
                                             Eigen::Vector2d(kFrom, kTo)};

// A dark square whose edges are ramps of this many pixels about its outline.
cv::Mat1b ramped(double width, double paper, double ink) {
  cv::Mat1b grey(100, 100);
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) {
      const double inside = std::min({x - kFrom, kTo - x, y - kFrom, kTo - y});
      const double share = 0.5 + std::clamp(inside / width, -0.5, 0.5);
      grey(y, x) = cv::saturate_cast<unsigned char>(paper + share * (ink - paper));
    }
  return grey;
}

TEST(EdgeWidths, AreThoseOfTheRampsOnAllFourSides) {
  for (const double width : {4.0, 6.0, 8.0}) {
    const std::vector<double> widths = edgeWidths(ramped(width, 220, 20), kSquare);
    EXPECT_EQ(widths.size(), 12u);
    for (const double one : widths) EXPECT_NEAR(one, width, 0.1);  // rounded to whole grey values
  }
}

TEST(EdgeWidths, DoNotDependOnTheContrast) {
  EXPECT_NEAR(typicalWidth(edgeWidths(ramped(6, 250, 5), kSquare)),
              typicalWidth(edgeWidths(ramped(6, 160, 60), kSquare)), 0.2);
}

TEST(EdgeWidths, AreNoneWhereThereIsNoEdgeOrNoPicture) {
  EXPECT_TRUE(edgeWidths(ramped(6, 120, 120), kSquare).empty());
  EXPECT_TRUE(edgeWidths(ramped(6, 120, 95), kSquare).empty()) << "a shadow is not ink";
  std::array<Eigen::Vector2d, 4> outside = kSquare;
  for (Eigen::Vector2d& corner : outside) corner.x() -= 32;  // its left side is off the picture
  const cv::Mat1b grey = ramped(6, 220, 20)(cv::Rect(32, 0, 68, 100)).clone();
  EXPECT_EQ(edgeWidths(grey, outside).size(), 9u);
}

TEST(EdgeWidths, OfTooFewPlacesTellNothing) {
  EXPECT_EQ(typicalWidth(std::vector<double>(11, 4.0)), 0);
  std::vector<double> widths(11, 4.0);
  widths.push_back(90);  // where something lies across the edge
  EXPECT_EQ(typicalWidth(widths), 4);
}

}  // namespace
}  // namespace ostraka::rig
