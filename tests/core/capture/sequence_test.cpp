#include "capture/sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/capture/photographed_side.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::noteOf;

class Sequence : public PhotographedSide {};

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

TEST_F(Sequence, SaysWhenTheFolderCannotBeWritten) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "front") << "a file where a folder should be";
  const auto done = shoot();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::CannotWrite);
}

}  // namespace
}  // namespace ostraka::capture
