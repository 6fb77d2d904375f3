#include "cameras/desktop_hold.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ostraka::cameras {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A desktop that lets go after so many programs were run.
class Desktop {
 public:
  explicit Desktop(int gives_in_after) : left_(gives_in_after) {}
  std::vector<devices::FoundDevice> devices() const {
    devices::FoundDevice camera;
    camera.kind = devices::DeviceKind::Camera;
    camera.model = "D3200";
    if (left_ > 0) camera.holders = {"gvfsd-gphoto2 (77)"};
    return {devices::FoundDevice{}, camera};
  }
  Result<void> release() {
    return releaseFromDesktop(
        devices(),
        [this](const std::string& program, const std::vector<std::string>& arguments) {
          ran.push_back(program + " " + arguments.back());
          --left_;
          return Result<void>(Error{ErrorCode::Missing, "not installed", program});
        },
        [this] { return devices(); });
  }
  std::vector<std::string> ran;

 private:
  int left_;
};

TEST(ReleaseFromDesktop, LeavesCamerasAloneThatNobodyHolds) {
  Desktop desktop(0);
  EXPECT_THAT(desktopHolders(desktop.devices()), IsEmpty());
  EXPECT_TRUE(desktop.release().has_value());
  EXPECT_THAT(desktop.ran, IsEmpty());
}

TEST(ReleaseFromDesktop, StopsTheServiceOnlyWhenAskingWasNotEnough) {
  Desktop polite(1), stubborn(2);
  EXPECT_THAT(desktopHolders(polite.devices()), ElementsAre("gvfsd-gphoto2 (77)"));
  EXPECT_TRUE(polite.release().has_value());
  EXPECT_THAT(polite.ran, ElementsAre("gio gphoto2"));
  EXPECT_TRUE(stubborn.release().has_value());
  EXPECT_THAT(stubborn.ran,
              ElementsAre("gio gphoto2", "systemctl gvfs-gphoto2-volume-monitor.service"));
}

TEST(ReleaseFromDesktop, NamesWhoStillHoldsTheCamera) {
  const auto released = Desktop(9).release();
  ASSERT_FALSE(released.has_value());
  EXPECT_THAT(released.error().sentence(), HasSubstr("gvfsd-gphoto2 (77)"));
  EXPECT_THAT(released.error().sentence(), HasSubstr("D3200"));
}

}  // namespace
}  // namespace ostraka::cameras
