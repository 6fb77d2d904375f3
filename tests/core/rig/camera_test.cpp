#include "rig/camera.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "files/json.h"
#include "simulated_rig.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::rig {
namespace {

TEST(Intrinsics, ProjectsByHandComputedNumbers) {
  Intrinsics i;
  i.fx = 1000;
  i.fy = 900;
  i.cx = 320;
  i.cy = 240;
  i.distortion = {{0.1, 0, 0.01, 0.02, 0}};
  // x = 0.2, y = 0.1, r2 = 0.05, radial 1.005; tangential x: 2*.01*.02 + .02*(.05+.08) = 0.003,
  // y: .01*(.05+.02) + 2*.02*.02 = 0.0015.
  const Eigen::Vector2d p = i.project({2, 1, 10});
  EXPECT_NEAR(p.x(), 1000 * (0.2 * 1.005 + 0.003) + 320, 1e-9);
  EXPECT_NEAR(p.y(), 900 * (0.1 * 1.005 + 0.0015) + 240, 1e-9);
}

TEST(Intrinsics, UnprojectUndoesProject) {
  const Intrinsics i = lens(2600);
  for (double x = -0.3; x <= 0.3; x += 0.1)
    for (double y = -0.2; y <= 0.2; y += 0.1)
      EXPECT_LT((i.unproject(i.project({x, y, 1})) - Eigen::Vector2d(x, y)).norm(), 1e-9);
}

// A pixel of 1000 x 800 covers 2 x 4 pixels of 500 x 200: what was at the middle of the first two
// columns, x = 0.5, is at the middle of the first, x = 0.
TEST(Intrinsics, ReducedPicturesShowAPointWhereItsAreaWent) {
  Intrinsics i;
  i.width = 1000;
  i.height = 800;
  i.fx = i.fy = 2000;
  i.cx = 499.5;
  i.cy = 399.5;
  i.distortion = {{0.1, 0, 0.01, 0.02, 0}};
  const Intrinsics small = reduced(i, 500, 200);
  EXPECT_EQ(small.width, 500);
  EXPECT_EQ(small.height, 200);
  EXPECT_DOUBLE_EQ(small.cx, 249.5);
  EXPECT_DOUBLE_EQ(small.cy, 99.5);
  EXPECT_EQ(reducedTo(i, 0.8).width, 1000);
  EXPECT_EQ(reducedTo(i, 0.2).width, 500);
  EXPECT_EQ(reducedTo(i, 0.2).height, 400);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 10), Eigen::Vector3d(2, -1, 11)}) {
    const Eigen::Vector2d at = i.project(p);
    EXPECT_NEAR(small.project(p).x(), (at.x() + 0.5) / 2 - 0.5, 1e-9);
    EXPECT_NEAR(small.project(p).y(), (at.y() + 0.5) / 4 - 0.5, 1e-9);
  }
}

TEST(Cameras, ComeBackFromTheirFileWithTheirLenses) {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "cameras.json";
  std::vector<PosedImage> images(3);
  for (PosedImage& image : images) image.intrinsics = lens(2600);
  images[1].intrinsics.distortion = {{0.9, 0.1, 0, 0, 0, 1, 0.2}, Lens::Full};
  images[2].intrinsics.distortion = {{0.03, -0.01, 0.004, -0.001}, Lens::Fisheye};
  ASSERT_TRUE(writeCameras(file, images));
  const auto read = readCameras(file);
  ASSERT_TRUE(read) << read.error().sentence();
  for (std::size_t k = 0; k < images.size(); ++k)
    EXPECT_EQ((*read)[k].intrinsics.distortion, images[k].intrinsics.distortion) << k;
  nlohmann::json json = *readJson(file);
  json["images"][0]["dist"] = std::vector<double>(14, 0.0);
  std::ofstream(file) << json;
  const auto refused = readCameras(file);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().what, testing::HasSubstr("'dist': 14;"));
}

TEST(PoseFrom, UndoesTheRotationVector) {
  const PoseBlock block{0.3, -0.4, 1.2, 10, 20, 30};
  const Eigen::Isometry3d pose = poseFrom(block);
  EXPECT_LT((pose * Eigen::Vector3d::Zero() - Eigen::Vector3d(10, 20, 30)).norm(), 1e-12);
  EXPECT_NEAR(pose.linear().determinant(), 1, 1e-12);
  const PoseBlock back = toBlock(pose);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(back[k], block[k], 1e-12);
}

TEST(PoseFrom, ARotationVectorOfZeroTurnsNothing) {
  EXPECT_TRUE(poseFrom({0, 0, 0, 1, 2, 3}).linear().isIdentity(0));
}

}  // namespace
}  // namespace ostraka::rig
