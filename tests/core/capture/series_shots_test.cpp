#include "capture/series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/capture/photographed_side.h"
#include "turntables/hand_turntable.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;
using testing::FlatCamera;
using ::testing::HasSubstr;

class ShotsOfASeries : public PhotographedSide {};

TEST_F(ShotsOfASeries, BringsBackACameraThatWasGoneForAMoment) {
  rig_.cameras[0]->faults = {FlatCamera::Fault::Unplugged, FlatCamera::Fault::Silent};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.cameras[0]->reopened, 2);
  EXPECT_EQ(count(CaptureEventKind::Trouble), 2);
  expectWholeSide();
}

TEST_F(ShotsOfASeries, GoesOnAtTheShotWhereACameraWasPulledOut) {
  auto& faults = rig_.cameras[1]->faults;
  faults.assign(3, FlatCamera::Fault::None);
  faults.push_back(FlatCamera::Fault::Gone);
  const auto broken = shoot();
  ASSERT_FALSE(broken.has_value());
  EXPECT_EQ(broken.error().code, ErrorCode::Missing);
  const auto missing = missingShots(options_, 2);
  ASSERT_TRUE(missing.has_value());
  ASSERT_EQ(missing->size(), 1u);
  EXPECT_EQ(missing->front(), (ShotName{2, 1}));
  faults.clear();
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.truth->exposures, kProofs + 6 + 1) << "no finished shot is taken again";
  expectWholeSide();
}

TEST_F(ShotsOfASeries, DropsAPhotographThatComesTooLate) {
  rig_.cameras[1]->faults = {FlatCamera::Fault::None, FlatCamera::Fault::Late};
  ASSERT_TRUE(shoot().has_value());
  expectWholeSide();
}

TEST_F(ShotsOfASeries, RefusesAnEarlierPhotograph) {
  rig_.cameras[0]->faults = {FlatCamera::Fault::None, FlatCamera::Fault::None,
                             FlatCamera::Fault::Stale};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
  const auto refused = std::find_if(events_.begin(), events_.end(), [](const CaptureEvent& e) {
    return e.kind == CaptureEventKind::ShotRefused;
  });
  ASSERT_NE(refused, events_.end());
  EXPECT_TRUE(refused->check.has(ShotProblem::WrongStop));
  EXPECT_TRUE(refused->check.has(ShotProblem::Repeated));
  EXPECT_EQ(refused->stop, 1);
  EXPECT_EQ(refused->camera, 0);
}

// Late twice at the front's last shot: one photograph is kept, one comes when nobody waits for it.
TEST_F(ShotsOfASeries, RefusesWhatTheSideBeforeLeftBehind) {
  using Fault = FlatCamera::Fault;
  rig_.cameras[0]->faults = {Fault::None, Fault::None, Fault::None, Fault::Late, Fault::Late};
  ASSERT_TRUE(shoot().has_value());
  expectWholeSide();
  options_.side = batch::Side::Back;
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(ShotsOfASeries, RefusesTheLastPhotographOfTheBatchBefore) {
  using Fault = FlatCamera::Fault;
  ASSERT_TRUE(shoot().has_value());
  for (const std::deque<Fault>& faults :
       {std::deque{Fault::Stale}, std::deque{Fault::None, Fault::Stale},
        std::deque{Fault::Stale, Fault::Stale, Fault::None, Fault::Stale}}) {
    fs::remove_all(folder_);
    rig_.cameras[0]->faults = faults;
    const auto done = shoot();
    ASSERT_TRUE(done.has_value()) << done.error().what;
    expectWholeSide();
  }
}

// The manifest knows those of its own batch, even when another program took them.
TEST_F(ShotsOfASeries, RefusesAPhotographOfTheFrontAfterTheProgramWasStartedAgain) {
  ASSERT_TRUE(shoot().has_value());
  rig_.devices.delivered.clear();
  options_.side = batch::Side::Back;
  rig_.cameras[1]->faults = {FlatCamera::Fault::Stale};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(ShotsOfASeries, RefusesASeriesThatIsShiftedByOnePhotograph) {
  ASSERT_TRUE(shoot().has_value());
  options_.side = batch::Side::Back;
  rig_.cameras[1]->lags = true;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(note(0, 1), "no file");
}

TEST_F(ShotsOfASeries, TellsOldPhotographsByTheSherdsWhereAPersonTurnsTheTable) {
  int asked = 0;
  const auto person = [&](const Message& asked_for, std::stop_token) {
    const std::string& sentence = asked_for.english();
    ++asked;
    rig_.truth->degrees = std::atof(sentence.substr(sentence.find(" to ") + 4).c_str());
    return true;
  };
  rig_.devices.turntable = turntables::openHandTurntable(person);
  ASSERT_TRUE(shoot().has_value());
  EXPECT_EQ(asked, kStops) << "none for the throw-away exposure";
  expectWholeSide();
  // The back lies elsewhere; its first two files are of the front, at the very angle.
  using Fault = FlatCamera::Fault;
  fs::remove_all(folder_);
  rig_.cameras[0]->faults = {Fault::None, Fault::None, Fault::None, Fault::Late, Fault::Late};
  ASSERT_TRUE(shoot().has_value());
  rig_.devices.turntable = turntables::openHandTurntable(person);
  rig_.truth->scene.sherds = {{-50, 30, 14}, {26, 56, 18}, {40, -50, 12}};
  options_.side = batch::Side::Back;
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(ShotsOfASeries, KeepsTheSettingsOfEachShotAndFlagsOthers) {
  on_event_ = [this](const CaptureEvent& e) {
    if (e.kind == CaptureEventKind::Shooting && e.stop == 0)
      rig_.cameras[1]->exposure_time = "1/60";
  };
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(done->flagged, (std::vector<ShotName>{{1, 1}, {2, 1}}));
  EXPECT_FALSE(done->cut_off);
  const auto manifest = readManifest(folder_);
  ASSERT_TRUE(manifest.has_value());
  EXPECT_EQ(manifest->find(options_.side, 0, 1)->settings.at("exposure"), "1/8");
  EXPECT_EQ(manifest->find(options_.side, 1, 1)->settings.at("exposure"), "1/60");
  EXPECT_THAT(manifest->find(options_.side, 1, 1)->problems.at(0),
              HasSubstr("exposure is 1/60, but the first photograph used 1/8"));
}

TEST_F(ShotsOfASeries, SetsACameraAgainThatWasSwitchedOff) {
  rig_.devices.wanted_settings = {{{"exposure", "1/15"}}, {}};
  rig_.cameras[0]->faults = {FlatCamera::Fault::None, FlatCamera::Fault::Unplugged};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_TRUE(done->flagged.empty());
  EXPECT_EQ(rig_.cameras[0]->exposure_time, "1/15");
}

TEST_F(ShotsOfASeries, FailsInWordsWhenACameraStaysBad) {
  rig_.cameras[1]->faults.assign(4, FlatCamera::Fault::Truncated);
  rig_.cameras[1]->faults[0] = FlatCamera::Fault::None;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().what,
              HasSubstr("Camera B, position 1 failed 3 times: the file is truncated"));
}

}  // namespace
}  // namespace ostraka::capture
