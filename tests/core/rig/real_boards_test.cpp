#include <gmock/gmock.h>

#include <algorithm>

#include "batch/photograph.h"
#include "calibration/intrinsics.h"
#include "rig/plate_markers.h"

namespace ostraka::rig {
namespace {

const std::filesystem::path kReal = OSTRAKA_SHARED_DIR "/real";

std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".jpg") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(RealArucoGrid, GivesTheFocalLengthAndNamesTheWorstPicture) {
  const calibration::MarkerGrid grid{"DICT_6X6_1000", 4, 5, 37.5, 5.0, 0};
  std::vector<calibration::TargetView> views;
  for (const auto& file : picturesIn(kReal / "aruco")) {
    views.push_back(*calibration::findGrid(*batch::readPhotograph(file), grid));
    views.back().file = file.filename();
  }
  const auto report = calibration::calibrateIntrinsics(views, 640, 480);
  ASSERT_TRUE(report.has_value()) << report.error().sentence();
  EXPECT_NEAR(report->intrinsics.fx, 811, 5);
  EXPECT_NEAR(report->intrinsics.cx, 318.8, 4);
  EXPECT_NEAR(report->intrinsics.cy, 241.1, 4);
  EXPECT_LE(report->rms_px, 0.45);
  EXPECT_EQ(report->files[report->worst_view], "32.jpg");
  EXPECT_THAT(report->advice, testing::Contains(testing::HasSubstr("scatter")));
}

TEST(RealCharuco, SaysThatTheFocalLengthIsNotDetermined) {
  const auto board = batch::readBoard(kReal / "charuco/board.json");
  ASSERT_TRUE(board.has_value()) << board.error().sentence();
  std::vector<calibration::TargetView> views;
  for (const auto& file : picturesIn(kReal / "charuco")) {
    views.push_back(*calibration::findBoard(*batch::readPhotograph(file), *board));
    views.back().file = file.filename();
  }
  const auto report = calibration::calibrateIntrinsics(views, 640, 480);
  ASSERT_TRUE(report.has_value()) << report.error().sentence();
  EXPECT_LE(report->rms_px, 0.2);
  EXPECT_FALSE(report->focal_determined);
  EXPECT_THAT(report->advice, testing::Contains(testing::HasSubstr("closer and with the board")));
  EXPECT_THAT(report->set_aside, testing::ElementsAre(testing::StartsWith("0.jpg")));
}

TEST(RealStatue, HasNoMarkerOfOurs) {
  const auto plate = batch::readPlate(OSTRAKA_SHARED_DIR "/batches/demo/plate.json");
  for (const auto& file : picturesIn(kReal / "statue"))
    EXPECT_TRUE(findPlateMarkers(*batch::readPhotograph(file), *plate)->empty()) << file;
}

}  // namespace
}  // namespace ostraka::rig
