#include "checks/photo_checks.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/core/files/temporary_folder.h"

namespace ostraka::checks {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A white plate with ten black markers of 20 mm in a ring, seen from straight above: 2 pixels a mm.
class PhotoChecks : public testing::Test {
 protected:
  void SetUp() override {
    for (int k = 0; k < 10; ++k) {
      const double angle = 2 * std::numbers::pi * k / 10;
      const Eigen::Vector3d middle(120 * std::cos(angle), 120 * std::sin(angle), 0);
      batch::Marker marker;
      marker.id = k + 20;
      marker.corners = {middle + Eigen::Vector3d(-10, 10, 0), middle + Eigen::Vector3d(10, 10, 0),
                        middle + Eigen::Vector3d(10, -10, 0),
                        middle + Eigen::Vector3d(-10, -10, 0)};
      plate_.markers.push_back(marker);
    }
  }

  void photograph(batch::Side side, int stop, double blur_px, std::size_t covered = 0) {
    rig::PosedImage image;
    image.file = (folder_ / (std::string(batch::name(side)) + std::to_string(stop) + ".png"));
    image.side = side;
    image.stop = stop;
    image.intrinsics = {600, 600, 1000, 1000, 299.5, 299.5, {}};
    image.camera_from_plate.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
    image.camera_from_plate.translation().z() = 500;
    // Eight times as large and made smaller, so that an edge is as wide as a pixel.
    cv::Mat1b large(4800, 4800, uchar{220});
    for (std::size_t m = covered; m < plate_.markers.size(); ++m) {
      std::vector<cv::Point> corners;
      for (const Eigen::Vector3d& corner : plate_.markers[m].corners) {
        const Eigen::Vector2d p = 8 * (image.project(corner).array() + 0.5) - 0.5;
        corners.emplace_back(cvRound(p.x()), cvRound(p.y()));
      }
      cv::fillConvexPoly(large, corners, 30);
    }
    cv::Mat1b picture;
    cv::resize(large, picture, {600, 600}, 0, 0, cv::INTER_AREA);
    for (std::size_t m = 0; m < covered; ++m)  // by cloth with a weave
      for (int k = 0; k < 3600; ++k) {
        const Eigen::Vector2d p = image.project(plate_.markers[m].corners[0]);
        picture(cvRound(p.y()) + k / 60 - 10, cvRound(p.x()) + k % 60 - 10) =
            static_cast<uchar>(90 + (k * 37 + k / 60 * 11) % 70);
      }
    if (blur_px > 0) cv::GaussianBlur(picture, picture, {}, blur_px);
    cv::imwrite(image.file, picture);
    images_.push_back(image);
  }
  Result<PhotoFindings> check() const {
    return checkPhotographs(images_, plate_, {.threads = 2}, {});
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
  batch::Plate plate_;
  std::vector<rig::PosedImage> images_;
};

TEST_F(PhotoChecks, SayNothingOfGoodPhotographs) {
  for (int stop = 0; stop < 3; ++stop) photograph(batch::Side::Front, stop, 0.4 + 0.05 * stop);
  const auto found = check();
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_THAT(found->warnings, IsEmpty());
}

TEST_F(PhotoChecks, LeaveOutTheBlurredOneAndNameIt) {
  for (const double blur_px : {0.4, 1.6, 0.4, 0.4})
    photograph(batch::Side::Front, static_cast<int>(images_.size()), blur_px);
  photograph(batch::Side::Back, 0, 0.4);
  const auto found = check();
  ASSERT_TRUE(found.has_value());
  // A step blurred by sigma rises over sigma sqrt(2 pi): 4.0 pixels at 1.6.
  EXPECT_THAT(found->warnings, ElementsAre(AllOf(HasSubstr("front1.png"), HasSubstr("blurred"),
                                                 HasSubstr("retake it"))));
  EXPECT_THAT(found->spoilt, ElementsAre(1U));
}

TEST_F(PhotoChecks, SayOnceThatAllOfASideAreBlurred) {
  for (int stop = 0; stop < 3; ++stop) photograph(batch::Side::Front, stop, 3.5);
  photograph(batch::Side::Back, 0, 3.5);
  images_.back().camera = 1;
  // Edges of 3.5 sqrt(2 pi) = 8.8 pixels, of which a window beside the margin shows 8.
  const auto found = check();
  ASSERT_TRUE(found.has_value());
  EXPECT_THAT(found->warnings,
              ElementsAre(AllOf(HasSubstr("All photographs of the front side are blurred"),
                                HasSubstr(" 8 pixels")),
                          HasSubstr("back side")));
  EXPECT_THAT(found->spoilt, IsEmpty());
  // Used at a quarter of the pixels they are as sharp as any.
  const auto small = checkPhotographs(images_, plate_, {.megapixels = 0.09, .threads = 2}, {});
  ASSERT_TRUE(small.has_value());
  EXPECT_THAT(small->warnings, IsEmpty());
}

// Of two telephones, the one with four times the pixels shows an edge twice as wide.
TEST_F(PhotoChecks, CompareByHandPhotographsOfOneSizeOnly) {
  for (int shot = 0; shot < 4; ++shot) photograph(batch::Side::Front, shot, 0.8);
  const cv::Mat picture = cv::imread(images_[3].file);
  cv::Mat large;
  cv::resize(picture, large, {1200, 1200}, 0, 0, cv::INTER_CUBIC);
  cv::imwrite(images_[3].file, large);
  images_[3].intrinsics = rig::reduced(images_[3].intrinsics, 1200, 1200);
  const auto found = checkPhotographs(images_, plate_, {.one_camera = true, .threads = 2}, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_THAT(found->warnings, IsEmpty());
  EXPECT_THAT(found->spoilt, IsEmpty());
  // One of the same size is compared.
  photograph(batch::Side::Front, 4, 1.6);
  const auto blurred = checkPhotographs(images_, plate_, {.one_camera = true, .threads = 2}, {});
  ASSERT_TRUE(blurred.has_value());
  EXPECT_THAT(blurred->spoilt, ElementsAre(4U));
}

TEST_F(PhotoChecks, LeaveAllInUseWhereManyAreBlurred) {
  for (const double blur_px : {0.4, 1.6, 1.6, 0.4})
    photograph(batch::Side::Front, static_cast<int>(images_.size()), blur_px);
  const auto found = check();
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->warnings.size(), 2U);
  EXPECT_THAT(found->spoilt, IsEmpty());
}

TEST_F(PhotoChecks, NameTheMarkersThatNoPhotographOfASideShows) {
  photograph(batch::Side::Front, 0, 0.4, 3);
  photograph(batch::Side::Front, 1, 0.4, 2);
  photograph(batch::Side::Back, 0, 0.4, 3);
  photograph(batch::Side::Back, 1, 0.4);
  const auto found = check();
  ASSERT_TRUE(found.has_value());
  EXPECT_THAT(found->warnings, ElementsAre(AllOf(HasSubstr("2 of the plate's 10 markers"),
                                                 HasSubstr("front side (20, 21)"))));
}

TEST_F(PhotoChecks, NameAPhotographThatCannotBeRead) {
  photograph(batch::Side::Front, 0, 0.4);
  fs::remove(images_[0].file);
  const auto found = check();
  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().sentence(), HasSubstr("front0.png"));
}

}  // namespace
}  // namespace ostraka::checks
