#include "texture/view.h"

#include <gtest/gtest.h>

#include "block.h"

namespace ostraka::texture {
namespace {

TEST(View, IsThePartAroundTheSherdAtFullResolution) {
  // The pose is of a picture of half the size.
  const rig::PosedImage image = lookingAt({0, 0, 200}, {0, 0, 0});
  cv::Mat3b photograph(1200, 1600, cv::Vec3b(1, 2, 3));
  const cv::Mat1b mask(600, 800, uchar{255});
  const std::vector<Eigen::Vector3f> points = {{-10, -5, 0}, {10, 5, 0}};
  const auto view = cutOut(photograph, mask, image, Eigen::Isometry3d::Identity(), points);
  ASSERT_TRUE(view);
  // 20 mm and 10 mm at 200 mm and a focal length of 2000, 12 pixels and 2.5 mm around.
  EXPECT_NEAR(view->picture.cols, 200 + 2 * 37, 3);
  EXPECT_NEAR(view->picture.rows, 100 + 2 * 37, 3);
  EXPECT_EQ(view->mask_step, 2);
  EXPECT_EQ(view->mask.size(), view->picture.size());
  const Eigen::Vector2d middle = view->project({0, 0, 0});
  EXPECT_NEAR(middle.x() + view->corner.x(), 799.5, 1e-9);
  EXPECT_NEAR(middle.y() + view->corner.y(), 599.5, 1e-9);
  EXPECT_NEAR(finestPixel_mm(block({2, 2, 0.01f}, 1), {*view}), 0.1, 1e-3);
  const auto nothing = [&](const cv::Mat1b& masked, const Eigen::Vector3f& point) {
    return !cutOut(photograph, masked, image, Eigen::Isometry3d::Identity(), {point});
  };
  EXPECT_TRUE(nothing(mask, {500, 0, 0})) << "beyond the picture";
  EXPECT_TRUE(nothing(mask, {0, 0, 300})) << "behind the camera";
  EXPECT_TRUE(nothing(cv::Mat1b(600, 800, uchar{100}), {0, 0, 0})) << "no sherd there";
  EXPECT_TRUE(nothing(cv::Mat1b(), {0, 0, 0}));
}

TEST(View, IsNotFoldedBackByTheLens) {
  rig::PosedImage image = lookingAt({0, 0, 200}, {0, 0, 0});
  image.intrinsics.distortion[0] = -0.3;
  // 1.5 off the axis the model comes back to 0.49, which is in the picture.
  EXPECT_FALSE(cutOut(cv::Mat3b(600, 800), cv::Mat1b(600, 800, uchar{255}), image,
                      Eigen::Isometry3d::Identity(), {{0, 300, 0}}));
}

std::vector<Eigen::Vector3d> squareAt(double x_mm, double depth_mm) {
  std::vector<Eigen::Vector3d> points;
  for (double x = -10; x <= 10; ++x)
    for (double y = -10; y <= 10; ++y) points.emplace_back(x_mm + x, y, depth_mm);
  return points;
}

TEST(View, LeavesOutWhatOtherSherdsHide) {
  View view;
  view.picture = cv::Mat3b(400, 400);
  view.mask = cv::Mat1b(400, 400, uchar{255});
  view.intrinsics = {400, 400, 1000, 1000, 199.5, 199.5, {}};
  view.reach = 1;
  // 20 mm wide, 5 pixels a mm; the other reaches over the right half, and is nearer.
  hideOthers(view, squareAt(0, 200), squareAt(10, 180));
  EXPECT_EQ(view.mask(200, 130), 255);
  EXPECT_EQ(view.mask(200, 260), 0);
  EXPECT_EQ(view.mask(200, 300), 0) << "the other alone";
  view.mask = 255;
  hideOthers(view, squareAt(0, 200), squareAt(10, 220));
  EXPECT_EQ(view.mask(200, 230), 255) << "what is behind hides nothing";
}

TEST(View, OfTheBackIsBroughtToTheMesh) {
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  front_from_back.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  front_from_back.translation() = Eigen::Vector3d(30, 0, 6);
  const rig::PosedImage image = lookingAt({0, 0, 200}, {0, 0, 0});
  const auto view = cutOut(cv::Mat3b(600, 800), cv::Mat1b(600, 800, uchar{255}), image,
                           front_from_back, {{30, 0, 6}});
  ASSERT_TRUE(view);
  EXPECT_LT((view->centre() - Eigen::Vector3d(30, 0, -194)).norm(), 1e-9);
}

TEST(DepthMap, SeesTheSurfaceAndNothingBehindIt) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const rig::PosedImage image = lookingAt({0, -120, 160}, {0, 0, 0});
  const auto view = cutOut(cv::Mat3b(600, 800), cv::Mat1b(600, 800, uchar{255}), image,
                           Eigen::Isometry3d::Identity(), tile.vertices);
  ASSERT_TRUE(view);
  const DepthMap depth(tile, *view);
  const auto sees = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    const double z = (view->camera_from_mesh * point).z();
    return depth.sees(view->project(point), z, normal.dot((view->centre() - point).normalized()));
  };
  EXPECT_TRUE(sees({0, 0, 6}, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(sees({-15, 10, 6}, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(sees({0, -15, 3}, -Eigen::Vector3d::UnitY())) << "the fracture that faces it";
  EXPECT_FALSE(sees({0, 0, 0}, Eigen::Vector3d::UnitZ())) << "the underside";
  EXPECT_FALSE(sees({5, 5, 3}, Eigen::Vector3d::UnitZ())) << "what is inside";
}

}  // namespace
}  // namespace ostraka::texture
