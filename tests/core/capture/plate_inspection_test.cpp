#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "capture/shot_checks.h"
#include "tests/core/capture/looked_at.h"

namespace ostraka::capture {
namespace {

using testing::flatPicture;
using testing::flatPlate;
using testing::FlatScene;

TEST(LookAtPlate, FindsTheMarkersAndTheSherdsInTheirPlaces) {
  const PlateInspection inspection = lookAt({}, 1, 0);
  EXPECT_EQ(inspection.width, 640);
  EXPECT_EQ(inspection.markers_seen, 12);
  EXPECT_EQ(inspection.markers_on_plate, 12);
  ASSERT_EQ(inspection.sherds.size(), 3u);
  // In the order of the results, where flat_rig.h paints them; a map's pixel is 0.5 mm.
  const FlatScene painted;
  const std::size_t order[] = {1, 0, 2};  // at y = 50, 30 and -40
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(inspection.sherds[i].centre_mm.x(), painted.sherds[order[i]].x_mm, 0.7);
    EXPECT_NEAR(inspection.sherds[i].centre_mm.y(), painted.sherds[order[i]].y_mm, 0.7);
    EXPECT_FALSE(inspection.sherds[i].cut_off);
  }
  EXPECT_TRUE(inspection.too_close.empty());
}

TEST(LookAtPlate, SeesSherdsThatLieTooClose) {
  FlatScene scene;
  scene.width = 1280;
  scene.sherds = {{-30, 0, 15}, {4.5, 0, 15}, {-20, 60, 15}};
  const std::string picture = flatPicture(scene, 1, 0, "");
  InspectionOptions options;  // the gap is 4.5 mm, the others are far away
  const auto near = inspectPlate(picture, flatPlate(), options);
  ASSERT_TRUE(near.has_value());
  ASSERT_EQ(near->sherds.size(), 3u);
  ASSERT_EQ(near->too_close.size(), 1u);
  EXPECT_EQ(near->too_close[0], std::make_pair(1, 2));  // the row at y = 60 comes first
  options.too_close_mm = 3.5;  // the outlines lie within half a pixel of the map of the true ones
  EXPECT_TRUE(inspectPlate(picture, flatPlate(), options)->too_close.empty());
}

TEST(LookAtPlate, DoubtsAnOutlineThatLooksLikeTwoSherds) {
  FlatScene scene;
  scene.width = 1280;
  for (const double gap :
       {-8.0, -1.0, 0.0, 0.5, 1.0, 2.0}) {  // sherds that hide each other, touch, nearly do
    scene.sherds = {{-30, 0, 15}, {gap, 0, 15}, {-20, 60, 15}};
    const PlateInspection inspection = lookAt(scene, 1, 0);
    EXPECT_EQ(inspection.too_close.size(), 1u) << gap;
  }
}

TEST(LookAtPlate, SeesASherdThatTheFrameCutsOff) {
  FlatScene scene;
  scene.shift_mm = 150;
  scene.sherds = {{-60, 0, 15}, {98, 0, 15}};
  const PlateInspection inspection = lookAt(scene, 2, 0);
  ASSERT_EQ(inspection.sherds.size(), 2u);
  EXPECT_FALSE(inspection.sherds[0].cut_off);
  EXPECT_TRUE(inspection.sherds[1].cut_off);
}

TEST(LookAtPlate, FindsNothingOnAnEmptyPlate) {
  FlatScene scene;
  scene.sherds.clear();
  EXPECT_TRUE(lookAt(scene, 1, 0).sherds.empty());
}

TEST(LookAtPlate, MeasuresTheWidthOfEdges) {
  FlatScene blurred;
  blurred.blur_px = 2;
  const double sharp = lookAt({}, 1, 0).sharpness, wide = lookAt(blurred, 1, 0).sharpness;
  EXPECT_GT(sharp, 1);
  // Contrast over slope of an edge blurred by sigma is sigma times the root of 2 pi: 5.2 pixels.
  EXPECT_NEAR(wide, 5.2, 0.6);
  EXPECT_LT(sharp, 0.6 * wide);
}

// A picture of the plate, worse in a way that laboratories know.
using Worsen = std::function<void(cv::Mat3b&)>;

PlateInspection lookAtWorse(const Worsen& worsen) {
  FlatScene scene;
  scene.width = 1280;
  const std::string jpeg = flatPicture(scene, 1, 0, "");
  cv::Mat3b picture = cv::imdecode(std::vector<uchar>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
  worsen(picture);
  std::vector<uchar> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 92});
  const auto inspection =
      inspectPlate({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, flatPlate(), {});
  EXPECT_TRUE(inspection.has_value());
  return inspection ? *inspection : PlateInspection{};
}

// Twice the stops are four times the light; pixels hold its 2.2th root.
void expose(cv::Mat3b& picture, double stops) {
  picture.convertTo(picture, -1, std::pow(2, stops / 2.2));
}

// The corners of the worse picture against those of the good one, pixels.
void expectMarksInPlace(const PlateInspection& worse, double within_px) {
  const PlateInspection good = lookAtWorse([](cv::Mat3b&) {});
  ASSERT_EQ(good.marks.size(), 12u);
  ASSERT_EQ(worse.marks.size(), 12u);
  for (const PlateMark& mark : worse.marks) {
    const auto same = std::find_if(good.marks.begin(), good.marks.end(),
                                   [&](const PlateMark& other) { return other.id == mark.id; });
    ASSERT_NE(same, good.marks.end());
    ASSERT_TRUE(same->seen);
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_LT((mark.corners_px[c] - same->corners_px[c]).norm(), within_px) << mark.id;
  }
}

TEST(LookAtPlate, FindsTheMarkersTwoStopsTooDarkAndTwoTooBright) {
  for (const double stops : {-2.0, 2.0}) {
    const PlateInspection inspection =
        lookAtWorse([&](cv::Mat3b& picture) { expose(picture, stops); });
    EXPECT_EQ(inspection.markers_seen, 12) << stops;
    expectMarksInPlace(inspection,
                       2);  // burnt-out paper eats into the black: 1.5 px of a mark's 60
  }
}

TEST(LookAtPlate, FindsTheMarkersInABlurredPicture) {
  const PlateInspection inspection = lookAtWorse([](cv::Mat3b& picture) {
    cv::GaussianBlur(picture, picture, {0, 0}, 3);
  });
  EXPECT_GE(inspection.markers_seen, markersNeeded(12));
  expectMarksInPlace(inspection, 2);  // half of the blur
}

TEST(LookAtPlate, ShowsWhereTheMarkersAreThatGlareHides) {
  const PlateInspection good = lookAtWorse([](cv::Mat3b&) {});
  const Eigen::Vector2f at = good.marks[2].corners_px[0];
  const PlateInspection inspection = lookAtWorse([&](cv::Mat3b& picture) {
    cv::Mat3f glare(picture.size(), cv::Vec3f(0, 0, 0));
    cv::circle(glare, cv::Point(cvRound(at.x()), cvRound(at.y())), 70, {700, 700, 700}, cv::FILLED);
    cv::GaussianBlur(glare, glare, {0, 0}, 25);
    cv::Mat3f lit;
    picture.convertTo(lit, CV_32F);
    lit += glare;
    lit.convertTo(picture, CV_8U);
  });
  EXPECT_LT(inspection.markers_seen, 12);  // the light really hides one
  EXPECT_GE(inspection.markers_seen, markersNeeded(12));
  expectMarksInPlace(inspection, 1.5);
}

TEST(LookAtPlate, ShowsWhereTheMarkersAreWithAThirdOfThemHidden) {
  const PlateInspection good = lookAtWorse([](cv::Mat3b&) {});
  const std::vector<int> hidden{1, 4, 5, 9};
  const PlateInspection inspection = lookAtWorse([&](cv::Mat3b& picture) {
    for (const PlateMark& mark : good.marks) {
      if (std::find(hidden.begin(), hidden.end(), mark.id) == hidden.end()) continue;
      std::vector<cv::Point> cloth;
      for (const Eigen::Vector2f& p : mark.corners_px)
        cloth.emplace_back(cvRound(p.x()), cvRound(p.y()));
      cv::fillConvexPoly(picture, cloth, {90, 90, 90});
    }
  });
  EXPECT_EQ(inspection.markers_seen, 8);
  for (const PlateMark& mark : inspection.marks)
    EXPECT_EQ(mark.seen, std::find(hidden.begin(), hidden.end(), mark.id) == hidden.end())
        << mark.id;
  expectMarksInPlace(inspection, 1.5);  // of hidden ones: the plane through the others'
}

TEST(LookAtPlate, RefusesWhatIsCutOff) {
  std::string picture = flatPicture({}, 0, 0, "");
  picture.resize(picture.size() - 200);
  const auto inspection = inspectPlate(picture, flatPlate(), {});
  ASSERT_FALSE(inspection.has_value());
  EXPECT_EQ(inspection.error().code, ErrorCode::UnusableInput);
  EXPECT_FALSE(inspectPlate("", flatPlate(), {}).has_value());
}

}  // namespace
}  // namespace ostraka::capture
