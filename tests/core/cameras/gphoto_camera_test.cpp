#include "cameras/gphoto_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/parallel.h"
#include "tests/core/capture/fake_ptp_camera.h"

namespace ostraka::cameras {
namespace {

using capture::testing::FakePtpCamera;
using ::testing::Contains;
using ::testing::HasSubstr;

class GphotoCameraTest : public ::testing::Test {
 protected:
  std::unique_ptr<devices::Camera> open() {
    auto camera = openGphotoCamera(fake_.address(), devices::steadyClock());
    EXPECT_TRUE(camera.has_value()) << camera.error().what;
    return camera ? std::move(*camera) : nullptr;
  }
  std::string shoot(devices::Camera& camera, double timeout_s = 5) {
    EXPECT_TRUE(camera.trigger().has_value());
    const auto files = camera.fetch(timeout_s, {});
    return files && !files->empty() ? files->at(0).bytes : "none";
  }

  int taken_ = 0;
  FakePtpCamera fake_{[this] { return "picture " + std::to_string(++taken_); }};
};

TEST_F(GphotoCameraTest, TakesAPhotographAndBringsItsBytes) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  EXPECT_EQ(camera->id().driver, "gphoto2");
  ASSERT_TRUE(camera->getReady({}).has_value());
  EXPECT_EQ(shoot(*camera), "picture 1");
  ASSERT_TRUE(camera->getReady({}).has_value());
  EXPECT_EQ(shoot(*camera), "picture 2");
  EXPECT_EQ(fake_.exposures(), 2);
}

TEST_F(GphotoCameraTest, DropsAPhotographOfAnEarlierPressOfTheButton) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  fake_.pressButton();
  ASSERT_TRUE(camera->getReady({}).has_value());
  EXPECT_EQ(shoot(*camera), "picture 2");
}

TEST_F(GphotoCameraTest, WaitsWhileTheCameraIsBusy) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  fake_.busy = 3;
  EXPECT_EQ(shoot(*camera), "picture 1");
}

TEST_F(GphotoCameraTest, SaysThatNoPhotographCame) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  fake_.silent = 1;
  ASSERT_TRUE(camera->trigger().has_value());
  const auto files = camera->fetch(0.5, {});
  ASSERT_FALSE(files.has_value());
  EXPECT_EQ(files.error().code, ErrorCode::Missing);
}

TEST_F(GphotoCameraTest, ComesBackAfterTheConnectionBroke) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  fake_.breakConnections();
  const auto triggered = camera->trigger();
  const auto files = triggered ? camera->fetch(1, {})
                               : Result<std::vector<devices::CameraFile>>(triggered.error());
  ASSERT_FALSE(files.has_value());
  EXPECT_EQ(files.error().code, ErrorCode::Missing);
  ASSERT_TRUE(camera->reopen({}).has_value());
  ASSERT_TRUE(camera->getReady({}).has_value());
  EXPECT_THAT(shoot(*camera), HasSubstr("picture"));
}

TEST_F(GphotoCameraTest, SetsReadsBackAndRestoresSettings) {
  {
    const auto camera = open();
    ASSERT_NE(camera, nullptr);
    const auto iso = camera->set("iso", "400");
    ASSERT_TRUE(iso.has_value()) << iso.error().what;
    EXPECT_EQ(iso->value, "400");
    EXPECT_THAT(iso->choices, Contains("100"));
    EXPECT_EQ(fake_.property(0x500F), 400u);
    const auto aperture = camera->set("aperture", "f/11");  // the generic key is f-number
    ASSERT_TRUE(aperture.has_value()) << aperture.error().what;
    EXPECT_EQ(fake_.property(0x5007), 1100u);
    EXPECT_EQ(camera->set("iso", "123").error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(camera->set("smell", "1").error().code, ErrorCode::UnusableInput);
    const auto all = camera->settings();
    ASSERT_TRUE(all.has_value());
    EXPECT_GE(all->size(), 2u);
  }
  EXPECT_EQ(fake_.property(0x500F), 200u);
  EXPECT_EQ(fake_.property(0x5007), 560u);
}

TEST_F(GphotoCameraTest, NoticesASettingThatTheCameraKeeps) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  fake_.fixed = true;
  const auto iso = camera->set("iso", "400");
  ASSERT_FALSE(iso.has_value());
  EXPECT_THAT(iso.error().what, HasSubstr("200 instead of 400"));
}

TEST(GphotoCameras, ShootAtTheSameTime) {
  FakePtpCamera one([] { return std::string("one"); }), two([] { return std::string("two"); }),
      three([] { return std::string("three"); });
  std::vector<std::string> got(3);
  const std::vector<FakePtpCamera*> fakes{&one, &two, &three};
  parallelFor(3, 3, [&](std::size_t i) {
    auto camera = openGphotoCamera(fakes[i]->address(), devices::steadyClock());
    if (!camera || !(*camera)->trigger()) return;
    const auto files = (*camera)->fetch(5, {});
    if (files) got[i] = files->at(0).bytes;
  });
  EXPECT_EQ(got, (std::vector<std::string>{"one", "two", "three"}));
}

TEST(GphotoCameras, SayThatNoneIsThere) {
  const auto camera = openGphotoCamera("no such number", devices::steadyClock());
  ASSERT_FALSE(camera.has_value());
  EXPECT_EQ(camera.error().code, ErrorCode::Missing);
  EXPECT_EQ(camera.error().where, "no such number");
}

}  // namespace
}  // namespace ostraka::cameras
