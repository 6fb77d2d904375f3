#include <algorithm>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "capture/manifest.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "files/files.h"
#include "intake/enter_results.h"
#include "intake/side_photographs.h"
#include "records/records.h"
#include "records/sherd.h"
#include "result_folder.h"
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
    return intake::enterPhotographs(catalogue(), project_->folder(), batch, anna, quiet, {});
  }
  store::BatchRow batch;
  QuietProgress quiet;
};

TEST_F(EnterPhotographs, GivesEachItsPlaceAndItsChecksum) {
  const Result<int> entered = enter();
  ASSERT_TRUE(entered) << entered.error().sentence();
  EXPECT_EQ(*entered, 8);
  const std::vector<records::PhotographRecord> all = *Batches(catalogue()).photographs(batch);
  ASSERT_EQ(all.size(), 8u);
  EXPECT_EQ(all[2].path, "batches/B0001/front/cam1_pos02.jpg");
  EXPECT_EQ(all[2].camera, 'B');
  EXPECT_EQ(all[2].stop, 2);
  const std::vector<records::FileRecord> files = *Files(catalogue()).of(batch);
  ASSERT_EQ(files.size(), 8u);
  EXPECT_EQ(files[0].role, "photo");
  EXPECT_EQ(files[0].sha256.size(), 64u);
}

TEST_F(EnterPhotographs, EntersWhatMakesTheScaleBesideThem) {
  std::ofstream(project_->batchFolder("B0001") / "plate.json")
      << R"({"dictionary":"DICT_4X4_100","markers":[{"id":3,"corners":[[0,1,0],[1,1,0],[1,0,0],)"
      << R"([0,0,0]]}]})";
  const Result<int> entered = enter();
  ASSERT_TRUE(entered) << entered.error().sentence();
  EXPECT_EQ(*entered, 8) << "it is no photograph";
  const std::vector<records::FileRecord> files = *Files(catalogue()).of(batch);
  ASSERT_EQ(files.size(), 9u);
  const auto sheet =
      std::find_if(files.begin(), files.end(), [](const auto& f) { return f.role == "scale"; });
  ASSERT_NE(sheet, files.end());
  EXPECT_EQ(sheet->path, "batches/B0001/plate.json");
}

TEST_F(EnterPhotographs, TakesNoLinkForAPhotograph) {
  const std::filesystem::path file = project_->batchFolder("B0001") / "back" / "cam1_pos03.jpg";
  std::filesystem::rename(file, folder_.path() / "private.jpg");
  std::filesystem::create_symlink(folder_.path() / "private.jpg", file);
  const Result<int> entered = enter();
  ASSERT_FALSE(entered);
  EXPECT_EQ(entered.error().where, file);
  EXPECT_TRUE(Batches(catalogue()).photographs(batch)->empty());
}

// Orientation 6, all that this camera wrote, behind the start of the JPEG.
std::string withExif(std::string jpeg) {
  return jpeg.insert(2, std::string("\xFF\xE1\0\x22"
                                    "Exif\0\0MM\0*\0\0\0\x08\0\x01"
                                    "\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
                                    36));
}

TEST_F(EnterPhotographs, KeepsWhatTheCameraAndTheCaptureWrote) {
  const std::filesystem::path folder = project_->batchFolder("B0001");
  const std::filesystem::path file = folder / "front" / "cam1_pos02.jpg";
  ASSERT_TRUE(writeFileAtomically(file, withExif(*readFile(file))));
  capture::Manifest manifest;
  manifest.stops = 4;
  manifest.cameras = 2;
  capture::ManifestEntry entry;
  entry.camera = 1;
  entry.stop = 2;
  entry.file = "front/cam1_pos02.jpg";
  entry.camera_serial = "063021004567";
  entry.angle_deg = 180;
  entry.angle_seen_deg = 179.5;
  entry.sharpness = 12.5;
  entry.checked = true;
  manifest.entries.push_back(entry);
  ASSERT_TRUE(capture::writeManifest(folder, manifest));
  ASSERT_TRUE(enter());
  const std::vector<records::PhotographRecord> all = *Batches(catalogue()).photographs(batch);
  EXPECT_EQ(all[2].exif_json, R"({"Orientation":6})");
  EXPECT_EQ(all[2].serial, "063021004567");
  EXPECT_EQ(all[2].angle_deg, 179.5);
  EXPECT_EQ(all[2].sharpness, 12.5);
  EXPECT_EQ(all[3].exif_json, "{}");
  EXPECT_EQ(all[3].serial, "");
  EXPECT_FALSE(all[3].angle_deg);
}

TEST_F(EnterPhotographs, TwiceChangesNothingAndAChangedPhotographIsInTheHistory) {
  ASSERT_TRUE(enter());
  const std::int64_t history = History(catalogue()).length();
  ASSERT_TRUE(enter());
  EXPECT_EQ(History(catalogue()).length(), history);
  photograph("front", 1, 200);
  ASSERT_TRUE(enter());
  EXPECT_GT(History(catalogue()).length(), history);
  EXPECT_EQ(Files(catalogue()).of(batch)->size(), 8u);
}

TEST_F(EnterPhotographs, EnteringResultsRecordsThoseThatTheyWereMadeFrom) {
  const std::filesystem::path out = project_->resultsFolder("B0001");
  const ResultFolder results(out, 3);
  photograph("back", 3, 7);
  photograph("back", 4, 9);
  const auto entered =
      intake::enterResults(catalogue(), project_->folder(), batch, out, anna, quiet, {});
  ASSERT_TRUE(entered) << entered.error().sentence();
  ASSERT_TRUE(entered->more_photographs);
  EXPECT_NE(entered->more_photographs->english().find("1, the first is back/cam1_pos04.jpg."),
            std::string::npos);
  std::vector<std::string> photographs;
  const auto files = Files(catalogue()).of(batch);
  ASSERT_TRUE(files);
  for (const records::FileRecord& file : *files)
    if (file.role == "photo") photographs.push_back(file.path);
  EXPECT_EQ(photographs.size(), 7u);
  EXPECT_EQ(std::ranges::count(photographs, "batches/B0001/back/cam1_pos03.jpg"), 0)
      << "another than the one that was processed";
  EXPECT_EQ(std::ranges::count(photographs, "batches/B0001/back/cam1_pos04.jpg"), 0) << "later";
}

}  // namespace
}  // namespace ostraka::catalogue
