#include "capture/sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "capture/manifest.h"
#include "files/files.h"
#include "flat_rig.h"
#include "tests/core/files/temporary_folder.h"
#include "turntables/hand_turntable.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;
using testing::exposureNote;
using testing::FlatCamera;
using testing::FlatRig;
using testing::FlatTurntable;
using ::testing::HasSubstr;
using testing::makeFlatRig;
using testing::noteOf;

constexpr int kStops = 3;
constexpr int kProofs = 2;  // a throw-away exposure of each camera before a side

class Sequence : public ::testing::Test {
 protected:
  Sequence() {
    options_.batch = folder_;
    options_.stops = kStops;
  }

  Result<SideSummary> shoot() {
    return shootSide(
        rig_.devices, options_,
        [this](const CaptureEvent& event) {
          events_.push_back(event);
          if (on_event_) on_event_(event);
        },
        progress_, stop_.get_token());
  }
  std::string note(int stop, int camera) const {
    const auto bytes =
        readFile(folder_ / batch::name(options_.side) /
                 ("cam" + std::to_string(camera) + "_pos0" + std::to_string(stop) + ".jpg"));
    return bytes ? noteOf(*bytes) : "no file";
  }
  // Every file is of its own camera and stop, and the manifest knows its bytes.
  void expectWholeSide() const {
    const auto manifest = readManifest(folder_);
    ASSERT_TRUE(manifest.has_value());
    for (int s = 0; s < kStops; ++s)
      for (int c = 0; c < static_cast<int>(rig_.cameras.size()); ++c) {
        EXPECT_THAT(note(s, c),
                    HasSubstr(exposureNote(batch::name(options_.side), c, s * 360.0 / kStops)));
        const ManifestEntry* entry = manifest->find(options_.side, s, c);
        ASSERT_NE(entry, nullptr);
        const auto bytes = readFile(folder_ / entry->file);
        ASSERT_TRUE(bytes.has_value());
        EXPECT_EQ(entry->sha256, sha256(*bytes));
        EXPECT_TRUE(entry->checked);
      }
  }
  // The moves of the table: twice for the throw-away exposure, then one for each stop.
  static std::deque<FlatTurntable::Fault> afterStop(int stop,
                                                    std::vector<FlatTurntable::Fault> faults) {
    std::deque<FlatTurntable::Fault> all(static_cast<std::size_t>(2 + stop),
                                         FlatTurntable::Fault::None);
    all.insert(all.end(), faults.begin(), faults.end());
    return all;
  }
  int count(CaptureEventKind kind) const {
    return static_cast<int>(std::count_if(events_.begin(), events_.end(),
                                          [&](const auto& e) { return e.kind == kind; }));
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "batch";
  SideOptions options_;
  FlatRig rig_ = makeFlatRig(2);
  std::vector<CaptureEvent> events_;
  std::function<void(const CaptureEvent&)> on_event_;
  QuietProgress progress_;
  std::stop_source stop_;
};

TEST_F(Sequence, TakesEveryShotOnceAndUnderItsOwnName) {
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(done->kept, 6);
  EXPECT_TRUE(done->flagged.empty());
  EXPECT_EQ(done->check.sherds, 3);
  EXPECT_TRUE(done->check.sentences.empty());
  EXPECT_EQ(rig_.truth->exposures, kProofs + 6);
  EXPECT_EQ(count(CaptureEventKind::ShotKept), 6);
  EXPECT_EQ(count(CaptureEventKind::StopDone), kStops);
  expectWholeSide();
  EXPECT_TRUE(fs::exists(folder_ / "plate.json"));
}

TEST_F(Sequence, ShootsTheBackAfterTheFrontWithoutWindingBack) {
  ASSERT_TRUE(shoot().has_value());
  options_.side = batch::Side::Back;
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
  EXPECT_DOUBLE_EQ(rig_.truth->degrees, 360 + 240);
}

TEST_F(Sequence, DoesNotTakeAFinishedSideAgain) {
  ASSERT_TRUE(shoot().has_value());
  const auto again = shoot();
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->kept, 6);
  EXPECT_EQ(rig_.truth->exposures, kProofs + 6);
}

TEST_F(Sequence, GoesOnAtTheShotWhereACameraWasPulledOut) {
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

TEST_F(Sequence, BringsBackACameraThatWasGoneForAMoment) {
  rig_.cameras[0]->faults = {FlatCamera::Fault::Unplugged, FlatCamera::Fault::Silent};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.cameras[0]->reopened, 2);
  EXPECT_EQ(count(CaptureEventKind::Trouble), 2);
  expectWholeSide();
}

TEST_F(Sequence, DropsAPhotographThatComesTooLate) {
  rig_.cameras[1]->faults = {FlatCamera::Fault::None, FlatCamera::Fault::Late};
  ASSERT_TRUE(shoot().has_value());
  expectWholeSide();
}

TEST_F(Sequence, RefusesAnEarlierPhotograph) {
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
TEST_F(Sequence, RefusesWhatTheSideBeforeLeftBehind) {
  using Fault = FlatCamera::Fault;
  rig_.cameras[0]->faults = {Fault::None, Fault::None, Fault::None, Fault::Late, Fault::Late};
  ASSERT_TRUE(shoot().has_value());
  expectWholeSide();
  options_.side = batch::Side::Back;
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(Sequence, RefusesTheLastPhotographOfTheBatchBefore) {
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
TEST_F(Sequence, RefusesAPhotographOfTheFrontAfterTheProgramWasStartedAgain) {
  ASSERT_TRUE(shoot().has_value());
  rig_.devices.delivered.clear();
  options_.side = batch::Side::Back;
  rig_.cameras[1]->faults = {FlatCamera::Fault::Stale};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(Sequence, RefusesASeriesThatIsShiftedByOnePhotograph) {
  ASSERT_TRUE(shoot().has_value());
  options_.side = batch::Side::Back;
  rig_.cameras[1]->lags = true;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(note(0, 1), "no file");
}

TEST_F(Sequence, TellsOldPhotographsByTheSherdsWhereAPersonTurnsTheTable) {
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

TEST_F(Sequence, KeepsTheSettingsOfEachShotAndFlagsOthers) {
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

TEST_F(Sequence, SetsTheRigsSettingsBeforeASideAndComparesEachShotWithThem) {
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

TEST_F(Sequence, DoesNotBeginWithACameraThatKeepsAnotherSettingThanTheRigs) {
  rig_.devices.wanted_settings = {{{"exposure", "1/15"}}, {}};
  rig_.cameras[0]->has_dial = true;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(rig_.truth->exposures, 0);
}

TEST_F(Sequence, SetsACameraAgainThatWasSwitchedOff) {
  rig_.devices.wanted_settings = {{{"exposure", "1/15"}}, {}};
  rig_.cameras[0]->faults = {FlatCamera::Fault::None, FlatCamera::Fault::Unplugged};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_TRUE(done->flagged.empty());
  EXPECT_EQ(rig_.cameras[0]->exposure_time, "1/15");
}

TEST_F(Sequence, AsksForACutOffOrBlurredPhotographAgainAtOnce) {
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
TEST_F(Sequence, KeepsNoPhotographThatDoesNotShowItsStop) {
  rig_.cameras[1]->faults.assign(5, FlatCamera::Fault::Blurred);
  rig_.cameras[1]->faults[0] = FlatCamera::Fault::None;
  rig_.cameras[1]->faults[1] = FlatCamera::Fault::None;
  rig_.truth->scene.width = 480;  // edges of 5 pixels hide the markers' bits
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().what, HasSubstr("Camera B, position 2 failed 3 times"));
  EXPECT_EQ(note(1, 1), "no file");
}

TEST_F(Sequence, FailsInWordsWhenACameraStaysBad) {
  rig_.cameras[1]->faults.assign(4, FlatCamera::Fault::Truncated);
  rig_.cameras[1]->faults[0] = FlatCamera::Fault::None;
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().what,
              HasSubstr("Camera B, position 1 failed 3 times: the file is truncated"));
}

TEST_F(Sequence, ComesThroughAnUnpluggedTable) {
  rig_.table->faults =
      afterStop(1, {FlatTurntable::Fault::UnpluggedBefore, FlatTurntable::Fault::UnpluggedMidway});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.truth->exposures, kProofs + 6);
  EXPECT_DOUBLE_EQ(rig_.truth->degrees, 240);
  expectWholeSide();
}

TEST_F(Sequence, HomesATableThatRestarted) {
  rig_.table->faults = afterStop(1, {FlatTurntable::Fault::Restarted});
  ASSERT_TRUE(shoot().has_value());
  expectWholeSide();
}

TEST_F(Sequence, FindsThePositionByTheMarkersWhenTheTableHasNoSwitch) {
  rig_.table->has_switch = false;
  rig_.table->faults = afterStop(2, {FlatTurntable::Fault::Restarted});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(Sequence, CorrectsATableThatSlipped) {
  rig_.table->faults = afterStop(1, {FlatTurntable::Fault::Slipped});
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  expectWholeSide();
}

TEST_F(Sequence, WantsAKnownPositionAtTheStart) {
  rig_.table->has_switch = false;
  rig_.table->faults = {FlatTurntable::Fault::Restarted};
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::NotEnough);
  EXPECT_EQ(rig_.truth->exposures, 0);
}

TEST_F(Sequence, StopsOnRequestAndGoesOnLater) {
  on_event_ = [this](const CaptureEvent& e) {
    if (e.kind == CaptureEventKind::Shooting && e.stop == 1) stop_.request_stop();
  };
  const auto stopped = shoot();
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  stop_ = {};
  const auto done = shoot();
  ASSERT_TRUE(done.has_value()) << done.error().what;
  EXPECT_EQ(rig_.truth->exposures, 2 * kProofs + 6);
  expectWholeSide();
}

TEST_F(Sequence, SetsAPhotographAsideThatAPersonWantsAgain) {
  ASSERT_TRUE(shoot().has_value());
  const std::string before = note(1, 0);
  options_.retake = {{1, 0}};
  ASSERT_TRUE(shoot().has_value());
  EXPECT_NE(note(1, 0), before);
  const auto aside = readFile(folder_ / "set_aside" / "front_cam0_pos01_take1.jpg");
  ASSERT_TRUE(aside.has_value());
  EXPECT_EQ(noteOf(*aside), before);
  expectWholeSide();
}

// What was moved lies elsewhere: old photographs among the new ones would be of another plate.
TEST_F(Sequence, SetsAllPhotographsAsideThatAreWantedAgainOrFinishesItLater) {
  ASSERT_TRUE(shoot().has_value());
  std::map<std::pair<int, int>, std::string> before;
  for (int stop = 0; stop < 3; ++stop)
    for (int camera = 0; camera < 2; ++camera) {
      before[{stop, camera}] = note(stop, camera);
      options_.retake.push_back({stop, camera});
    }
  const fs::path in_the_way = folder_ / "set_aside" / "front_cam1_pos01_take1.jpg";
  std::ofstream(in_the_way) << "in the way";
  const auto broken_off = shoot();
  ASSERT_FALSE(broken_off.has_value());
  EXPECT_EQ(broken_off.error().code, ErrorCode::CannotWrite);
  fs::remove(in_the_way);
  options_.retake.clear();
  ASSERT_TRUE(shoot().has_value());
  for (const auto& [shot, of_old] : before) {
    const auto& [stop, camera] = shot;
    EXPECT_NE(note(stop, camera), of_old) << stop << ", " << camera;
    const auto aside = readFile(
        folder_ / "set_aside" /
        ("front_cam" + std::to_string(camera) + "_pos0" + std::to_string(stop) + "_take1.jpg"));
    ASSERT_TRUE(aside.has_value()) << stop << ", " << camera;
    EXPECT_EQ(noteOf(*aside), of_old);
  }
  expectWholeSide();
}

TEST_F(Sequence, NamesTheShotThatCannotBeTakenAgain) {
  options_.retake = {{98, 1}};
  const auto refused = shoot();
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().what, HasSubstr("no shot 99B"));
  EXPECT_THAT(refused.error().what, HasSubstr("positions 1 to 3 and cameras A to B"));
}

TEST_F(Sequence, NeverTouchesAPhotographThatItDidNotTake) {
  fs::create_directories(folder_ / "front");
  std::ofstream(folder_ / "front" / "cam0_pos00.jpg") << "mine";
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(readFile(folder_ / "front" / "cam0_pos00.jpg").value(), "mine");
}

TEST_F(Sequence, RefusesABatchWhosePhotographWasChanged) {
  ASSERT_TRUE(shoot().has_value());
  std::ofstream(folder_ / "front" / "cam1_pos02.jpg", std::ios::app) << "x";
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().where, HasSubstr("cam1_pos02.jpg"));
}

TEST_F(Sequence, RefusesTheBackOfABatchThatOtherCamerasBegan) {
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

TEST_F(Sequence, SaysWhenTheFolderCannotBeWritten) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "front") << "a file where a folder should be";
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::CannotWrite);
}

TEST_F(Sequence, FlagsWhatAnotherPhotographWouldNotMend) {
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

TEST(CompareSides, FindsALostSherdAndSherdsThatWereNotTurned) {
  SideCheck front;
  front.counted = true;
  front.sherds = 3;
  front.places = {{0, 0, 500}, {50, 0, 600}, {0, 50, 700}};
  SideCheck back = front;
  EXPECT_THAT(compareSides(front, back).at(0), HasSubstr("looks like the front"));
  back.places = {{2, 0, 500}, {50, 4, 600}};
  back.sherds = 2;
  EXPECT_THAT(compareSides(front, back).at(0), HasSubstr("Find the missing ones"));
  back.places.push_back({0, 56, 700});
  back.sherds = 3;
  EXPECT_TRUE(compareSides(front, back).empty());
}

}  // namespace
}  // namespace ostraka::capture
