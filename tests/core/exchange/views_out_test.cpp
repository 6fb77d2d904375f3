#include "exchange/views_out.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "files/files.h"
#include "small_project.h"
#include "tests/core/colmap/model_forms.h"
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
  Result<archive::BagWriter> bag = archive::BagWriter::begin(folder.path() / "bag");
  ASSERT_TRUE(bag);
  const Result<void> added = addViews(*bag, folder.path(), "B0001", folder.path() / "scratch", {});
  ASSERT_TRUE(added) << added.error().sentence();
  ASSERT_TRUE(bag->finish({}));
  EXPECT_FALSE(fs::exists(folder.path() / "scratch"));
  const fs::path back = folder.path() / "bag/data/views/B0001/back";
  for (const char* name :
       {"images/0007.png", "masks/0007.mask.png", "masks/0007.png.png", "sparse/points3D.txt"})
    EXPECT_TRUE(fs::exists(back / name)) << name;
  const colmap::ColmapModel model = colmap::textModelIn(back / "sparse");
  ASSERT_EQ(model.images.size(), 8u);
  EXPECT_EQ(model.images[3].name, "0003.png");
  EXPECT_GT(model.points.size(), 100u);
  EXPECT_TRUE(model.images[3].camera_from_world.isApprox(
      stereo::ballViews({}, 4)[3].camera.camera_from_plate, 1e-9));
  EXPECT_NE(readFile(back / "photographs.csv")->find("0003.png,back/cam0_pos03.png"),
            std::string::npos);
}

// Photographs as a camera writes them: a thousand pixels wide, with noise, as JPEG.
void putLargeBatch(const fs::path& project) {
  putBatch(project);
  cv::RNG random(24);
  for (const char* side : {"front", "back"}) {
    const fs::path masks = project / "results/B0001/work" / ("masks_" + std::string(side));
    for (int i = 0; i < 8; ++i) {
      const std::string stem = "cam0_pos0" + std::to_string(i);
      const fs::path small = project / "batches/B0001" / side / (stem + ".png");
      cv::Mat photograph = cv::imread(small.string()), mask, noise;
      cv::resize(photograph, photograph, {1000, 800}, 0, 0, cv::INTER_CUBIC);
      noise.create(photograph.size(), CV_16SC3);
      random.fill(noise, cv::RNG::NORMAL, 0, 4);
      cv::add(photograph, noise, photograph, {}, CV_8U);
      fs::remove(small);
      cv::imwrite((project / "batches/B0001" / side / (stem + ".jpg")).string(), photograph);
      cv::resize(cv::imread((masks / (stem + ".png")).string(), 0), mask, {1000, 800});
      cv::imwrite((masks / (stem + ".png")).string(), mask);
    }
  }
  const fs::path file = project / "results/B0001/work/rig/cameras.json";
  std::vector<rig::PosedImage> images = *rig::readCameras(file);
  for (rig::PosedImage& image : images) {
    rig::Intrinsics& lens = image.intrinsics;
    lens = {1000, 800, 5 * lens.fx, 5 * lens.fy, 5 * lens.cx + 2, 5 * lens.cy + 2, lens.distortion};
    image.file = fs::path(image.file).replace_extension(".jpg").string();
  }
  ASSERT_TRUE(rig::writeCameras(file, images));
}

TEST(ViewsOut, TakeTheFilesThatAreSaidBeforeAndTheirSizeWithinATenth) {
  const TemporaryFolder folder;
  putLargeBatch(folder.path());
  const Result<ViewsSize> size = sizeOfViews(folder.path(), "B0001");
  ASSERT_TRUE(size) << size.error().sentence();
  Result<archive::BagWriter> bag = archive::BagWriter::begin(folder.path() / "bag");
  ASSERT_TRUE(bag);
  const Result<void> added = addViews(*bag, folder.path(), "B0001", folder.path() / "scratch", {});
  ASSERT_TRUE(added) << added.error().sentence();
  EXPECT_EQ(size->files, static_cast<int>(bag->files().size()));
  const auto said = static_cast<double>(size->bytes), is = static_cast<double>(bag->bytes());
  EXPECT_NEAR(said / is, 1, 0.1) << said << " said, " << is;
}

TEST(ViewsOut, HoldNoPictureThatALinkLeadsTo) {
  const TemporaryFolder folder;
  const fs::path project = folder.path() / "project";
  putBatch(project);
  const fs::path photograph = project / "batches/B0001/front/cam0_pos03.png";
  fs::rename(photograph, folder.path() / "private.png");
  fs::create_symlink(folder.path() / "private.png", photograph);
  Result<archive::BagWriter> bag = archive::BagWriter::begin(folder.path() / "bag");
  ASSERT_TRUE(bag);
  const Result<void> added = addViews(*bag, project, "B0001", folder.path() / "scratch", {});
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().where, photograph);
}

TEST(ViewsOut, OfABatchWithoutResultsAreAnErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  Result<archive::BagWriter> bag = archive::BagWriter::begin(folder.path() / "bag");
  ASSERT_TRUE(bag);
  const Result<void> added = addViews(*bag, folder.path(), "B0001", folder.path() / "scratch", {});
  ASSERT_FALSE(added);
  EXPECT_NE(added.error().sentence().english().find("cameras.json"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::exchange
