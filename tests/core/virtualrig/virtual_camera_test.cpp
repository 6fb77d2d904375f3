#include "virtualrig/virtual_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"
#include "virtualrig/batch_files.h"

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;
using batch::Side;

VirtualDevicesOptions smallRig() {
  VirtualDevicesOptions options;
  options.seed = 5;
  options.sherds = 2;
  options.width = 240;
  options.stops = 4;
  return options;
}

std::string shoot(capture::RigDevices& rig, int camera, double degrees) {
  EXPECT_TRUE(rig.turntable->moveTo(degrees, {}).has_value());
  auto& device = *rig.cameras[static_cast<std::size_t>(camera)];
  EXPECT_TRUE(device.getReady({}).has_value());
  EXPECT_TRUE(device.trigger().has_value());
  const auto files = device.fetch(10, {});
  return files ? files->at(0).bytes : std::string();
}

TEST(VirtualRigDevices, TakeThePhotographsOfTheSimulatedBatch) {
  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
  SimulateOptions simulate;
  simulate.seed = 5;
  simulate.sherds = 2;
  simulate.width = 240;
  simulate.stops = 4;
  simulate.output = folder / "batch";
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(simulate, quiet, {}).has_value());
  auto rig = openVirtualRig(smallRig());
  ASSERT_TRUE(rig.has_value()) << rig.error().what;
  ASSERT_EQ(rig->cameras.size(), 3u);
  const auto batch_file = [&](Side side, int camera, int stop) {
    return readFile(folder / "batch" / photographName(side, camera, stop)).value();
  };
  EXPECT_EQ(shoot(*rig, 0, 0), batch_file(Side::Front, 0, 0));
  EXPECT_EQ(shoot(*rig, 2, 90), batch_file(Side::Front, 2, 1));
  rig->side_placed(Side::Back);
  EXPECT_EQ(shoot(*rig, 1, 360 + 270), batch_file(Side::Back, 1, 3));

  ASSERT_TRUE(
      writeVirtualCalibration(smallRig(), (folder / "other").string(), quiet, {}).has_value());
  for (const char* file :
       {"plate.json", "board.json", "calib/empty_cam1.jpg", "calib/cam2_cal11.jpg"})
    EXPECT_EQ(readFile(folder / "other" / file).value(), readFile(folder / "batch" / file).value())
        << file;
}

// Who waits sees for how many from the start; the first takes long.
class FirstReport final : public Progress {
 public:
  void report(std::int64_t done, std::int64_t total) override {
    if (!first) first = {done, total};
  }
  void note(NoteLevel, const Message&) override {}
  std::optional<std::pair<std::int64_t, std::int64_t>> first;
};

TEST(VirtualRigDevices, SayFromTheStartForHowManyCalibrationPhotographsOneWaits) {
  const TemporaryFolder folder;
  FirstReport progress;
  ASSERT_TRUE(
      writeVirtualCalibration(smallRig(), folder.path().string(), progress, {}).has_value());
  ASSERT_TRUE(progress.first);
  EXPECT_EQ(progress.first->first, 0);
  EXPECT_EQ(progress.first->second, 39);
}

TEST(VirtualRigDevices, ShowLivePicturesThatChangeOnlyWithThePlate) {
  auto rig = openVirtualRig(smallRig());
  ASSERT_TRUE(rig.has_value());
  auto& camera = *rig->cameras[1];
  const auto first = camera.preview({});
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(*camera.preview({}), *first);
  ASSERT_TRUE(rig->turntable->moveTo(13, {}).has_value());
  EXPECT_NE(*camera.preview({}), *first);
}

TEST(VirtualRigDevices, SayWhatCannotBe) {
  VirtualDevicesOptions options = smallRig();
  options.sherds = 0;
  EXPECT_EQ(openVirtualRig(options).error().code, ErrorCode::UnusableInput);
  auto rig = openVirtualRig(smallRig());
  ASSERT_TRUE(rig.has_value());
  EXPECT_FALSE(rig->cameras[0]->fetch(1, {}).has_value()) << "nothing was exposed";
  EXPECT_EQ(rig->cameras[0]->set("iso", "3200").error().code, ErrorCode::UnusableInput);
  EXPECT_TRUE(rig->cameras[0]->set("iso", "100").has_value());
}

}  // namespace
}  // namespace ostraka::virtualrig
