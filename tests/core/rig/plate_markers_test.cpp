#include "rig/plate_markers.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "rig/marker_dictionary.h"

namespace ostraka::rig {
namespace {

constexpr int kSide = 84;  // pixels of a marker

struct Laid {
  int id, x, y;
};

// Markers on white paper, blurred in linear light, then stored by the sRGB curve.
cv::Mat laid(std::initializer_list<Laid> markers) {
  cv::Mat1f light(420, 640, 0.6f);
  for (const Laid& one : markers) {
    cv::Mat cells;
    cv::aruco::drawMarker(*markerDictionary("DICT_4X4_50"), one.id, kSide, cells, 1);
    cv::Mat ink;
    cells.convertTo(ink, CV_32F, 0.58 / 255, 0.02);
    ink.copyTo(light(cv::Rect(one.x, one.y, kSide, kSide)));
  }
  cv::GaussianBlur(light, light, {}, 1.0);
  cv::Mat1b grey(light.size());
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x)
      grey(y, x) =
          cv::saturate_cast<unsigned char>(255 * (1.055 * std::pow(light(y, x), 1 / 2.4f) - 0.055));
  return grey;
}

batch::Plate plateOf(const std::vector<int>& ids) {
  batch::Plate plate;
  plate.dictionary = "DICT_4X4_50";
  for (const int id : ids) plate.markers.push_back({id, {}});
  return plate;
}

TEST(PlateMarkers, AreThePlatesOwnInTheOrderOfTheirIds) {
  const auto seen =
      *findPlateMarkers(laid({{9, 40, 50}, {3, 400, 60}, {7, 220, 260}}), plateOf({3, 5, 9}));
  ASSERT_EQ(seen.size(), 2u) << "7 is of another plate, 5 is covered";
  EXPECT_EQ(seen[0].id, 3);
  EXPECT_EQ(seen[1].id, 9);
  // Integer coordinates are pixel centres, so an edge lies half a pixel before its first pixel.
  const Quad nine{Eigen::Vector2d(39.5, 49.5), Eigen::Vector2d(39.5 + kSide, 49.5),
                  Eigen::Vector2d(39.5 + kSide, 49.5 + kSide), Eigen::Vector2d(39.5, 49.5 + kSide)};
  for (std::size_t c = 0; c < 4; ++c)
    EXPECT_LT((seen[1].corners[c] - nine[c]).norm(), 0.1) << "corner " << c;
  EXPECT_LT(seen[1].sd_px, 0.1) << "by its edges";
}

// One of the two is a print that lies about, and nothing tells which.
TEST(PlateMarkers, AnIdThatIsSeenTwiceCountsForNeither) {
  const auto seen =
      *findPlateMarkers(laid({{5, 40, 50}, {3, 400, 60}, {5, 220, 260}}), plateOf({3, 5, 9}));
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].id, 3);
}

TEST(PlateMarkers, OfAnUnknownDictionaryAreAnError) {
  batch::Plate plate = plateOf({3});
  plate.dictionary = "DICT_9X9";
  EXPECT_EQ(findPlateMarkers(laid({{3, 40, 50}}), plate).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::rig
