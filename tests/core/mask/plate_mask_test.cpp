#include "mask/plate_mask.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <random>

namespace ostraka::mask {
namespace {

/// A plate of 120 mm with a mottled surface, twelve dark and light 'markers', a box of clay in the
/// middle, a lamp's falloff, and a soft shadow that stays with the room.
struct Scene {
  batch::Plate plate;
  std::vector<rig::PosedImage> images;
  std::vector<cv::Mat> photographs, truth;
  Eigen::AlignedBox3d box{Eigen::Vector3d(-14, -9, 0), Eigen::Vector3d(12, 11, 7)};
  int covered;  ///< that many markers lie under a cloth

  explicit Scene(double plate_grey, int covered_markers = 0) : covered(covered_markers) {
    plate.diameter_mm = 120;
    for (int k = 0; k < 12; ++k) {
      const Eigen::Rotation2Dd turn(k * M_PI / 6);
      batch::Marker marker{k, {}};
      const Eigen::Vector2d corners[4] = {{55, 5}, {55, -5}, {45, -5}, {45, 5}};
      for (int c = 0; c < 4; ++c) marker.corners[c] << turn * corners[c], 0;
      plate.markers.push_back(marker);
    }
    for (int stop = 0; stop < 8; ++stop) addShot(stop, plate_grey, 0, 0.75);
  }

  double mottle(const Eigen::Vector3d& p) const {
    return 1 + 0.06 * std::sin(1.3 * p.x() + 0.4 * p.y()) * std::cos(0.9 * p.y() - 0.3 * p.x());
  }

  double albedo(const Eigen::Vector3d& p, double grey) const {
    for (const batch::Marker& marker : plate.markers) {
      const Eigen::Vector3d middle = 0.5 * (marker.corners[0] + marker.corners[2]);
      const Eigen::Vector3d a = (marker.corners[0] - marker.corners[1]).normalized();
      const double u = std::abs((p - middle).dot(a));
      const double v = std::abs((p - middle).dot(a.cross(Eigen::Vector3d::UnitZ())));
      if (marker.id < covered && std::max(u, v) < 6.6) return 30 * mottle(p);
      if (std::max(u, v) < 5) return 18;
      if (std::max(u, v) < 6.6) return 200;
    }
    return grey * mottle(p);
  }

  void addShot(int stop, double grey, int camera, double tilt) {
    rig::PosedImage image;
    image.stop = stop;
    image.camera = camera;
    image.file = "cam" + std::to_string(camera) + "_pos0" + std::to_string(stop) + ".jpg";
    image.intrinsics = {400, 300, 780, 780, 199.5, 149.5, {}};
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(stop * M_PI / 4, Eigen::Vector3d::UnitZ()).matrix();
    image.camera_from_plate.linear() =
        Eigen::AngleAxisd(M_PI / 2 + tilt, Eigen::Vector3d::UnitX()) * turn;
    image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 300);
    const Eigen::Isometry3d back = image.camera_from_plate.inverse();
    std::mt19937 random(100 + stop);
    std::normal_distribution<double> noise(0, 1);
    cv::Mat photograph(300, 400, CV_8UC3), inside(300, 400, CV_8UC1, cv::Scalar(0));
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x) {
        int hits = 0;
        Eigen::Vector3d colour = Eigen::Vector3d::Zero();
        for (int s = 0; s < 4; ++s) {
          const Eigen::Vector2d n =
              image.intrinsics.unproject({x - 0.25 + 0.5 * (s % 2), y - 0.25 + 0.5 * (s / 2)});
          colour +=
              0.25 * ray(back.translation(), back.linear() * n.homogeneous(), turn, grey, hits);
        }
        for (int c = 0; c < 3; ++c)
          photograph.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uchar>(colour[c] + noise(random));
        if (hits >= 2) inside.at<uchar>(y, x) = 255;
      }
    images.push_back(image);
    photographs.push_back(photograph);
    truth.push_back(inside);
  }

  Eigen::Vector3d ray(const Eigen::Vector3d& eye, const Eigen::Vector3d& way,
                      const Eigen::Matrix3d& turn, double grey, int& hits) const {
    double enter = 0, leave = 1e9;
    int axis = 0;
    for (int k = 0; k < 3; ++k) {
      const double a = (box.min()[k] - eye[k]) / way[k], b = (box.max()[k] - eye[k]) / way[k];
      if (std::min(a, b) > enter) enter = std::min(a, b), axis = k;
      leave = std::min(leave, std::max(a, b));
    }
    if (enter < leave) {
      ++hits;
      const Eigen::Vector3d p = eye + enter * way;
      const double shade = (axis == 2 ? 1.0 : 0.7) *
                           (1 + 0.1 * std::sin(5 * p.x()) * std::sin(4 * p.y() + 3 * p.z()));
      return shade * Eigen::Vector3d(80, 110, 160);
    }
    const Eigen::Vector3d p = eye - eye.z() / way.z() * way;
    const double radius = p.head<2>().norm();
    if (way.z() >= 0 || radius > 60) return Eigen::Vector3d::Constant(30);
    const Eigen::Vector3d room = turn * p;  // the room stands still
    const double falloff = 1 + 0.004 * room.x();
    const Eigen::Vector3d lee = turn.transpose() * Eigen::Vector3d(5, 2, 0);
    const double depth = box.exteriorDistance(p - lee);
    const double shadow = 1 - 0.55 / (1 + std::exp((depth - 2) / 0.8));
    return Eigen::Vector3d::Constant(albedo(p, grey) * falloff * shadow);
  }
};

double intersectionOverUnion(const cv::Mat1b& mask, const cv::Mat& truth) {
  const cv::Mat inside = mask >= 128;
  return static_cast<double>(cv::countNonZero(inside & truth)) /
         std::max(1, cv::countNonZero(inside | truth));
}

class PlateMask : public testing::TestWithParam<double> {};

// At 0.4 mm per pixel the box is about 65 x 45 pixels: half a pixel of outline is 4 % of its area,
// and the scene's hard-edged pixels mix encoded values where a lens mixes light.
TEST_P(PlateMask, FindsTheBoxDespiteShadowAndFalloff) {
  const Scene scene(GetParam());
  QuietProgress quiet;
  const auto result = maskByPlate(scene.images, scene.photographs, scene.plate, {}, {}, quiet, {});
  ASSERT_TRUE(result.has_value()) << result.error().sentence();
  ASSERT_EQ(result->masks.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_GT(intersectionOverUnion(result->masks[i], scene.truth[i]), 0.94) << "stop " << i;
}

INSTANTIATE_TEST_SUITE_P(DarkAndLight, PlateMask, testing::Values(45.0, 90.0, 150.0));

// Each photograph of each pass moves the bar.
struct SmallSteps final : Progress {
  void report(std::int64_t done, std::int64_t total) override {
    const double now = static_cast<double>(done) / static_cast<double>(total);
    EXPECT_GE(now, before);
    largest = std::max(largest, now - before);
    before = now;
  }
  void note(NoteLevel, const Message&) override {}
  double before = 0, largest = 0;
};

TEST(PlateMasks, AreTheSameForAnyNumberOfThreads) {
  Scene scene(45);
  for (int stop = 0; stop < 3; ++stop) scene.addShot(stop, 45, 1, 1.05);  // so that heights count
  QuietProgress quiet;
  PlateMaskOptions options;
  SmallSteps steps;
  const auto one =
      maskByPlate(scene.images, scene.photographs, scene.plate, {}, options, steps, {});
  ASSERT_TRUE(one.has_value());
  EXPECT_LT(steps.largest, 0.1);
  EXPECT_EQ(steps.before, 1);
  for (const int threads : {3, 16}) {
    options.threads = threads;
    const auto many =
        maskByPlate(scene.images, scene.photographs, scene.plate, {}, options, quiet, {});
    ASSERT_TRUE(many.has_value());
    for (std::size_t i = 0; i < one->masks.size(); ++i)
      EXPECT_EQ(cv::countNonZero(one->masks[i] != many->masks[i]), 0)
          << threads << " threads, " << i;
  }
}

// As a hand beside the plate leaves it: 30 pixels across, in one photograph.
void castShadow(cv::Mat& photograph, const Eigen::Vector2d& middle) {
  for (int y = 0; y < photograph.rows; ++y)
    for (int x = 0; x < photograph.cols; ++x) {
      const double away = (Eigen::Vector2d(x, y) - middle).norm();
      photograph.at<cv::Vec3b>(y, x) *= 1 - 0.6 / (1 + std::exp((away - 15) / 3));
    }
}

TEST(PlateMasks, AShadowThatOnlyOnePhotographHasIsNamed) {
  Scene scene(90);
  castShadow(scene.photographs[3], scene.images[3].project({0, 34, 0}));
  QuietProgress quiet;
  const auto result = maskByPlate(scene.images, scene.photographs, scene.plate, {}, {}, quiet, {});
  ASSERT_TRUE(result.has_value()) << result.error().sentence();
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_THAT(result->warnings[0], testing::HasSubstr("cam0_pos03.jpg"));
  EXPECT_THAT(result->warnings[0], testing::Not(testing::HasSubstr("cam0_pos02.jpg")));
}

TEST(PlateMasks, TheSherdsOwnShadowIsNotNamed) {
  const Scene scene(90);
  QuietProgress quiet;
  const auto result = maskByPlate(scene.images, scene.photographs, scene.plate, {}, {}, quiet, {});
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->warnings.empty());
}

TEST(PlateMasks, AnEmptyPlateOfAnotherStopIsLeftAsideWithAWarning) {
  const Scene scene(45);
  QuietProgress quiet;
  std::vector<cv::Mat> empties{cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(45))};
  const auto result =
      maskByPlate(scene.images, scene.photographs, scene.plate, empties, {}, quiet, {});
  ASSERT_TRUE(result.has_value());
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_THAT(result->warnings[0], testing::HasSubstr("camera A"));
}

cv::Mat emptyPlateAtStop(int stop) {
  Scene scene(45);
  scene.box = Eigen::AlignedBox3d(Eigen::Vector3d(5000, 0, 0), Eigen::Vector3d(5001, 1, 1));
  scene.addShot(stop, 45, 0, 0.75);
  return scene.photographs.back();
}

TEST(PlateMasks, AClothOnAThirdOfTheMarkersIsNotTakenForATurnedPlate) {
  const Scene scene(45, 4);
  QuietProgress quiet;
  const std::vector<cv::Mat> right{emptyPlateAtStop(0)}, turned{emptyPlateAtStop(1)};
  const auto covered =
      maskByPlate(scene.images, scene.photographs, scene.plate, right, {}, quiet, {});
  ASSERT_TRUE(covered.has_value()) << covered.error().sentence();
  ASSERT_EQ(covered->warnings.size(), 1U);
  EXPECT_THAT(covered->warnings[0], testing::HasSubstr("covered markers in cam0_pos00.jpg"));
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_GT(intersectionOverUnion(covered->masks[i], scene.truth[i]), 0.94) << "stop " << i;
  Scene even(45);  // without the stop that the empty plate was taken at
  for (int stop = 7; stop > 0; stop -= 2)
    even.images.erase(even.images.begin() + stop),
        even.photographs.erase(even.photographs.begin() + stop);
  const auto refused =
      maskByPlate(even.images, even.photographs, even.plate, turned, {}, quiet, {});
  ASSERT_TRUE(refused.has_value());
  ASSERT_EQ(refused->warnings.size(), 1U);
  EXPECT_THAT(refused->warnings[0], testing::HasSubstr("shows the plate at none of the positions"));
}

TEST(PlateMasks, AnEmptyPlateAtAnyStopIsUsedWithoutAWord) {
  const Scene scene(45);
  QuietProgress quiet;
  for (const int stop : {0, 5}) {
    const std::vector<cv::Mat> empties{emptyPlateAtStop(stop)};
    const auto result =
        maskByPlate(scene.images, scene.photographs, scene.plate, empties, {}, quiet, {});
    ASSERT_TRUE(result.has_value()) << result.error().sentence();
    EXPECT_THAT(result->warnings, testing::IsEmpty());
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_GT(intersectionOverUnion(result->masks[i], scene.truth[i]), 0.94) << "stop " << i;
  }
}

TEST(PlateMasks, ATallSherdIsNotCutAtTheHullsTop) {
  const Scene tall(45);
  QuietProgress quiet;
  PlateMaskOptions low;
  low.height_mm = 3;  // the box is 7 mm high
  const auto result = maskByPlate(tall.images, tall.photographs, tall.plate, {}, low, quiet, {});
  ASSERT_TRUE(result.has_value()) << result.error().sentence();
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_GT(intersectionOverUnion(result->masks[i], tall.truth[i]), 0.9) << "stop " << i;
}

TEST(PlateMasks, APhotographOfAnotherSizeIsNamed) {
  Scene scene(45);
  scene.images[2].file = "cam0_pos02.jpg";
  scene.photographs[2] = scene.photographs[2](cv::Rect(0, 0, 200, 300)).clone();
  QuietProgress quiet;
  const auto result = maskByPlate(scene.images, scene.photographs, scene.plate, {}, {}, quiet, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(result.error().where, "cam0_pos02.jpg");
}

TEST(PlateMasks, TwoPhotographsAreNotEnough) {
  const Scene scene(45);
  QuietProgress quiet;
  const auto result =
      maskByPlate(std::span(scene.images).first(2), std::span(scene.photographs).first(2),
                  scene.plate, {}, {}, quiet, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::NotEnough);
}

TEST(PlateMasks, AStopRequestEndsInCancelled) {
  const Scene scene(45);
  QuietProgress quiet;
  std::stop_source source;
  source.request_stop();
  const auto result =
      maskByPlate(scene.images, scene.photographs, scene.plate, {}, {}, quiet, source.get_token());
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::mask
