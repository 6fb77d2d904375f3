#include "pipeline/view_masks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "mask/coarse_heights.h"

namespace ostraka::pipeline {
namespace {

using testing::Each, testing::IsEmpty, testing::Not, testing::StartsWith;

struct Notes final : Progress {
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { lines.push_back(text.english()); }
  std::vector<std::string> lines;
};

// 255 where a pixel looks at the sheet, or at what stands before it.
cv::Mat1b sheetIn(const rig::PosedImage& image, const Eigen::AlignedBox2d& sheet, cv::Size size) {
  std::vector<cv::Point> corners;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    const Eigen::Vector3d p(x ? sheet.max().x() : sheet.min().x(),
                            y ? sheet.max().y() : sheet.min().y(), 0);
    const Eigen::Vector2d pixel = image.intrinsics.project(image.camera_from_plate * p) *
                                  (static_cast<double>(size.width) / image.intrinsics.width);
    corners.emplace_back(cvRound(pixel.x()), cvRound(pixel.y()));
  }
  cv::Mat1b within(size, uchar{0});
  cv::fillConvexPoly(within, corners, cv::Scalar(255));
  return within;
}

// Photographs by hand over a printed sheet, with their true cameras: what coarse stereo confirms is
// sherd, most of every sherd is confirmed, and what it shows as bare sheet is bare.
TEST(ShownOnAPrintedSheet, IsSherdAndHardlyEverPaper) {
  const std::filesystem::path folder = std::filesystem::path(OSTRAKA_SHARED_DIR) / "batches/hand";
  const auto all = rig::readCameras(folder / "truth/cameras.json");
  const auto plate = batch::readPlate(folder / "plate.json");
  ASSERT_TRUE(all.has_value() && plate.has_value());
  std::vector<rig::PosedImage> images;
  std::vector<cv::Mat> photographs;
  for (const rig::PosedImage& image : *all) {
    if (image.side != batch::Side::Front) continue;
    images.push_back(image);
    photographs.push_back(cv::imread((folder / image.file).string(),
                                     cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION));
  }
  Notes notes;
  const auto shown =
      shownOn({*plate->sheet, {}, true}, images, photographs, {.threads = 2}, notes, {});
  ASSERT_TRUE(shown.has_value()) << shown.error().sentence();
  EXPECT_THAT(notes.lines, Not(IsEmpty()));
  EXPECT_THAT(notes.lines, Each(StartsWith("masks: ")));
  double sherd = 0, raised = 0, both = 0, ground = 0, wrong = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string name =
        "front_" + std::filesystem::path(images[i].file).stem().string() + ".png";
    cv::Mat1b truth = cv::imread((folder / "truth/masks" / name).string(), cv::IMREAD_GRAYSCALE);
    ASSERT_FALSE(truth.empty()) << name;
    const cv::Mat1f odds = mask::heightsShown((*shown)[i], photographs[i].size());
    cv::resize(cv::Mat1b(truth != 0), truth, odds.size(), 0, 0, cv::INTER_NEAREST);
    const cv::Mat1b within = sheetIn(images[i], *plate->sheet, odds.size());
    const cv::Mat1b confirmed = (odds > 3) & within, bare = (odds < -3) & within;
    sherd += cv::countNonZero(truth);
    raised += cv::countNonZero(confirmed);
    both += cv::countNonZero(confirmed & truth);
    ground += cv::countNonZero(bare);
    wrong += cv::countNonZero(bare & truth);
  }
  EXPECT_GT(both / raised, 0.99);
  EXPECT_GT(both / sherd, 0.4);  // what lies along outlines and jumps of depth is left to the rest
  EXPECT_LT(wrong / ground, 0.001);
}

TEST(CoarseReconstruction, SeesHalfAsManyPixelsInADraft) {
  EXPECT_EQ(coarseMegapixels(kUsualMegapixels), 0.5);
  EXPECT_EQ(coarseMegapixels(kDraftMegapixels), 0.25);
}

}  // namespace
}  // namespace ostraka::pipeline
