#include "capture/rig_devices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/files/temporary_folder.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RigDevicesFile : public ::testing::Test {
 protected:
  RigDevicesFile() {
    std::ofstream(folder_ / "plate.json")
        << R"({"unit":"mm","dictionary":"DICT_4X4_50","diameter":300,"markers":[)"
        << R"({"id":3,"corners":[[1,2,0],[2,2,0],[2,1,0],[1,1,0]]}]})";
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
  fs::path file_ = folder_ / "RIG.json";
};

TEST_F(RigDevicesFile, IsReadBesideTheOtherPartsOfTheRig) {
  std::ofstream(file_)
      << R"({"format":"ostraka-rig/1","cameras":[1,2],"devices":{)"
      << R"("turntable":{"driver":"grbl","channel":"usb:1209:0001","speed_deg_s":15,)"
      << R"("clockwise":true,"shutter":"M8"},"cameras":[)"
      << R"({"driver":"gphoto2","serial":"123","settings":{"iso":"100"}},)"
      << R"({"driver":"folder","folder":"/photos"}],"settle_s":2.5}})";
  const auto read = readDevices(file_);
  ASSERT_TRUE(read.has_value()) << read.error().what;
  EXPECT_EQ(read->turntable.driver, "grbl");
  EXPECT_EQ(read->turntable.channel, "usb:1209:0001");
  EXPECT_EQ(read->turntable.baud, 115200) << "what is not written keeps its default";
  EXPECT_EQ(read->turntable.shutter, "M8");
  EXPECT_TRUE(read->turntable.clockwise);
  EXPECT_DOUBLE_EQ(read->turntable.speed_deg_s, 15);
  ASSERT_EQ(read->cameras.size(), 2u);
  EXPECT_EQ(read->cameras[0].serial, "123");
  EXPECT_EQ(read->cameras[0].settings.at("iso"), "100");
  EXPECT_EQ(read->cameras[1].folder, "/photos");
  EXPECT_DOUBLE_EQ(read->settle_s, 2.5);
  EXPECT_EQ(read->plate, folder_ / "plate.json");
}

TEST_F(RigDevicesFile, SaysWhatIsWrongWithIt) {
  std::ofstream(file_) << R"({"format":"ostraka-rig/1"})";
  EXPECT_THAT(readDevices(file_).error().what, HasSubstr("names no devices"));
  std::ofstream(file_) << R"({"devices":{"turntable":{"driver":7},"cameras":[]}})";
  EXPECT_EQ(readDevices(file_).error().code, ErrorCode::UnusableInput);
  std::ofstream(file_) << R"({"devices":{"turntable":{"driver":"steam"},)"
                       << R"("cameras":[{"driver":"folder","folder":"."}]}})";
  const auto opened = openRigDevices(file_, {}, {});
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().what, HasSubstr("steam"));
}

TEST_F(RigDevicesFile, OpensAFolderAndATableTurnedByHand) {
  std::ofstream(file_) << R"({"devices":{"turntable":{"driver":"hand"},)"
                       << R"("cameras":[{"driver":"folder","folder":"shots"}]}})";
  EXPECT_EQ(openRigDevices(file_, {}, {}).error().code, ErrorCode::Missing);
  fs::create_directories(folder_ / "shots");
  std::vector<std::string> asked;
  auto rig = openRigDevices(file_,
                            [&](const Message& sentence, std::stop_token) {
                              asked.push_back(sentence.english());
                              return asked.size() < 3;
                            },
                            {});
  ASSERT_TRUE(rig.has_value()) << rig.error().what;
  EXPECT_EQ(rig->cameras.at(0)->id().driver, "folder");
  devices::Turntable& table = *rig->turntable;
  EXPECT_FALSE(table.position_deg().has_value());
  ASSERT_TRUE(table.home({}).has_value());
  ASSERT_TRUE(table.moveTo(405, {}).has_value());
  EXPECT_EQ(table.position_deg(), 405);
  EXPECT_THAT(asked.at(1), HasSubstr("to 45 degrees"));
  ASSERT_TRUE(table.moveTo(405, {}).has_value()) << "nobody is asked twice";
  EXPECT_EQ(table.moveTo(90, {}).error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(table.position_deg().has_value());
}

}  // namespace
}  // namespace ostraka::capture
