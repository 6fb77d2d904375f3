#include "checks/camera_settings.h"

#include <gmock/gmock.h>

namespace ostraka::checks {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

struct CameraSettings : testing::Test {
  CameraSettings() {
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
      for (int camera = 0; camera < 2; ++camera)
        for (int stop = 0; stop < 8; ++stop)
          shots.push_back({side, camera, stop, "a.jpg", {}, 60, 40});
    batch::Exif usual;
    usual.model = "EOS 250D";
    usual.focal_length_mm = 50;
    usual.f_number = 8;
    usual.exposure_s = 1.0 / 60;
    usual.iso = 200;
    usual.auto_white_balance = false;
    exif.assign(shots.size(), usual);
    for (std::size_t i = 0; i < shots.size(); ++i)
      exif[i].serial = shots[i].camera == 0 ? "0630" : "0777";
  }
  std::vector<Message> warnings() const { return settingsWarnings(shots, exif); }
  std::vector<batch::Shot> shots;
  std::vector<batch::Exif> exif;
};

TEST_F(CameraSettings, TwoCamerasWithSettingsOfTheirOwnAreWell) {
  for (std::size_t i = 0; i < shots.size(); ++i)
    if (shots[i].camera == 1) exif[i].focal_length_mm = 35;
  EXPECT_THAT(warnings(), IsEmpty());
}

TEST_F(CameraSettings, AZoomThatWasTouchedBetweenTheSidesIsNamed) {
  for (std::size_t i = 20; i < 32; ++i) exif[i].focal_length_mm = 48.5;  // back, B and some of A
  for (std::size_t i = 20; i < 24; ++i) exif[i].focal_length_mm = 50;
  const auto all = warnings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_THAT(all[0], AllOf(HasSubstr("Camera B: its focal length"), HasSubstr("(48.5 mm, 50 mm)"),
                            HasSubstr("reshoot")));
}

TEST_F(CameraSettings, AutomaticExposureIsNamedWithItsValues) {
  const double times[] = {1.0 / 60, 1.0 / 125, 0.5, 1.0 / 30, 1.0 / 15};
  for (std::size_t i = 0; i < 8; ++i) exif[i].exposure_s = times[i % 5];
  const auto all = warnings();
  ASSERT_EQ(all.size(), 1u);
  // Ten of 1/60 s; the others twice or once.
  EXPECT_THAT(all[0], HasSubstr("Camera A: its exposure time varies between photographs (1/60 s, "
                                "0.5 s, 1/125 s, 1/15 s, ...)"));
}

// Files renamed by hand: the ports changed, and B's photographs have A's name.
TEST_F(CameraSettings, ABodyUnderAnothersNameIsNamed) {
  for (std::size_t i = 16; i < 24; ++i) exif[i].serial = "0777";
  const auto all = warnings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_THAT(all[0],
              HasSubstr("Camera A: its photographs come from different cameras (0630, 0777)"));
}

TEST_F(CameraSettings, WhatIsNotWrittenDiffersFromNothing) {
  for (std::size_t i = 0; i < 4; ++i) exif[i] = {};
  EXPECT_THAT(warnings(), IsEmpty());
  EXPECT_THAT(settingsWarnings(std::span<const batch::Shot>(), {}), IsEmpty());
}

}  // namespace
}  // namespace ostraka::checks
