#include <opencv2/imgcodecs.hpp>

#include "catalogue/enter_results.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

class EnterPhotographs : public SmallProject {
 protected:
  EnterPhotographs() : batch(newBatch({bag4})) {
    for (const char* side : {"front", "back"}) {
      std::filesystem::create_directories(project_->batchFolder("B0001") / side);
      for (int stop = 0; stop < 4; ++stop) photograph(side, stop, 40 * stop);
    }
  }
  void photograph(const std::string& side, int stop, int grey) {
    const std::string name = "cam1_pos0" + std::to_string(stop) + ".jpg";
    cv::imwrite((project_->batchFolder("B0001") / side / name).string(),
                cv::Mat(12, 16, CV_8UC3, cv::Scalar(grey, grey, grey)));
  }
  Result<int> enter() {
    return enterPhotographs(catalogue(), project_->folder(), batch, anna, quiet, {});
  }
  BatchRow batch;
  QuietProgress quiet;
};

TEST_F(EnterPhotographs, GivesEachItsPlaceAndItsChecksum) {
  const Result<int> entered = enter();
  ASSERT_TRUE(entered) << entered.error().sentence();
  EXPECT_EQ(*entered, 8);
  const std::vector<PhotographRecord> all = *catalogue().photographs(batch);
  ASSERT_EQ(all.size(), 8u);
  EXPECT_EQ(all[2].path, "batches/B0001/front/cam1_pos02.jpg");
  EXPECT_EQ(all[2].camera, 'B');
  EXPECT_EQ(all[2].stop, 2);
  const std::vector<FileRecord> files = *catalogue().files(batch);
  ASSERT_EQ(files.size(), 8u);
  EXPECT_EQ(files[0].role, "photo");
  EXPECT_EQ(files[0].sha256.size(), 64u);
}

TEST_F(EnterPhotographs, TwiceChangesNothingAndAChangedPhotographIsInTheHistory) {
  ASSERT_TRUE(enter());
  const std::int64_t history = catalogue().historyLength();
  ASSERT_TRUE(enter());
  EXPECT_EQ(catalogue().historyLength(), history);
  photograph("front", 1, 200);
  ASSERT_TRUE(enter());
  EXPECT_GT(catalogue().historyLength(), history);
  EXPECT_EQ(catalogue().files(batch)->size(), 8u);
}

}  // namespace
}  // namespace ostraka::catalogue
