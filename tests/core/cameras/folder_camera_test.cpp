#include "cameras/folder_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "files/files.h"
#include "tests/core/capture/flat_rig.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::cameras {
namespace {

namespace fs = std::filesystem;
using capture::testing::flatPicture;
using ::testing::HasSubstr;

// Does something at each look at the clock's time, so that writers run between two polls.
class ScriptedClock final : public devices::Clock {
 public:
  double now_s() override { return now_s_; }
  bool sleep(double seconds, std::stop_token stop) override {
    now_s_ += seconds;
    if (on_sleep) on_sleep(++sleeps_);
    return !stop.stop_requested();
  }
  std::function<void(int)> on_sleep;

 private:
  double now_s_ = 0;
  int sleeps_ = 0;
};

class FolderCameraTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary | std::ios::app) << bytes;
  }
  Result<std::vector<devices::CameraFile>> fetch() { return camera_->fetch(20, stop_.get_token()); }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
  std::shared_ptr<ScriptedClock> clock_ = std::make_shared<ScriptedClock>();
  std::unique_ptr<devices::Camera> camera_ = std::move(*openFolderCamera({folder_}, clock_));
  std::stop_source stop_;
  const std::string picture_ = flatPicture({}, 0, 0, "one");
};

TEST_F(FolderCameraTest, TakesANewFileAndLeavesItThere) {
  write("IMG_9999.JPG", picture_);
  const auto first = fetch();
  ASSERT_TRUE(first.has_value()) << first.error().what;
  EXPECT_EQ(first->at(0).bytes, picture_);
  EXPECT_TRUE(fs::exists(folder_ / "IMG_9999.JPG"));
  // The camera's own count begins anew: the order of names does not matter.
  const std::string second = flatPicture({}, 0, 45, "two");
  write("IMG_0001.JPG", second);
  const auto next = fetch();
  ASSERT_TRUE(next.has_value()) << next.error().what;
  ASSERT_EQ(next->size(), 1u);
  EXPECT_EQ(next->at(0).bytes, second);
}

TEST_F(FolderCameraTest, WaitsForAFileThatIsWrittenInTwoParts) {
  const std::size_t half = picture_.size() / 2;
  clock_->on_sleep = [&](int n) {
    if (n == 1) write("a.jpg", picture_.substr(0, half));
    if (n == 40) write("a.jpg", picture_.substr(half));  // long after it seemed steady
  };
  const auto files = fetch();
  ASSERT_TRUE(files.has_value()) << files.error().what;
  EXPECT_EQ(files->at(0).bytes, picture_);
}

TEST_F(FolderCameraTest, TakesWhatIsRenamedOrLinkedIntoTheFolder) {
  write(".a.jpg.tmp", picture_);
  clock_->on_sleep = [&](int n) {
    if (n == 3) fs::rename(folder_ / ".a.jpg.tmp", folder_ / "a.jpg");
  };
  ASSERT_TRUE(fetch().has_value());
  fs::create_directories(folder_ / "sub");
  write("sub/b.jpg", picture_);
  fs::create_hard_link(folder_ / "sub" / "b.jpg", folder_ / "b.jpg");
  ASSERT_TRUE(fetch().has_value());
}

TEST_F(FolderCameraTest, TakesTheRawFileOfTheSameName) {
  write("DSC_1.NEF", "raw");
  write("DSC_1.JPG", picture_);
  write("notes.txt", "not of this shot");
  const auto files = fetch();
  ASSERT_TRUE(files.has_value());
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ(files->at(0).name, "DSC_1.JPG");
  EXPECT_EQ(files->at(1).name, "DSC_1.NEF");
}

TEST_F(FolderCameraTest, IgnoresWhatWasThereBefore) {
  write("old.jpg", picture_);
  ASSERT_TRUE(camera_->getReady({}).has_value());
  const auto files = fetch();
  ASSERT_FALSE(files.has_value());
  EXPECT_EQ(files.error().code, ErrorCode::Missing);
  EXPECT_THAT(files.error().what, HasSubstr("within 20 seconds"));
}

TEST_F(FolderCameraTest, RefusesTwoPhotographsForOneShot) {
  write("a.jpg", picture_);
  write("b.jpg", picture_);
  const auto files = fetch();
  ASSERT_FALSE(files.has_value());
  EXPECT_EQ(files.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(files.error().what, HasSubstr("a.jpg and b.jpg"));
}

TEST_F(FolderCameraTest, NeverTakesAFileThatStaysCutOff) {
  write("a.jpg", picture_.substr(0, picture_.size() - 300));
  EXPECT_FALSE(fetch().has_value());
}

TEST_F(FolderCameraTest, StopsOnRequestAndSaysWhenTheFolderIsGone) {
  stop_.request_stop();
  EXPECT_EQ(fetch().error().code, ErrorCode::Cancelled);
  fs::remove_all(folder_);
  EXPECT_EQ(camera_->getReady({}).error().code, ErrorCode::Missing);
}

}  // namespace
}  // namespace ostraka::cameras
