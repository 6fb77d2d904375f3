// Whole calibrations of the demo's and of real photographs.
#include <gmock/gmock.h>

#include "calibration/calibration_report.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::rig {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

const fs::path kShared = OSTRAKA_SHARED_DIR;

calibration::CalibrationReport calibrated(const fs::path& folder,
                                          const calibration::CalibrationOptions& options = {}) {
  QuietProgress quiet;
  Result<calibration::CalibrationReport> report =
      calibration::calibrateFolder(folder, options, quiet, {});
  EXPECT_TRUE(report.has_value()) << report.error().sentence();
  return std::move(*report);
}

// A folder with links to a part of the demo.
class PartOfDemo {
 public:
  PartOfDemo() {
    fs::create_directories(folder_ / "front");
    const fs::path demo = kShared / "batches/demo";
    for (const auto& entry : fs::directory_iterator(demo / "front"))
      fs::create_symlink(entry.path(), folder_ / "front" / entry.path().filename());
    fs::create_directory_symlink(demo / "calib", folder_ / "calib");
    fs::create_symlink(demo / "plate.json", folder_ / "plate.json");
    fs::create_symlink(demo / "board.json", folder_ / "board.json");
  }
  const fs::path& folder() const { return folder_; }

 private:
  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST(CalibrateFolder, FindsTheDemosRigFromTheFrontAlone) {
  const PartOfDemo part;
  calibration::CalibrationOptions options;
  options.lengths = {{0, 12, 314.0}};  // 157 mm from the axis on both sides, as plate.json has it
  const calibration::CalibrationReport report = calibrated(part.folder(), options);
  ASSERT_TRUE(report.rig.has_value());
  ASSERT_EQ(report.cameras.size(), 3U);
  // Focal lengths of truth/cameras.json, to 0.1 %.
  const std::vector<PosedImage> truth = *readCameras(kShared / "batches/demo/truth/cameras.json");
  for (const PosedImage& image : truth) {
    const RigCamera* camera = report.rig->find(image.camera);
    ASSERT_NE(camera, nullptr);
    EXPECT_NEAR(camera->intrinsics.fx / image.intrinsics.fx, 1, 0.001);
    ASSERT_EQ(camera->covariance.size(), 225U);
    EXPECT_NEAR(std::sqrt(camera->covariance[0]), camera->focal_sd_px, 1e-12);
  }
  ASSERT_EQ(report.held_out.size(), 2U);
  for (const calibration::HeldOutDistance& d : report.held_out)
    EXPECT_LT(std::abs(d.error()), 0.001);
  EXPECT_NEAR(report.lengths[0].found_mm, 314, 0.1);
  EXPECT_NE(report.verdict, calibration::Verdict::NotUsable);
}

TEST(CalibrateFolder, NamesTheWorstPictureOfARealBoard) {
  const calibration::CalibrationReport report = calibrated(kShared / "real/aruco");
  ASSERT_EQ(report.cameras.size(), 1U);
  EXPECT_NEAR(report.cameras[0].focal_px, 811, 5);
  EXPECT_EQ(report.cameras[0].worst_picture, "32.jpg");
  EXPECT_FALSE(report.rig.has_value());
  EXPECT_THAT(report.verdict_in_words, HasSubstr("the camera poses are not"));
  EXPECT_THAT(report.missing, Contains(HasSubstr("Photograph the plate")));
  EXPECT_THAT(calibration::inWords(report), Contains(HasSubstr("worst 32.jpg with 0.69")));
}

TEST(CalibrateFolder, SaysThatPicturesOfOneDistanceDoNotDetermineALens) {
  const calibration::CalibrationReport report = calibrated(kShared / "real/charuco");
  EXPECT_EQ(report.verdict, calibration::Verdict::NotUsable);
  EXPECT_THAT(report.verdict_in_words, HasSubstr("the focal length is not determined"));
  EXPECT_THAT(report.missing, Contains(HasSubstr("closer and with the board tilted")));
  EXPECT_THAT(report.set_aside, testing::ElementsAre(testing::StartsWith("0.jpg")));
  EXPECT_FALSE(report.rig.has_value());
}

}  // namespace
}  // namespace ostraka::rig
