#include "checks/moved_cameras.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/json.h"
#include "rig/rig.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::checks {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

class MovedCameras : public ::testing::Test {
 protected:
  static rig::Rig rigOf(int cameras, double height_mm) {
    rig::Rig rig;
    for (int c = 0; c < cameras; ++c) {
      rig::RigCamera camera;
      camera.camera = c;
      camera.intrinsics.width = 1600;
      camera.intrinsics.height = 1200;
      camera.intrinsics.fx = camera.intrinsics.fy = 2200;
      camera.intrinsics.cx = 800;
      camera.intrinsics.cy = 600;
      camera.camera_from_turntable.translation() = Eigen::Vector3d(0, 10.0 * c, height_mm);
      rig.cameras.push_back(camera);
    }
    rig.stops = {0, 1};
    rig.stop_angles_rad = {0, 3.14};
    return rig;
  }
  void compute(const rig::Rig& found, const ordered_json& cameras) {
    ASSERT_TRUE(rig::writeRig(output() / "work" / "rig" / "rig.json", found).has_value());
    ASSERT_TRUE(
        writeJson(output() / "work" / "rig" / "stage.json", {{"figures", {{"cameras", cameras}}}})
            .has_value());
  }
  fs::path output() const { return folder_ / "out"; }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

ordered_json camera(int number, double residual_px, double moved_mm) {
  return {{"camera", number},
          {"median_residual_px", 0.1},
          {"known_rig_residual_px", residual_px},
          {"moved_mm", moved_mm},
          {"turned_rad", 0.01}};
}

TEST_F(MovedCameras, AreThoseThatMissTheMarkersByMoreThanHalfAPixel) {
  compute(rigOf(3, 500),
          ordered_json::array({camera(0, 0.2, 0), camera(1, 0.9, 2.5), camera(2, 0.5, 0.3)}));
  const auto moved = movedCameras(output());
  ASSERT_TRUE(moved.has_value()) << moved.error().sentence();
  ASSERT_EQ(moved->size(), 1U);
  EXPECT_EQ(moved->front().camera, 1);
  EXPECT_EQ(moved->front().residual_px, 0.9);
  EXPECT_EQ(moved->front().moved_mm, 2.5);
}

TEST_F(MovedCameras, ABatchThatWasNotComputedSaysNothing) {
  EXPECT_FALSE(movedCameras(output()).has_value());
  compute(rigOf(1, 500), ordered_json::array({ordered_json{{"camera", 1}}}));
  EXPECT_EQ(movedCameras(output()).error().code, ErrorCode::UnusableInput);
}

TEST_F(MovedCameras, TheRigIsCalibratedByTheBatchAndTheOldOneIsKept) {
  const fs::path file = folder_ / "RIG.json";
  ASSERT_TRUE(rig::writeRig(file, rigOf(3, 500)).has_value());
  // What the laboratory wrote besides: which camera stands where.
  ordered_json whole = ordered_json::parse(*readFile(file));
  whole["devices"] = {{"turntable", "COM3"}};
  ASSERT_TRUE(writeJson(file, whole).has_value());
  const std::string before = *readFile(file);
  compute(rigOf(3, 507), ordered_json::array());

  const auto kept = calibrateFrom(output(), file);
  ASSERT_TRUE(kept.has_value()) << kept.error().sentence();
  EXPECT_EQ(kept->filename(), "RIG.before-1.json");
  EXPECT_EQ(*readFile(*kept), before);
  const auto now = rig::readRig(file);
  ASSERT_TRUE(now.has_value());
  EXPECT_EQ(now->cameras[2].camera_from_turntable.translation(), Eigen::Vector3d(0, 20, 507));
  EXPECT_EQ(ordered_json::parse(*readFile(file))["devices"]["turntable"], "COM3");
  EXPECT_EQ(calibrateFrom(output(), file)->filename(), "RIG.before-2.json");
}

TEST_F(MovedCameras, ARigOfOtherCamerasStaysAsItIs) {
  const fs::path file = folder_ / "RIG.json";
  ASSERT_TRUE(rig::writeRig(file, rigOf(2, 500)).has_value());
  const std::string before = *readFile(file);
  compute(rigOf(3, 507), ordered_json::array());
  EXPECT_EQ(calibrateFrom(output(), file).error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(*readFile(file), before);
  fs::remove_all(output());
  EXPECT_FALSE(calibrateFrom(output(), file).has_value());
  EXPECT_EQ(*readFile(file), before);
}

}  // namespace
}  // namespace ostraka::checks
