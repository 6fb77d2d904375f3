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
  // 20 mm and 10 mm at 200 mm and a focal length of 2000, 12 pixels around.
  EXPECT_NEAR(view->picture.cols, 200 + 24, 3);
  EXPECT_NEAR(view->picture.rows, 100 + 24, 3);
  EXPECT_EQ(view->mask.size(), view->picture.size());
  const Eigen::Vector2d middle = view->project({0, 0, 0});
  EXPECT_NEAR(middle.x() + view->corner.x(), 799.5, 1e-9);
  EXPECT_NEAR(middle.y() + view->corner.y(), 599.5, 1e-9);
  EXPECT_NEAR(finestPixel_mm(block({2, 2, 0.01f}, 1), {*view}), 0.1, 1e-3);
  EXPECT_FALSE(cutOut(photograph, mask, image, Eigen::Isometry3d::Identity(), {{500, 0, 0}}));
}

TEST(View, OfTheBackIsBroughtToTheMesh) {
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  front_from_back.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  front_from_back.translation() = Eigen::Vector3d(30, 0, 6);
  const rig::PosedImage image = lookingAt({0, 0, 200}, {0, 0, 0});
  const auto view =
      cutOut(cv::Mat3b(600, 800), cv::Mat1b(600, 800), image, front_from_back, {{30, 0, 6}});
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
