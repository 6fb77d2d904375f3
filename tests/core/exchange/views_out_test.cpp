#include "exchange/views_out.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "rig/colmap_files.h"
#include "small_project.h"
#include "textured_ball.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using catalogue::TemporaryFolder;

// A ball as a batch that was computed, its cameras named as on the computer where that was done.
void putBatch(const fs::path& project) {
  std::vector<rig::PosedImage> images;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const std::vector<stereo::View> views = stereo::ballViews({}, 4);
    const std::string name = batch::name(side);
    const fs::path masks = project / "results/B0001/work" / ("masks_" + name);
    fs::create_directories(project / "batches/B0001" / name);
    fs::create_directories(masks);
    for (std::size_t i = 0; i < views.size(); ++i) {
      rig::PosedImage image = views[i].camera;
      image.side = side;
      image.camera = 0;
      image.stop = static_cast<int>(i);
      const std::string stem = "cam0_pos0" + std::to_string(i);
      image.file = "/elsewhere/" + name + "/" + stem + ".png";
      cv::imwrite((project / "batches/B0001" / name / (stem + ".png")).string(),
                  views[i].photograph);
      cv::imwrite((masks / (stem + ".png")).string(), views[i].mask);
      images.push_back(image);
    }
  }
  fs::create_directories(project / "results" / "B0001" / "work" / "rig");
  ASSERT_TRUE(
      rig::writeCameras(project / "results" / "B0001" / "work" / "rig" / "cameras.json", images));
}

TEST(ViewsOut, HoldWhatColmapAndOpenMvsLookForAndNameTheirPhotographs) {
  const TemporaryFolder folder;
  putBatch(folder.path());
  Result<BagWriter> bag = BagWriter::begin(folder.path() / "bag");
  ASSERT_TRUE(bag);
  const Result<void> added = addViews(*bag, folder.path(), "B0001", folder.path() / "scratch", {});
  ASSERT_TRUE(added) << added.error().sentence();
  ASSERT_TRUE(bag->finish({}));
  EXPECT_FALSE(fs::exists(folder.path() / "scratch"));
  const fs::path back = folder.path() / "bag/data/views/B0001/back";
  for (const char* name :
       {"images/0007.png", "masks/0007.mask.png", "masks/0007.png.png", "sparse/points3D.txt"})
    EXPECT_TRUE(fs::exists(back / name)) << name;
  const auto model = rig::readColmapModel(back / "sparse");
  ASSERT_TRUE(model) << model.error().sentence();
  ASSERT_EQ(model->images.size(), 8u);
  EXPECT_EQ(model->images[3].name, "0003.png");
  EXPECT_GT(model->points.size(), 100u);
  EXPECT_TRUE(model->images[3].camera_from_world.isApprox(
      stereo::ballViews({}, 4)[3].camera.camera_from_plate, 1e-9));
  EXPECT_NE(readFile(back / "photographs.csv")->find("0003.png,back/cam0_pos03.png"),
            std::string::npos);
}

TEST(ViewsOut, OfABatchWithoutResultsAreAnErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  Result<BagWriter> bag = BagWriter::begin(folder.path() / "bag");
  ASSERT_TRUE(bag);
  const Result<void> added = addViews(*bag, folder.path(), "B0001", folder.path() / "scratch", {});
  ASSERT_FALSE(added);
  EXPECT_NE(added.error().sentence().find("cameras.json"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::exchange
