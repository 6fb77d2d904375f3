#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "base/median.h"
#include "batch/image_header.h"
#include "rig/free_cameras.h"
#include "rig/turntable.h"

// Photographs by hand over a printed sheet, against the truth; only tests read truth/.
namespace ostraka::rig {
namespace {

namespace fs = std::filesystem;
const fs::path kHand = OSTRAKA_SHARED_DIR "/batches/hand";
const fs::path kApple = OSTRAKA_SHARED_DIR "/real/apple";

void addSide(batch::Batch& batch, batch::Side side, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto size = *batch::readImageSize(files[i]);
    batch.shots.push_back({side, static_cast<int>(i), 0, files[i], {}, size.width, size.height});
  }
}

batch::Batch hand() {
  batch::Batch batch;
  batch.folder = kHand;
  batch.way = batch::Way::FreeCamera;
  batch.plate = *batch::readPlate(kHand / "plate.json");
  addSide(batch, batch::Side::Front, kHand / "front");
  addSide(batch, batch::Side::Back, kHand / "back");
  return batch;
}

TEST(HandHeldPhotographs, ArePosedToAThirdOfAPixelWhereTheSherdsLie) {
  std::map<std::string, PosedImage> truth;
  const std::vector<PosedImage> cameras = *readCameras(kHand / "truth/cameras.json");
  for (const PosedImage& image : cameras)
    truth.emplace(fs::path(image.file).filename().string(), image);
  QuietProgress quiet;
  const Result<BatchPoses> poses = poseFreeCameras(hand(), {}, quiet, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_EQ(poses->images.size(), 40U);
  std::vector<double> errors_px, focal;
  for (const PosedImage& image : poses->images) {
    const PosedImage& t = truth.at(fs::path(image.file).filename().string());
    double sum = 0, count = 0;
    for (double x = -80; x <= 80; x += 20)
      for (double y = -50; y <= 50; y += 10)
        for (double z = 0; z <= 20; z += 10, ++count)
          sum += (image.project({x, y, z}) - t.project({x, y, z})).squaredNorm();
    errors_px.push_back(std::sqrt(sum / count));
    focal.push_back(std::abs(image.intrinsics.fx / t.intrinsics.fx - 1));
    std::printf("%s %.3f px, focal %+.3f %%, markers %.2f px\n", image.file.c_str(),
                errors_px.back(), 100 * (image.intrinsics.fx / t.intrinsics.fx - 1),
                poses->rms_per_image_px[errors_px.size() - 1]);
  }
  for (const HeldOutDistance& d : poses->held_out) EXPECT_LT(std::abs(d.error()), 0.003);
  std::printf("median %.3f px, worst %.3f px, markers %.3f px\n", medianOf(errors_px),
              *std::max_element(errors_px.begin(), errors_px.end()), poses->reprojection_rms_px);
  EXPECT_LT(medianOf(errors_px), 0.33);
}

// The photographs of one of the demo's cameras, as if each had been taken from anywhere.
TEST(TurningPlate, IsToldByThePosesOfOneCamerasPhotographs) {
  batch::Batch batch;
  batch.folder = OSTRAKA_SHARED_DIR "/batches/demo";
  batch.way = batch::Way::FreeCamera;
  batch.plate = batch::asSheet(*batch::readPlate(batch.folder / "plate.json"));
  ASSERT_TRUE(batch.plate->round);
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    addSide(batch, side, batch.folder / batch::name(side));
  std::erase_if(batch.shots, [](const batch::Shot& shot) {
    return !shot.file.filename().string().starts_with("cam1");
  });
  QuietProgress quiet;
  const Result<BatchPoses> poses = poseFreeCameras(batch, {}, quiet, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  ASSERT_EQ(poses->images.size(), 16U);
  // From one height the focal length is not determined well, but the lens is one that there is.
  for (const PosedImage& image : poses->images) {
    EXPECT_NEAR(image.intrinsics.fx, 2752, 0.04 * 2752);
    EXPECT_LT(std::abs(image.intrinsics.distortion[1]), 1);
    EXPECT_LT(std::abs(image.intrinsics.distortion[4]), 1);
  }
  const auto places = turntablePlaces(std::span(poses->images).first(8));
  ASSERT_TRUE(places);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ((*places)[i].ring, 0);
    EXPECT_EQ((*places)[i].stop, static_cast<int>(i));
  }
  const std::vector<PosedImage> walked = *readCameras(kHand / "truth/cameras.json");
  EXPECT_FALSE(turntablePlaces(std::span(walked).first(20)));
}

TEST(HandHeldPhotographs, OfARealTelephoneOverABentSheetArePosedAll) {
  batch::Batch batch;
  batch.folder = kApple;
  batch.way = batch::Way::FreeCamera;
  batch.plate = batch::asSheet(*batch::readPlate(kApple / "markers.json"));
  addSide(batch, batch::Side::Front, kApple / "photographs");
  QuietProgress quiet;
  const Result<BatchPoses> poses = poseFreeCameras(batch, {}, quiet, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_EQ(poses->images.size(), 42U);
  for (std::size_t i = 0; i < poses->images.size(); ++i)
    std::printf("%s f %.1f c %.1f %.1f k1 %.3f k2 %.3f, %.2f px %d markers\n",
                poses->images[i].file.c_str(), poses->images[i].intrinsics.fx,
                poses->images[i].intrinsics.cx, poses->images[i].intrinsics.cy,
                poses->images[i].intrinsics.distortion[0],
                poses->images[i].intrinsics.distortion[1], poses->rms_per_image_px[i],
                poses->markers_per_image[i]);
  for (const HeldOutDistance& d : poses->held_out)
    std::printf("held out %d %d: %+.3f %%\n", d.first, d.second, 100 * d.error());
  std::printf("rms %.3f px\n", poses->reprojection_rms_px);
  EXPECT_LT(poses->reprojection_rms_px, 1.0);
}

}  // namespace
}  // namespace ostraka::rig
