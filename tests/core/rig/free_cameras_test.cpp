#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "calibration/free_cameras.h"
#include "images/image_header.h"
#include "rig/turntable.h"
#include "tests/core/files/temporary_folder.h"

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
    const auto size = *images::readImageSize(files[i]);
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
  const Result<calibration::BatchPoses> poses = calibration::poseFreeCameras(hand(), {}, quiet, {});
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
  for (const calibration::HeldOutDistance& d : poses->held_out)
    EXPECT_LT(std::abs(d.error()), 0.003);
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
  const Result<calibration::BatchPoses> poses = calibration::poseFreeCameras(batch, {}, quiet, {});
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

class Warned final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel level, const Message& text) override {
    if (level == NoteLevel::Warning) warnings.emplace_back(text.english());
  }
  std::vector<std::string> warnings;
};

// Ten photographs of one side.
batch::Batch tenByHand() {
  batch::Batch batch = hand();
  batch.shots.resize(10);
  return batch;
}

TEST(HandHeldPhotographs, OfAnotherSceneAreLeftOutWithOneWarning) {
  batch::Batch batch = tenByHand();
  batch::Batch apple;
  addSide(apple, batch::Side::Front, kApple / "photographs");
  for (int k = 0; k < 5; ++k) {
    batch.shots.push_back(apple.shots[static_cast<std::size_t>(k)]);
    batch.shots.back().camera = 10 + k;
  }
  Warned told;
  const Result<calibration::BatchPoses> poses = calibration::poseFreeCameras(batch, {}, told, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_EQ(poses->images.size(), 10U);
  ASSERT_EQ(told.warnings.size(), 1U);
  EXPECT_NE(told.warnings[0].find("and 2 more"), std::string::npos) << told.warnings[0];
}

// A photograph of the batch is replaced by what becomes of its picture.
class ChangedPhotographs : public testing::Test {
 protected:
  void change(std::size_t k, const std::function<cv::Mat(const cv::Mat&)>& how) {
    const cv::Mat changed = how(cv::imread(batch_.shots[k].file.string()));
    batch_.shots[k].file = folder_ / batch_.shots[k].file.filename();
    ASSERT_TRUE(cv::imwrite(batch_.shots[k].file.string(), changed));
  }

  batch::Batch batch_ = tenByHand();
  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(ChangedPhotographs, ThatWereZoomedGetTheirOwnFocalLength) {
  // The middle two thirds, as large as the others: two of ten, too few to tell a lens of their own.
  for (const std::size_t k : {2U, 7U})
    change(k, [](const cv::Mat& whole) {
      cv::Mat zoomed;
      cv::resize(
          whole(cv::Rect(whole.cols / 6, whole.rows / 6, 2 * whole.cols / 3, 2 * whole.rows / 3)),
          zoomed, whole.size(), 0, 0, cv::INTER_CUBIC);
      return zoomed;
    });
  Warned told;
  const Result<calibration::BatchPoses> poses = calibration::poseFreeCameras(batch_, {}, told, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  ASSERT_EQ(poses->images.size(), 10U);
  // The lens breathes by 2 %.
  for (std::size_t k = 0; k < 10; ++k)
    EXPECT_NEAR(poses->images[k].intrinsics.fx,
                poses->images[0].intrinsics.fx * (k == 2 || k == 7 ? 1.5 : 1),
                0.02 * poses->images[0].intrinsics.fx);
}

TEST_F(ChangedPhotographs, InWhichMostMarkersLieElsewhereAreLeftOutByName) {
  // Its quarters change places: no pose agrees with more than one of them.
  change(4, [](const cv::Mat& whole) {
    const int w = whole.cols / 2, h = whole.rows / 2;
    cv::Mat mixed(whole.size(), whole.type());
    for (const int x : {0, 1})
      for (const int y : {0, 1})
        whole(cv::Rect(x * w, y * h, w, h)).copyTo(mixed(cv::Rect((1 - x) * w, (1 - y) * h, w, h)));
    return mixed;
  });
  Warned told;
  const Result<calibration::BatchPoses> poses = calibration::poseFreeCameras(batch_, {}, told, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_EQ(poses->images.size(), 9U);
  ASSERT_EQ(told.warnings.size(), 1U);
  EXPECT_NE(told.warnings[0].find(batch_.shots[4].file.filename().string()), std::string::npos)
      << told.warnings[0];
}

TEST(HandHeldPhotographs, OfARealTelephoneOverABentSheetArePosedAll) {
  batch::Batch batch;
  batch.folder = kApple;
  batch.way = batch::Way::FreeCamera;
  batch.plate = batch::asSheet(*batch::readPlate(kApple / "markers.json"));
  addSide(batch, batch::Side::Front, kApple / "photographs");
  QuietProgress quiet;
  const Result<calibration::BatchPoses> poses = calibration::poseFreeCameras(batch, {}, quiet, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_EQ(poses->images.size(), 42U);
  for (std::size_t i = 0; i < poses->images.size(); ++i)
    std::printf("%s f %.1f c %.1f %.1f k1 %.3f k2 %.3f, %.2f px %d markers\n",
                poses->images[i].file.c_str(), poses->images[i].intrinsics.fx,
                poses->images[i].intrinsics.cx, poses->images[i].intrinsics.cy,
                poses->images[i].intrinsics.distortion[0],
                poses->images[i].intrinsics.distortion[1], poses->rms_per_image_px[i],
                poses->markers_per_image[i]);
  for (const calibration::HeldOutDistance& d : poses->held_out)
    std::printf("held out %d %d: %+.3f %%\n", d.first, d.second, 100 * d.error());
  std::printf("rms %.3f px\n", poses->reprojection_rms_px);
  EXPECT_LT(poses->reprojection_rms_px, 1.0);
}

}  // namespace
}  // namespace ostraka::rig
