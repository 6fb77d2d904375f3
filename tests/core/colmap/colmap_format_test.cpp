#include "colmap/colmap_format.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <random>

#include "tests/core/colmap/model_forms.h"
#include "tests/core/rig/simulated_rig.h"

namespace ostraka::colmap {
namespace {

ColmapModel sampleModel() {
  ColmapModel model;
  model.cameras.push_back(toColmap(rig::lens(2600), 3));
  ColmapImage image;
  image.id = 7;
  image.camera = 3;
  image.name = "front a.jpg";
  image.camera_from_world = rig::lookingDown(0.5, 0.3);
  image.observations = {{{1.5, 2.5}, 9}, {{3, 4}, -1}};
  model.images = {image, image};
  model.images[1].id = 8;
  model.images[1].observations.clear();
  model.points.push_back({9, {1, 2, 3}, {10, 20, 255}, 0.25, {{7, 0}}});
  return model;
}

class ColmapFiles : public testing::Test {
 protected:
  ColmapFiles() { std::filesystem::create_directories(folder_); }
  ~ColmapFiles() override { std::filesystem::remove_all(folder_); }

  static void expectSample(const ColmapModel& read) {
    const ColmapModel model = sampleModel();
    EXPECT_EQ(read.cameras[0].parameters, model.cameras[0].parameters);
    EXPECT_EQ(read.cameras[0].model, 4);
    ASSERT_EQ(read.images.size(), 2U);
    EXPECT_EQ(read.images[0].name, "front a.jpg");
    EXPECT_TRUE(
        read.images[0].camera_from_world.isApprox(model.images[0].camera_from_world, 1e-14));
    ASSERT_EQ(read.images[0].observations.size(), 2U);
    EXPECT_EQ(read.images[0].observations[1].point, -1);
    EXPECT_EQ(read.images[0].observations[0].pixel, Eigen::Vector2d(1.5, 2.5));
    EXPECT_EQ(read.images[1].id, 8U);
    EXPECT_EQ(read.points[0].position, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(read.points[0].colour[2], 255);
    EXPECT_EQ(read.points[0].track, model.points[0].track);
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "-colmap");
};

TEST_F(ColmapFiles, AreReadAsColmapWritesThem) {
  writeBinaryModel(folder_, sampleModel());
  const auto read = readColmapModel(folder_);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  expectSample(*read);
}

TEST_F(ColmapFiles, AreWrittenAsText) {
  ASSERT_TRUE(writeColmapModel(folder_, sampleModel()).has_value());
  expectSample(textModelIn(folder_));
}

TEST_F(ColmapFiles, SurviveChangedAndMissingBytes) {
  const std::string whole = BinaryForm(sampleModel().images).bytes;
  std::mt19937 random(11);
  for (int round = 0; round < 5000; ++round) {
    std::string damaged = whole.substr(0, random() % whole.size());
    for (int k = 0; k < 3 && !damaged.empty(); ++k)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto read = parseColmapImages(damaged, "images");
    if (!read) {
      EXPECT_EQ(read.error().where, "images");
      continue;
    }
    for (const ColmapImage& image : *read) {
      EXPECT_TRUE(image.camera_from_world.matrix().allFinite());
      EXPECT_TRUE(image.camera_from_world.linear().isUnitary(1e-9));
    }
  }
}

TEST_F(ColmapFiles, WithACountBeyondTheirSizeAreRefused) {
  std::string bytes = BinaryForm(sampleModel().points).bytes;
  bytes[6] = 1;  // 2^48 points
  const auto points = parseColmapPoints(bytes, "points3D.bin");
  ASSERT_FALSE(points.has_value());
  EXPECT_THAT(points.error().sentence(), testing::HasSubstr("points3D.bin"));
}

}  // namespace
}  // namespace ostraka::colmap
