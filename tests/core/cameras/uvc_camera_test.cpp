#include "cameras/uvc_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/core/files/temporary_folder.h"

namespace ostraka::cameras {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A numbered sequence stands for the camera: frame n is of one brightness, 10 n.
class UvcCameraTest : public ::testing::Test {
 protected:
  UvcCameraTest() {
    for (int n = 0; n < 20; ++n) {
      char name[32];
      std::snprintf(name, sizeof name, "img_%04d.png", n);
      cv::imwrite((folder_ / name).string(), cv::Mat3b(48, 64, cv::Vec3b::all(uchar(10 * n))));
    }
  }
  std::unique_ptr<devices::Camera> open(UvcOptions options = {}) {
    options.source = (folder_ / "img_%04d.png").string();
    auto camera = openUvcCamera(options, devices::steadyClock());
    EXPECT_TRUE(camera.has_value()) << camera.error().what;
    return camera ? std::move(*camera) : nullptr;
  }
  static int frameOf(const std::string& jpeg) {
    const cv::Mat picture =
        cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_GRAYSCALE);
    return picture.empty() ? -1 : (picture.at<uchar>(20, 20) + 5) / 10;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(UvcCameraTest, DropsWhatLiesInTheBuffersBeforeAPhotograph) {
  const auto camera = open({.source = {}, .width = 0, .height = 0, .most_stale = 5});
  ASSERT_NE(camera, nullptr);
  ASSERT_TRUE(camera->getReady({}).has_value());
  ASSERT_TRUE(camera->trigger().has_value());
  const auto files = camera->fetch(1, {});
  ASSERT_TRUE(files.has_value());
  ASSERT_EQ(files->size(), 1u);
  EXPECT_GE(frameOf(files->at(0).bytes), 1);
  EXPECT_LE(frameOf(files->at(0).bytes), 5);
  EXPECT_FALSE(camera->fetch(1, {}).has_value()) << "one photograph per press";
}

TEST_F(UvcCameraTest, ShowsALivePicture) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  const int first = frameOf(camera->preview({}).value());
  EXPECT_EQ(frameOf(camera->preview({}).value()), first + 1);
}

TEST_F(UvcCameraTest, SaysThatItIsGoneAndComesBack) {
  const auto camera = open();
  ASSERT_NE(camera, nullptr);
  Result<void> triggered;
  for (int k = 0; k < 20 && triggered; ++k) triggered = camera->trigger();
  ASSERT_FALSE(triggered.has_value());
  EXPECT_EQ(triggered.error().code, ErrorCode::Missing);
  ASSERT_TRUE(camera->reopen({}).has_value());
  EXPECT_TRUE(camera->trigger().has_value());
}

TEST_F(UvcCameraTest, RefusesPicturesOfAnotherSizeAndUnknownSettings) {
  const auto camera = open({.source = {}, .width = 640, .height = 480, .most_stale = 0});
  ASSERT_NE(camera, nullptr);
  ASSERT_TRUE(camera->trigger().has_value());
  EXPECT_THAT(camera->fetch(1, {}).error().what, HasSubstr("64x48"));
  EXPECT_EQ(camera->set("iso", "100").error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(camera->set("focus", "near").error().code, ErrorCode::UnusableInput);
}

TEST(UvcCameras, AreMissedInWords) {
  const auto camera = openUvcCamera({.source = "/dev/no-such-video"}, devices::steadyClock());
  ASSERT_FALSE(camera.has_value());
  EXPECT_EQ(camera.error().code, ErrorCode::Missing);
}

}  // namespace
}  // namespace ostraka::cameras
