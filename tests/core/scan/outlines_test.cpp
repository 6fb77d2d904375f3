#include "scan/outlines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "scan/split.h"
#include "simulated_rig.h"
#include "slabs.h"

namespace ostraka::scan {
namespace {

/// Photographs from all around at 45 degrees, and masks drawn of what stands on the plate.
struct AllAround {
  std::vector<rig::PosedImage> images;
  std::vector<cv::Mat1b> masks;

  explicit AllAround(const PointCloud& things) {
    for (int k = 0; k < 12; ++k) {
      rig::PosedImage image;
      image.intrinsics = {600, 400, 1000, 1000, 300, 200, {}};
      image.camera_from_plate = rig::lookingDown(M_PI / 4, 2 * M_PI * k / 12);
      cv::Mat1b mask(400, 600, uchar{0});
      for (const Eigen::Vector3f& p : things.points) {
        const Eigen::Vector2d at = image.project(p.cast<double>());
        cv::circle(mask, {cvRound(at.x()), cvRound(at.y())}, 1, 255, cv::FILLED);
      }
      images.push_back(image);
      masks.push_back(mask);
    }
  }
};

// What stereo finds of a box whose middle shows nothing to match.
PointCloud withoutItsMiddle(const PointCloud& whole) {
  PointCloud left;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (std::abs(whole.points[i].x()) > 3) {
      left.points.push_back(whole.points[i]);
      left.normals.push_back(whole.normals[i]);
    }
  return left;
}

TEST(Outlines, PartsOfOneOutlineAreOneThingAndNeighboursAreTwo) {
  const PointCloud left = test::box(-30, -20, 27, 40, 8), right = test::box(3, -20, 20, 40, 8);
  PointCloud one = test::box(-30, -20, 53, 40, 8), two = left;
  test::append(two, right);
  const std::vector<PointCloud> pieces{right, left};
  const AllAround of_one(one), of_two(two);
  EXPECT_EQ(thingsOf(pieces, of_one.images, of_one.masks), (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(thingsOf(pieces, of_two.images, of_two.masks), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(thingsOf(pieces, {}, {}), (std::vector<std::size_t>{0, 1}));
}

TEST(Outlines, AScanKeepsWhatStereoLeftWithoutAConnectionBelowItsOverhang) {
  // As of an apple: a cap that hovers, and a foot below it; between them nothing was found.
  PointCloud cap, whole = test::box(-20, -20, 40, 40, 40), foot;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const float z = whole.points[i].z();
    if (z > 10 && z < 20) continue;
    PointCloud& part = z >= 20 ? cap : foot;
    part.points.push_back(whole.points[i]);
    part.normals.push_back(whole.normals[i]);
  }
  PointCloud found = cap;
  test::append(found, foot);
  const AllAround around(whole);
  SplitOptions options;
  QuietProgress quiet;
  EXPECT_EQ(splitScans(found, batch::Side::Front, options, quiet)->scans.size(), 2u);
  options.images = around.images;
  options.masks = around.masks;
  const auto split = splitScans(found, batch::Side::Front, options, quiet);
  ASSERT_EQ(split->scans.size(), 1u);
  EXPECT_GT(split->scans[0].cloud.size(), cap.size());
  EXPECT_TRUE(split->warnings.empty());
}

TEST(Outlines, WhatIsCutInTheMiddleIsSaidToTouch) {
  const PointCloud whole = test::box(-30, -20, 60, 40, 8);
  const AllAround around(whole);
  SplitOptions options;
  options.images = around.images;
  options.masks = around.masks;
  QuietProgress quiet;
  const auto split = splitScans(withoutItsMiddle(whole), batch::Side::Front, options, quiet);
  ASSERT_TRUE(split.has_value());
  EXPECT_EQ(split->scans.size(), 2u);
  ASSERT_EQ(split->warnings.size(), 1u);
  EXPECT_EQ(split->warnings[0].english().find("Two sherds touch at x 4, y "), 0u)
      << split->warnings[0];
}

TEST(Outlines, ACrumbBesideASherdIsSaidAndOneUnderItIsNoise) {
  // A sherd of 8 mm that touches a large one shows within its outline in all photographs.
  PointCloud table = test::box(-30, -20, 60, 40, 30), beside = test::box(32, -4, 6, 6, 6);
  PointCloud masked = table;
  test::append(masked, test::box(28, -4, 10, 6, 6));
  PointCloud cap;
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table.points[i].z() > 20) {
      cap.points.push_back(table.points[i]);
      cap.normals.push_back(table.normals[i]);
    }
  const PointCloud under = test::box(-3, -3, 6, 6, 6);
  const AllAround around(masked);
  SplitOptions options;
  options.images = around.images;
  options.masks = around.masks;
  QuietProgress quiet;
  for (const bool crumb : {true, false}) {
    PointCloud found = cap;
    test::append(found, crumb ? beside : under);
    const auto split = splitScans(found, batch::Side::Front, options, quiet);
    ASSERT_EQ(split->scans.size(), 1u);
    EXPECT_EQ(split->scans[0].cloud.size(), cap.size());
    ASSERT_EQ(split->warnings.size(), crumb ? 1u : 0u);
    if (crumb) {
      EXPECT_EQ(split->warnings[0].english().find("A small object of 8 mm at x 35"), 0u)
          << split->warnings[0];
    }
  }
}

}  // namespace
}  // namespace ostraka::scan
