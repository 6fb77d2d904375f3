#include "scan/boundary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "simulated_rig.h"
#include "slabs.h"

namespace ostraka::scan {
namespace {

// A box on the plate whose scan ends half a millimetre above it, with a hole in the middle of its
// top, and photographs from all around that show it without the hole.
class BoundaryOfABox : public testing::Test {
 protected:
  BoundaryOfABox() {
    const PointCloud whole = test::box(-20, -20, 40, 40, 8);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const Eigen::Vector3f& p = whole.points[i];
      if (p.z() > 7.9f && p.head<2>().cwiseAbs().maxCoeff() < 3) continue;
      box.points.push_back(p);
      box.normals.push_back(whole.normals[i]);
    }
    for (int k = 0; k < 12; ++k) {
      SilhouetteView& view = views.emplace_back();
      view.camera.intrinsics = {600, 400, 1000, 1000, 300, 200, {}};
      view.camera.camera_from_plate = rig::lookingDown(M_PI / 4, 2 * M_PI * k / 12);
      view.mask = cv::Mat1b(400, 600, uchar{0});
      for (const Eigen::Vector3f& p : whole.points) {
        const Eigen::Vector2d at = view.camera.project(p.cast<double>());
        cv::circle(view.mask, {cvRound(at.x()), cvRound(at.y())}, 1, 255, cv::FILLED);
      }
    }
  }
  static bool isLowest(const Eigen::Vector3f& p) { return p.z() < 0.6f; }
  static bool isAtTheHole(const Eigen::Vector3f& p) {
    return p.z() > 7.9f && p.head<2>().cwiseAbs().maxCoeff() < 3.1f;
  }

  PointCloud box;
  std::vector<SilhouetteView> views;
};

TEST_F(BoundaryOfABox, IsWhereNeighboursLeaveAGap) {
  const std::vector<std::uint8_t> boundary = findBoundary(box, {}, {});
  ASSERT_EQ(boundary.size(), box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Eigen::Vector3f& p = box.points[i];
    if (isAtTheHole(p) && std::abs(std::abs(p.x()) - std::abs(p.y())) < 0.1f) continue;  // corners
    EXPECT_EQ(boundary[i] != 0, isLowest(p) || isAtTheHole(p)) << p.transpose();
  }
}

// The top's edges and the hole are nowhere near the masks' border in all photographs.
TEST_F(BoundaryOfABox, WithMasksIsNoHoleOfTheScan) {
  const std::vector<std::uint8_t> boundary = findBoundary(box, views, {});
  for (std::size_t i = 0; i < box.size(); ++i)
    EXPECT_EQ(boundary[i] != 0, isLowest(box.points[i])) << box.points[i].transpose();
}

TEST_F(BoundaryOfABox, IsToldByTheGapsAloneWhereMasksLeaveNothing) {
  for (SilhouetteView& view : views) view.mask.setTo(255);
  EXPECT_EQ(findBoundary(box, views, {}), findBoundary(box, {}, {}));
}

// Fewer neighbours than asked for, and none at all.
TEST_F(BoundaryOfABox, OfAFewPointsIsNoError) {
  PointCloud few;
  EXPECT_TRUE(findBoundary(few, views, {}).empty());
  few.points.emplace_back(0, 0, 8);
  few.normals.emplace_back(0, 0, 1);
  EXPECT_EQ(findBoundary(few, views, {}), std::vector<std::uint8_t>{0});
}

}  // namespace
}  // namespace ostraka::scan
