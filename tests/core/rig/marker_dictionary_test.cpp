#include "rig/marker_dictionary.h"

#include <gmock/gmock.h>

#include <random>

namespace ostraka::rig {
namespace {

// Ink lies to the right of its lines, seen with y downwards: holes count against it.
double areaOf(const std::vector<std::vector<Eigen::Vector2d>>& lines) {
  double doubled = 0;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Eigen::Vector2d &a = line[i], &b = line[(i + 1) % line.size()];
      doubled += a.x() * b.y() - b.x() * a.y();
    }
  return doubled / 2;
}

// By the even-odd rule, as printers fill.
bool inkAt(const Shape& shape, const Eigen::Vector2d& p) {
  bool ink = false;
  for (const auto& line : shape.lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Eigen::Vector2d &a = line[i], &b = line[(i + 1) % line.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) ink = !ink;
    }
  return ink;
}

TEST(MarkerDictionary, IsKnownByOpenCvsNameAlone) {
  EXPECT_EQ((*markerDictionary("DICT_4X4_100"))->markerSize, 4);
  EXPECT_EQ((*markerDictionary("DICT_4X4_100"))->bytesList.rows, 100);
  EXPECT_EQ((*markerDictionary("DICT_APRILTAG_36h11"))->markerSize, 6);
  for (const char* name : {"", "DICT_9X9", "dict_4x4_100", "DICT_4X4_100 "}) {
    const auto unknown = markerDictionary(name);
    ASSERT_FALSE(unknown) << name;
    EXPECT_EQ(unknown.error().code, ErrorCode::UnusableInput);
  }
}

TEST(OutlinesOfInk, GoAroundEachPatchAndEachHole) {
  cv::Mat1b cells(3, 3, static_cast<unsigned char>(0));
  cells(1, 1) = 255;
  const auto ring = outlinesOfInk(cells);
  ASSERT_EQ(ring.size(), 2u);
  EXPECT_EQ(areaOf(ring), 8);
  EXPECT_TRUE(outlinesOfInk(cv::Mat1b(2, 2, static_cast<unsigned char>(255))).empty());
  const auto one = outlinesOfInk(cv::Mat1b(1, 1, static_cast<unsigned char>(127)));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_THAT(one[0], testing::UnorderedElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0),
                                                    Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 1)));
}

// Patches that touch at a corner, too.
TEST(OutlinesOfInk, HoldAsMuchInkAsThePicture) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    cv::Mat1b cells(7, 9);
    int ink = 0;
    for (unsigned char& cell : cells) ink += (cell = random() % 2 != 0 ? 255 : 0) == 0 ? 1 : 0;
    EXPECT_EQ(areaOf(outlinesOfInk(cells)), ink) << "trial " << trial;
  }
}

// The bits of OpenCV's DICT_4X4_50, id 0, white is 1: 181 and 50.
constexpr std::array<std::array<int, 4>, 4> kFirstMarker{
    {{1, 0, 1, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, 1, 0}}};

TEST(MarkerInk, HasTheMarkersBitsBetweenItsCorners) {
  const std::array<Eigen::Vector2d, 4> corners{Eigen::Vector2d(10, 20), Eigen::Vector2d(40, 20),
                                               Eigen::Vector2d(40, 50), Eigen::Vector2d(10, 50)};
  const Shape shape = markerInk(*markerDictionary("DICT_4X4_50"), 0, corners);
  EXPECT_TRUE(shape.closed);
  EXPECT_NEAR(areaOf(shape.lines), 28 * 25, 1e-9) << "8 of 36 cells of 5 by 5 mm are white";
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const bool white =
          kFirstMarker[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == 1;
      const Eigen::Vector2d middle(10 + 5 * (column + 1.5), 20 + 5 * (row + 1.5));
      EXPECT_EQ(inkAt(shape, middle), !white) << row << ", " << column;
    }
  // Upside down: the first corner is the marker's own, not the paper's.
  const Shape turned = markerInk(*markerDictionary("DICT_4X4_50"), 0,
                                 {corners[2], corners[3], corners[0], corners[1]});
  EXPECT_FALSE(inkAt(turned, {40 - 7.5, 50 - 7.5}));
  EXPECT_TRUE(inkAt(turned, {40 - 12.5, 50 - 7.5}));
}

TEST(BoardInk, HasWholeSquaresAndMarkersInTheMiddleOfTheOthers) {
  const std::vector<Shape> shapes = boardInk({"DICT_4X4_50", 5, 4, 10, 7});
  ASSERT_EQ(shapes.size(), 20u);
  int squares = 0;
  const Shape* first = nullptr;
  for (const Shape& shape : shapes) {
    const bool whole = std::abs(areaOf(shape.lines) - 100) < 1e-9;
    squares += whole ? 1 : 0;
    if (!whole && first == nullptr) first = &shape;
  }
  EXPECT_EQ(squares, 10);
  ASSERT_NE(first, nullptr);
  EXPECT_NEAR(areaOf(first->lines), 49 * 28 / 36.0, 1e-9) << "id 0";
  Eigen::AlignedBox2d box;
  for (const auto& line : first->lines)
    for (const Eigen::Vector2d& p : line) box.extend(p);
  EXPECT_NEAR(std::fmod(box.min().x(), 10), 1.5, 1e-9);
  EXPECT_NEAR(box.min().y(), 1.5, 1e-9);
  EXPECT_NEAR(box.sizes().x(), 7, 1e-9);
}

}  // namespace
}  // namespace ostraka::rig
