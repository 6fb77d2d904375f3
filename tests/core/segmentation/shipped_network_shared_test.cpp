#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "segmentation/network_mask.h"

namespace ostraka::segmentation {
namespace {

namespace fs = std::filesystem;

// Of photographs and their masks, IoU in the mean.
double iouOf(const std::vector<cv::Mat>& photographs, const std::vector<cv::Mat>& truths) {
  const auto probabilities = sherdProbabilities(photographs, [] {}, {});
  if (!probabilities) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    cv::Mat scaled;
    cv::resize((*probabilities)[i], scaled, truths[i].size());
    const cv::Mat inside = scaled >= 128, labels = truths[i] != 0;
    sum += static_cast<double>(cv::countNonZero(inside & labels)) /
           cv::countNonZero(inside | labels);
  }
  return sum / static_cast<double>(truths.size());
}

// None of these photographs was trained on. Over all of them it reaches 0.93 to 0.98 (RESULTS.md).
class ShippedNetworkOn : public testing::TestWithParam<const char*> {};

TEST_P(ShippedNetworkOn, FindsTheSherds) {
  const fs::path batch = fs::path(OSTRAKA_SHARED_DIR) / "batches" / GetParam();
  std::vector<fs::path> photographs;
  for (const auto& entry : fs::directory_iterator(batch / "front"))
    photographs.push_back(entry.path());
  std::sort(photographs.begin(), photographs.end());
  photographs.resize(6);
  std::vector<cv::Mat> pictures, truths;
  for (const fs::path& photograph : photographs) {
    const std::string name = "front_" + photograph.stem().string() + ".png";
    pictures.push_back(cv::imread(photograph.string()));
    truths.push_back(cv::imread((batch / "truth/masks" / name).string(), cv::IMREAD_GRAYSCALE));
  }
  EXPECT_GT(iouOf(pictures, truths), 0.9);
}
INSTANTIATE_TEST_SUITE_P(Batches, ShippedNetworkOn, testing::Values("demo", "light", "hand"),
                         [](const auto& batch) { return std::string(batch.param); });

TEST(ShippedNetworkOnATelephonesPhotographs, FindsTheApple) {
  const fs::path apple = fs::path(OSTRAKA_SHARED_DIR) / "real/apple";
  std::vector<cv::Mat> pictures, truths;
  for (const std::string name : {"00", "10", "20", "30"}) {
    const fs::path mask = apple / "masks" / (name + ".png");
    pictures.push_back(cv::imread((apple / "photographs" / (name + ".jpg")).string()));
    truths.push_back(cv::imread(mask.string(), cv::IMREAD_GRAYSCALE));
  }
  EXPECT_GT(iouOf(pictures, truths), 0.75);  // one that knows only clay reaches 0.12
}

}  // namespace
}  // namespace ostraka::segmentation
