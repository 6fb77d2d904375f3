#include "checks/known_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ostraka::checks {
namespace {

// Six views of a turning plate whose unit is a quarter of a millimetre.
constexpr double kUnit_mm = 0.25;

std::vector<rig::PosedImage> views(batch::Side side) {
  std::vector<rig::PosedImage> images;
  for (int k = 0; k < 6; ++k) {
    rig::PosedImage image;
    image.file = "/batch/top_images/cam1_image00" + std::to_string(k) + ".tif";
    image.side = side;
    image.intrinsics = {1600, 1200, 2000, 2000, 800, 600, {-0.1, 0.02, 0, 0, 0}};
    image.camera_from_plate = Eigen::Translation3d(0, 0, 500 / kUnit_mm) *
                              Eigen::AngleAxisd(2.4, Eigen::Vector3d::UnitX()) *
                              Eigen::AngleAxisd(k * std::numbers::pi / 9, Eigen::Vector3d::UnitZ());
    images.push_back(image);
  }
  return images;
}

batch::KnownLength marked(const std::vector<rig::PosedImage>& images, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, double length_mm) {
  batch::KnownLength known;
  known.side = images[0].side;
  known.length_mm = length_mm;
  for (const int k : {0, 3}) {
    const std::string name = std::filesystem::path(images[k].file).filename().string();
    known.ends[0].push_back({name, images[k].project(a)});
    known.ends[1].push_back({name, images[k].project(b)});
  }
  return known;
}

TEST(KnownScale, IsTheMarkedLengthOverTheFoundOne) {
  const auto images = views(batch::Side::Front);
  const Eigen::Vector3d a(-100, 20, 4), b(80, -40, 12);
  const auto known = marked(images, a, b, (a - b).norm() * kUnit_mm);
  const auto scale = scaleFromLengths(images, {known});
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->mm_per_unit, kUnit_mm, 1e-9);
  EXPECT_EQ(scale->lengths, 1);
}

TEST(KnownScale, TellsBySpreadThatTwoLengthsDisagree) {
  const auto images = views(batch::Side::Front);
  const Eigen::Vector3d a(-100, 20, 4), b(80, -40, 12);
  const double length_mm = (a - b).norm() * kUnit_mm;
  const auto scale = scaleFromLengths(
      images, {marked(images, a, b, length_mm), marked(images, a, b, 1.1 * length_mm)});
  ASSERT_TRUE(scale.has_value());
  EXPECT_GT(scale->relative_spread, 0.04);
}

TEST(KnownScale, TakesNoMarksOfTheOtherSideOrOfPhotographsWithoutAPose) {
  const auto images = views(batch::Side::Back);
  auto known = marked(images, {0, 0, 0}, {10, 0, 0}, 10);
  known.side = batch::Side::Front;
  EXPECT_FALSE(scaleFromLengths(images, {known}).has_value());
  known.side = batch::Side::Back;
  known.ends[1][1].file = "not_posed.tif";
  EXPECT_FALSE(scaleFromLengths(images, {known}).has_value());
}

// Two cameras 500 mm from the axis, one on +x and one on +y, both looking level at it: a pixel is
// half a millimetre there.
std::vector<rig::PosedImage> twoLevelImages() {
  std::vector<rig::PosedImage> images(2);
  images[0].camera_from_plate.linear() << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  images[1].camera_from_plate.linear() << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  for (int k = 0; k < 2; ++k) {
    images[k].file = "/batch/front/cam" + std::to_string(k) + "_pos00.jpg";
    images[k].intrinsics = {1600, 1200, 1000, 1000, 800, 600, {}};
    images[k].camera_from_plate.translation() = Eigen::Vector3d(0, 0, 500);
  }
  return images;
}

batch::KnownLength alongX(const std::vector<rig::PosedImage>& images, double length_mm) {
  batch::KnownLength known;
  known.length_mm = length_mm;
  for (const rig::PosedImage& image : images) {
    const std::string name = std::filesystem::path(image.file).filename().string();
    known.ends[0].push_back({name, image.project({-10, 0, 0})});
    known.ends[1].push_back({name, image.project({10, 0, 0})});
  }
  return known;
}

TEST(CheckLengths, TakeMarksWithoutScatterForRoundedToWholePixels) {
  const auto images = twoLevelImages();
  const auto checked = checkLengths(images, {alongX(images, 20.2), alongX(images, 21)});
  ASSERT_TRUE(checked[0] && checked[1]);
  EXPECT_NEAR(checked[0]->found_mm, 20, 1e-6);
  // Along x only the camera on +y sees: 0.5 mm a pixel, 1/sqrt(12) px, two ends. That it looks at
  // them by a fiftieth askew adds 2e-4 of it.
  EXPECT_NEAR(checked[0]->sd_mm, 0.5 * std::sqrt(2.0 / 12), 2e-4);
  EXPECT_FALSE(checked[0]->contradicts()) << "0.2 mm is one standard deviation";
  EXPECT_TRUE(checked[1]->contradicts()) << "1 mm is nearly five";
}

TEST(CheckLengths, LearnFromTheRaysHowWellAPersonMarked) {
  const auto images = twoLevelImages();
  batch::KnownLength known = alongX(images, 21);
  for (auto& end : known.ends) {
    end[0].pixel.y() += 1;  // the cameras disagree by two pixels about the height of both ends
    end[1].pixel.y() -= 1;
  }
  const auto checked = checkLengths(images, {known});
  ASSERT_TRUE(checked[0].has_value());
  // Four misses of a pixel, two degrees of freedom: sqrt(2) px a coordinate, 0.5 mm, two ends: 1
  // mm.
  EXPECT_NEAR(checked[0]->sd_mm, 1.0, 2e-3);
  EXPECT_FALSE(checked[0]->contradicts()) << "what was marked so badly contradicts nothing";
}

TEST(CheckLengths, HaveNothingForAnEndWithoutTwoPosedPhotographs) {
  const auto images = twoLevelImages();
  batch::KnownLength known = alongX(images, 20);
  known.ends[1][1].file = "not_posed.jpg";
  const auto checked = checkLengths(images, {known, alongX(images, 20)});
  ASSERT_EQ(checked.size(), 2u);
  EXPECT_FALSE(checked[0].has_value());
  EXPECT_TRUE(checked[1].has_value());
}

TEST(CheckLengths, ContradictBeyondThreeDeviationsAndThreeThousandths) {
  const auto is_off = [](double found_mm, double sd_mm) {
    return CheckedLength{batch::Side::Front, 100, found_mm, sd_mm}.contradicts();
  };
  EXPECT_FALSE(is_off(100.29, 0.01));
  EXPECT_TRUE(is_off(100.31, 0.01));
  EXPECT_TRUE(is_off(99.69, 0.10));
  EXPECT_FALSE(is_off(99.69, 0.11));
}

TEST(KnownScale, ComesFromABoardBesideTheSherds) {
  const auto images = views(batch::Side::Front);
  // A board of 5 x 4 corners, 12 mm apart, lying askew on the plate.
  const Eigen::Isometry3d plate_from_board =
      Eigen::Translation3d(30, -50, 2) * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
  std::vector<calibration::TargetView> seen(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
    for (int x = 0; x < 5; ++x)
      for (int y = 0; y < 4; ++y) {
        if ((x + y + static_cast<int>(i)) % 5 == 0) continue;  // not every corner in every view
        const Eigen::Vector3d at(12.0 * x, 12.0 * y, 0);
        seen[i].points.push_back(at);
        // A tenth of a pixel of noise, alternating.
        const double error_px = (x + 2 * y + static_cast<int>(i)) % 2 ? 0.1 : -0.1;
        seen[i].pixels.push_back(images[i].project(plate_from_board * (at / kUnit_mm)) +
                                 Eigen::Vector2d(error_px, -error_px));
      }
  const auto scale = scaleFromBoard(images, seen);
  ASSERT_TRUE(scale.has_value());
  // 0.1 px is 0.025 mm at 500 mm and 2000 px; over 48 mm and 190 pairs that is far below 0.1 %.
  EXPECT_NEAR(scale->mm_per_unit / kUnit_mm, 1, 1e-3);
  EXPECT_EQ(scale->lengths, 20 * 19 / 2);
  seen.resize(1);
  EXPECT_FALSE(scaleFromBoard(images, seen).has_value()) << "one view gives no depth";
}

TEST(KnownScale, DoesNotTriangulateNearlyParallelRays) {
  const auto images = views(batch::Side::Front);
  const Eigen::Vector3d p(10, 20, 3);
  EXPECT_FALSE(triangulate({{&images[0], images[0].project(p)}}).has_value());
  EXPECT_FALSE(
      triangulate({{&images[0], images[0].project(p)}, {&images[0], images[0].project(p)}}));
  const auto found =
      triangulate({{&images[0], images[0].project(p)}, {&images[2], images[2].project(p)}});
  ASSERT_TRUE(found.has_value());
  EXPECT_LT((*found - p).norm(), 1e-6);
}

}  // namespace
}  // namespace ostraka::checks
