#include "capture/series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/capture/photographed_side.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;
using testing::FlatCamera;
using testing::FlatTurntable;
using ::testing::HasSubstr;

class SeriesOfASide : public PhotographedSide {};

TEST_F(SeriesOfASide, SetsTheRigsSettingsBeforeASideAndComparesEachShotWithThem) {
  rig_.devices.wanted_settings = {{}, {{"exposure", "1/15"}}};
  on_event_ = [this](const CaptureEvent& e) {
    if (e.kind == CaptureEventKind::Shooting && e.stop == 0)
      rig_.cameras[1]->exposure_time = "1/60";
  };
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(done->flagged, (std::vector<ShotName>{{1, 1}, {2, 1}}));
  const auto manifest = readManifest(folder_);
  ASSERT_TRUE(manifest.has_value());
  EXPECT_EQ(manifest->find(options_.side, 0, 0)->settings.at("exposure"), "1/8");
  EXPECT_EQ(manifest->find(options_.side, 0, 1)->settings.at("exposure"), "1/15");
  for (const int stop : {1, 2})
    EXPECT_THAT(manifest->find(options_.side, stop, 1)->problems.at(0),
                HasSubstr("exposure is 1/60, but the rig specifies 1/15"));
}

TEST_F(SeriesOfASide, DoesNotBeginWithACameraThatKeepsAnotherSettingThanTheRigs) {
  rig_.devices.wanted_settings = {{{"exposure", "1/15"}}, {}};
  rig_.cameras[0]->has_dial = true;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(rig_.truth->exposures, 0);
}

TEST_F(SeriesOfASide, AsksForACutOffOrBlurredPhotographAgainAtOnce) {
  rig_.cameras[0]->faults = {FlatCamera::Fault::None, FlatCamera::Fault::Truncated,
                             FlatCamera::Fault::None, FlatCamera::Fault::Blurred};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(count(CaptureEventKind::ShotRefused), 2);
  EXPECT_TRUE(done->flagged.empty());
  EXPECT_TRUE(fs::exists(folder_ / "set_aside" / "front_cam0_pos00_take1.jpg"));
  expectWholeSide();
}

// What shows no markers might be of any stop, however often it comes.
TEST_F(SeriesOfASide, KeepsNoPhotographThatDoesNotShowItsStop) {
  rig_.cameras[1]->faults.assign(5, FlatCamera::Fault::Blurred);
  rig_.cameras[1]->faults[0] = FlatCamera::Fault::None;
  rig_.cameras[1]->faults[1] = FlatCamera::Fault::None;
  rig_.truth->scene.width = 480;  // edges of 5 pixels hide the markers' bits
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().what, HasSubstr("Camera B, position 2 failed 3 times"));
  EXPECT_EQ(note(1, 1), "no file");
}

TEST_F(SeriesOfASide, ComesThroughAnUnpluggedTable) {
  rig_.table->faults =
      afterStop(1, {FlatTurntable::Fault::UnpluggedBefore, FlatTurntable::Fault::UnpluggedMidway});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.truth->exposures, kProofs + 6);
  EXPECT_DOUBLE_EQ(rig_.truth->degrees, 240);
  expectWholeSide();
}

TEST_F(SeriesOfASide, HomesATableThatRestarted) {
  rig_.table->faults = afterStop(1, {FlatTurntable::Fault::Restarted});
  ASSERT_TRUE(shoot().has_value());
  expectWholeSide();
}

TEST_F(SeriesOfASide, FindsThePositionByTheMarkersWhenTheTableHasNoSwitch) {
  rig_.table->has_switch = false;
  rig_.table->faults = afterStop(2, {FlatTurntable::Fault::Restarted});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(SeriesOfASide, CorrectsATableThatSlipped) {
  rig_.table->faults = afterStop(1, {FlatTurntable::Fault::Slipped});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(SeriesOfASide, WantsAKnownPositionAtTheStart) {
  rig_.table->has_switch = false;
  rig_.table->faults = {FlatTurntable::Fault::Restarted};
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::NotEnough);
  EXPECT_EQ(rig_.truth->exposures, 0);
}

TEST_F(SeriesOfASide, FlagsWhatAnotherPhotographWouldNotMend) {
  rig_.truth->scene.shift_mm = 155;
  rig_.truth->scene.sherds.push_back({95, 0, 14});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.truth->exposures, kProofs + 6);
  EXPECT_FALSE(done->flagged.empty());
  EXPECT_TRUE(done->cut_off);
  const auto again = shoot();
  ASSERT_TRUE(again.has_value()) << again.error().what;
  EXPECT_TRUE(again->cut_off) << "the manifest knows it as well";
}

TEST_F(SeriesOfASide, RefusesTheBackOfABatchThatOtherCamerasBegan) {
  ASSERT_TRUE(shoot().has_value());
  options_.side = batch::Side::Back;
  std::swap(rig_.devices.cameras[0], rig_.devices.cameras[1]);
  const int exposures = rig_.truth->exposures;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(done.error().what, HasSubstr("Camera A of this batch was"));
  EXPECT_EQ(rig_.truth->exposures, exposures);
}

TEST_F(SeriesOfASide, RefusesABatchWhosePhotographWasChanged) {
  ASSERT_TRUE(shoot().has_value());
  std::ofstream(folder_ / "front" / "cam1_pos02.jpg", std::ios::app) << "x";
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().where, HasSubstr("cam1_pos02.jpg"));
}

}  // namespace
}  // namespace ostraka::capture
