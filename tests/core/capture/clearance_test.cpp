#include "capture/clearance.h"

#include <gtest/gtest.h>

#include <numbers>
#include <opencv2/imgproc.hpp>

#include "capture/silhouettes.h"

namespace ostraka::capture {
namespace {

// A bare plate whose free disc has a radius of 100 mm, all of it seen.
PlateMap bare() {
  PlateMap map;
  map.radius_mm = 100;
  map.seen = cv::Mat1b(400, 400, uchar{255});
  map.sherd = cv::Mat1b(400, 400, uchar{0});
  return map;
}

MapPiece disc(PlateMap& map, const Eigen::Vector2d& centre, double radius) {
  MapPiece piece;
  piece.centre_mm = centre;
  piece.extent_mm = 2 * radius;
  for (int k = 0; k < 60; ++k) {
    const double t = 2 * std::numbers::pi * k / 60;
    piece.outline.emplace_back(cvRound((centre.x() + radius * std::cos(t) + 100) * 2),
                               cvRound((100 - centre.y() - radius * std::sin(t)) * 2));
  }
  cv::fillPoly(map.sherd, std::vector<std::vector<cv::Point>>{piece.outline}, 255);
  return piece;
}

TEST(Clearance, OfABarePlateHoldsAsManyDiscsAsARingOfThem) {
  // Discs of 50 mm, 12 mm apart: their middles lie within 75 mm and 62 mm from each other. Seven
  // (six around one) are the most: 2 * 75 * sin(pi / 6) = 75 >= 62, and with seven around one
  // 2 * 75 * sin(pi / 7) = 65 >= 62: eight.
  const Clearance room = clearance(bare(), {});
  EXPECT_EQ(room.extent_mm, 50);
  EXPECT_GE(room.places.size(), 6u);
  EXPECT_LE(room.places.size(), 8u);
  for (std::size_t i = 0; i < room.places.size(); ++i) {
    EXPECT_LE(room.places[i].norm(), 77) << i;  // a step of 2 mm
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GE((room.places[i] - room.places[k]).norm(), 58) << i << " " << k;
  }
}

TEST(Clearance, KeepsAwayFromWhatLiesThere) {
  PlateMap map = bare();
  const MapPiece middle = disc(map, {0, 0}, 20);
  const Clearance room = clearance(map, {middle});
  EXPECT_NEAR(room.extent_mm, 40, 0.1);
  EXPECT_GE(room.places.size(), 6u);
  for (const Eigen::Vector2d& place : room.places) EXPECT_GE(place.norm(), 20 + 12 + 20 - 4);
}

TEST(Clearance, ThereIsNoneOnAFullPlateNorWhereNothingIsSeen) {
  PlateMap full = bare();
  const MapPiece large = disc(full, {0, 0}, 60);
  EXPECT_TRUE(clearance(full, {large}).places.empty());  // sherds of 120 mm
  PlateMap hidden = bare();
  hidden.seen.setTo(0);
  EXPECT_TRUE(clearance(hidden, {}).places.empty());
  EXPECT_TRUE(clearance({}, {}).places.empty());
}

TEST(Clearance, OfAnEvenNumberTheSmallerMiddleCounts) {
  PlateMap map = bare();
  const MapPiece large = disc(map, {0, 50}, 42), small = disc(map, {-60, -20}, 14),
                 larger = disc(map, {0, -50}, 45), middle = disc(map, {60, -20}, 15);
  EXPECT_NEAR(clearance(map, {large, small, larger, middle}).extent_mm, 30, 0.1);
}

TEST(Clearance, FollowsTheSizeOfTheSherds) {
  PlateMap small = bare(), large = bare();
  const Clearance many = clearance(small, {disc(small, {-60, 0}, 13)});
  const Clearance few = clearance(large, {disc(large, {-60, 0}, 30)});
  EXPECT_GT(many.places.size(), 2 * few.places.size());
}

}  // namespace
}  // namespace ostraka::capture
