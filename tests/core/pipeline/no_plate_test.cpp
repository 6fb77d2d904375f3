#include "pipeline/no_plate.h"

#include <gmock/gmock.h>

namespace ostraka::pipeline {
namespace {

batch::Batch withMasks(int count) {
  batch::Batch batch;
  batch.folder = "/somewhere/batch";
  for (int k = 0; k < 3; ++k)
    batch.shots.push_back({batch::Side::Front, 0, k, "a.jpg", k < count ? "a.png" : "", 10, 10});
  return batch;
}

TEST(NoPlate, TakesTheMasksThatCameAlongOnlyWithoutAPlate) {
  batch::Batch batch = withMasks(3);
  EXPECT_EQ(*maskSource("auto", batch), MaskSource::Given);
  batch.plate.emplace();
  EXPECT_EQ(*maskSource("auto", batch), MaskSource::Plate);
  EXPECT_EQ(*maskSource("given", batch), MaskSource::Given);
  EXPECT_EQ(*maskSource("unet.onnx", batch), MaskSource::Network);
}

TEST(NoPlate, AsksForMasksWhereThereIsNeitherPlateNorMask) {
  const auto source = maskSource("auto", withMasks(0));
  ASSERT_FALSE(source.has_value());
  EXPECT_EQ(source.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(source.error().sentence(), testing::HasSubstr("/somewhere/batch"));
  EXPECT_EQ(*maskSource("unet.onnx", withMasks(0)), MaskSource::Network);
}

TEST(NoPlate, FindsMasksFromThePhotographsByHandThemselves) {
  batch::Batch by_hand = withMasks(0);
  by_hand.way = batch::Way::FreeCamera;
  EXPECT_EQ(*maskSource("auto", by_hand), MaskSource::Views);
  by_hand.shots[0].mask_file = "a.png";
  EXPECT_EQ(*maskSource("auto", by_hand), MaskSource::Given);
}

TEST(NoPlate, MakesAPixelAFifthOfAMillimetreWhateverColmapsUnit) {
  colmap::ColmapPoses poses;
  poses.images.resize(1);
  poses.images[0].intrinsics = {1600, 1200, 2000, 2000, 800, 600, {}};
  // Depths 3, 4, 5 and one point behind the camera: the median pixel is 4 / 2000 units.
  poses.points = {{0, 0, 3}, {1, 0, 4}, {0, 1, 5}, {0, 0, -7}};
  EXPECT_DOUBLE_EQ(nominalScale(poses), 0.2 / (4.0 / 2000));
  const colmap::ColmapPoses sized = colmap::scaledTo(poses, nominalScale(poses));
  EXPECT_NEAR(nominalScale(sized), 1, 1e-12);
  poses.points.clear();
  EXPECT_EQ(nominalScale(poses), 1);
}

TEST(NoPlate, ResizesOneSideAndKeepsWhatItsCamerasShow) {
  std::vector<rig::PosedImage> images(2);
  images[1].side = batch::Side::Back;
  for (rig::PosedImage& image : images) {
    image.intrinsics = {1600, 1200, 2000, 2000, 800, 600, {}};
    image.camera_from_plate.translation() = Eigen::Vector3d(1, 2, 50);
  }
  const Eigen::Vector3d point(3, -1, 4);
  const Eigen::Vector2d before = images[1].project(point);
  resizeSide(images, batch::Side::Back, 1.5);
  EXPECT_EQ(images[0].camera_from_plate.translation(), Eigen::Vector3d(1, 2, 50));
  EXPECT_LT((images[1].project(1.5 * point) - before).norm(), 1e-9);
}

}  // namespace
}  // namespace ostraka::pipeline
