#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "segmentation/network_mask.h"

namespace ostraka::segmentation {
namespace {

namespace fs = std::filesystem;

double iouOf(const cv::Mat& photograph, const cv::Mat& truth) {
  const auto says = maskByShippedNetwork(photograph);
  EXPECT_TRUE(says.has_value());
  cv::Mat scaled;
  cv::resize(*says, scaled, truth.size());
  const cv::Mat inside = scaled >= 128, labels = truth != 0;
  return static_cast<double>(cv::countNonZero(inside & labels)) / cv::countNonZero(inside | labels);
}

// None of these photographs was trained on. By itself the network need not be exact, only right.
class ShippedNetworkOn : public testing::TestWithParam<const char*> {};

TEST_P(ShippedNetworkOn, FindsTheSherds) {
  const fs::path batch = fs::path(OSTRAKA_SHARED_DIR) / "batches" / GetParam();
  double sum = 0;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(batch / "front")) {
    const std::string name = "front_" + entry.path().stem().string() + ".png";
    sum += iouOf(cv::imread(entry.path().string()),
                 cv::imread((batch / "truth/masks" / name).string(), cv::IMREAD_GRAYSCALE));
    if (++count == 6) break;
  }
  EXPECT_GT(sum / count, 0.9);
}
INSTANTIATE_TEST_SUITE_P(Batches, ShippedNetworkOn, testing::Values("demo", "light", "hand"),
                         [](const auto& batch) { return std::string(batch.param); });

TEST(ShippedNetworkOnATelephonesPhotographs, FindsTheApple) {
  const fs::path apple = fs::path(OSTRAKA_SHARED_DIR) / "real/apple";
  double sum = 0;
  for (const char* name : {"00", "10", "20", "30"})
    sum += iouOf(cv::imread((apple / "photographs" / (std::string(name) + ".jpg")).string()),
                 cv::imread((apple / "masks" / (std::string(name) + ".png")).string(),
                            cv::IMREAD_GRAYSCALE));
  EXPECT_GT(sum / 4, 0.75);
}

}  // namespace
}  // namespace ostraka::segmentation
