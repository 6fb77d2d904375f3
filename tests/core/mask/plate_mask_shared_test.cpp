#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <string>

#include "mask/plate_mask.h"

namespace ostraka::mask {
namespace {

// Masks of the front of the demo batch with its true cameras. metrics.md: IoU >= 0.985.
TEST(PlateMaskOnTheDemo, ReachesTheGoalWithTheEmptyPlate) {
  const std::filesystem::path folder = std::filesystem::path(OSTRAKA_SHARED_DIR) / "batches/demo";
  const auto all = rig::readCameras(folder / "truth/cameras.json");
  const auto plate = batch::readPlate(folder / "plate.json");
  ASSERT_TRUE(all.has_value() && plate.has_value());
  std::vector<rig::PosedImage> images;
  std::vector<cv::Mat> photographs, empties;
  for (const rig::PosedImage& image : *all) {
    if (image.side != batch::Side::Front) continue;
    images.push_back(image);
    photographs.push_back(cv::imread((folder / image.file).string()));
  }
  for (int camera = 0; camera < 3; ++camera)
    empties.push_back(
        cv::imread((folder / ("calib/empty_cam" + std::to_string(camera) + ".jpg")).string()));
  QuietProgress quiet;
  const auto result = maskByPlate(images, photographs, *plate, empties, {}, quiet, {});
  ASSERT_TRUE(result.has_value()) << result.error().sentence();
  double sum = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string name =
        "front_" + std::filesystem::path(images[i].file).stem().string() + ".png";
    const cv::Mat truth =
        cv::imread((folder / "truth/masks" / name).string(), cv::IMREAD_GRAYSCALE) != 0;
    ASSERT_FALSE(truth.empty()) << name;
    const cv::Mat inside = result->masks[i] >= 128;
    const double iou =
        static_cast<double>(cv::countNonZero(inside & truth)) / cv::countNonZero(inside | truth);
    EXPECT_GT(iou, 0.95) << name;
    sum += iou;
  }
  EXPECT_GE(sum / static_cast<double>(images.size()), 0.985);
}

}  // namespace
}  // namespace ostraka::mask
