#include "virtualrig/simulate.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "checks/photo_checks.h"
#include "cloud/nearest.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "rig/camera.h"
#include "rig/edge_width.h"
#include "rig/plate_markers.h"
#include "simulated_batch.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;

SimulateOptions tiny(const fs::path& output) {
  SimulateOptions options;
  options.seed = 21;
  options.sherds = 2;
  options.width = 320;
  options.stops = 4;
  options.output = output;
  options.threads = 1;
  return options;
}

class SimulatedBatch : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "virtualrig_XXXXXX").string();
    root = mkdtemp(pattern.data());
    QuietProgress quiet;
    ASSERT_TRUE(simulateBatch(tiny(root / "one"), quiet, {}));
  }
  static void TearDownTestSuite() { fs::remove_all(root); }
  static fs::path root;
};
fs::path SimulatedBatch::root;

TEST_F(SimulatedBatch, HoldsEveryFileOfTheLayout) {
  const auto files = digestsOf(root / "one");
  for (const char* name :
       {"plate.json", "board.json", "calib/empty_cam2.jpg", "calib/cam1_cal11.jpg",
        "front/cam0_pos03.jpg", "back/cam2_pos00.jpg", "truth/cameras.json", "truth/sherds.json",
        "truth/sherd01.ply", "truth/masks/back_cam1_pos02.png"})
    EXPECT_TRUE(files.count(name)) << name;
  EXPECT_EQ(files.size(), 2u + 24 + 24 + 3 + 36 + 2 + 2);
  QuietProgress quiet;
  const Result<batch::Batch> batch = batch::readBatch(root / "one", {}, quiet);
  ASSERT_TRUE(batch) << batch.error().sentence();
  EXPECT_EQ(batch->shots.size(), 24u);
  EXPECT_EQ(batch->plate->markers.size(), 24u);
}

// So that the same command can be given again; a folder that a person made stays.
TEST_F(SimulatedBatch, LeavesNothingOfABatchThatWasStopped) {
  class StopsAtTheFirstPhotograph final : public Progress {
   public:
    void report(std::int64_t, std::int64_t) override { source.request_stop(); }
    void note(NoteLevel, const Message&) override {}
    std::stop_source source;
  };
  StopsAtTheFirstPhotograph progress;
  const std::stop_token stop = progress.source.get_token();
  const auto done = simulateBatch(tiny(root / "new"), progress, stop);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::Cancelled);
  fs::create_directory(root / "made");
  EXPECT_FALSE(simulateBatch(tiny(root / "made"), progress, stop));  // stopped before it began
  EXPECT_FALSE(fs::exists(root / "new"));
  EXPECT_TRUE(fs::is_empty(root / "made"));
}

// Once more with three threads, and with a fault so that one rendering serves both questions.
TEST_F(SimulatedBatch, IsTheSameForThreeThreadsButForTheTwoFilesThatAFaultCutsOff) {
  SimulateOptions options = tiny(root / "three");
  options.threads = 3;
  options.fault = Fault::Truncated;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  const auto whole = digestsOf(root / "one"), cut = digestsOf(root / "three");
  ASSERT_EQ(whole.size(), cut.size());
  for (const auto& [name, digest] : whole) {
    if (name != "front/cam2_pos01.jpg" && name != "back/cam0_pos03.jpg") {
      EXPECT_EQ(cut.at(name), digest) << name;
      continue;
    }
    const std::string all = *readFile(root / "one" / name),
                      start = *readFile(root / "three" / name);
    EXPECT_LT(start.size(), 0.8 * static_cast<double>(all.size()));
    EXPECT_EQ(all.substr(0, start.size()), start) << name;
  }
}

TEST_F(SimulatedBatch, HasPosesThatAgreeAndTouchThePlate) {
  const auto truth = *readJson(root / "one/truth/sherds.json");
  ASSERT_EQ(truth["sherds"].size(), 2u);
  for (const auto& sherd : truth["sherds"]) {
    const auto front = *isometryFromJson(sherd["plate_from_model_front"], ""),
               back = *isometryFromJson(sherd["plate_from_model_back"], "");
    const auto both = *isometryFromJson(sherd["T_front_from_back"], "");
    EXPECT_LT(((both * back).matrix() - front.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    const TriangleMesh mesh = readPly(root / "one/truth" / sherd["mesh"].get<std::string>())->mesh;
    for (const Eigen::Isometry3d& pose : {front, back}) {
      float floor = 1e9f;
      for (const Eigen::Vector3f& v : mesh.vertices)
        floor = std::min(floor, (pose.cast<float>() * v).z());
      EXPECT_NEAR(floor, 0, 1e-4);
    }
    // A hand turns it over about x: the shift stays within what README tells, the other side is up.
    EXPECT_LT(front.linear().col(2).z() * back.linear().col(2).z(), 0);
    const Eigen::Vector3d off =
        back.translation() - Eigen::Vector3d(front.translation().x(), -front.translation().y(), 0);
    EXPECT_LT(off.head<2>().norm(), 13);
  }
}

TEST_F(SimulatedBatch, MasksCoverTheProjectedMeshes) {
  const auto images = *rig::readCameras(root / "one/truth/cameras.json");
  for (const rig::PosedImage& image : {images[0], images[4], images[20]}) {
    const cv::Mat mask = cv::imread(maskOf(root / "one", image).string(), cv::IMREAD_GRAYSCALE);
    const cv::Mat drawn = projectedMeshes(root / "one", image, mask.size());
    // OpenCV's polygons take every touched pixel: half a pixel more all around, never less.
    const double both = cv::countNonZero((mask > 0) & (drawn > 0)),
                 either = cv::countNonZero(drawn);
    EXPECT_GE(both, 0.995 * cv::countNonZero(mask));
    EXPECT_GT(both / either, 0.8) << image.file;
  }
}

// The chain asks for so much wider edges before it names a blur.
TEST_F(SimulatedBatch, IsBlurredByEnoughToBeToldInSmallPicturesToo) {
  SimulateOptions options = tiny(root / "blurred");
  options.sherds = 1;
  options.width = 480;
  options.fault = Fault::Blur;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  const Result<batch::Plate> plate = batch::readPlate(options.output / "plate.json");
  ASSERT_TRUE(plate);
  const auto edges = [&](const char* file) {
    const cv::Mat1b grey =
        cv::imread((options.output / "front" / file).string(), cv::IMREAD_GRAYSCALE);
    std::vector<double> widths;
    const std::vector<rig::SeenMarker> markers = *rig::findPlateMarkers(grey, *plate);
    for (const rig::SeenMarker& marker : markers) {
      const std::vector<double> found = rig::edgeWidths(grey, marker.corners);
      widths.insert(widths.end(), found.begin(), found.end());
    }
    return rig::typicalWidth(std::move(widths));
  };
  const double sharp = std::min(edges("cam1_pos00.jpg"), edges("cam1_pos01.jpg"));
  ASSERT_GT(sharp, 0);
  const checks::PhotoCheckOptions check;
  for (const char* file : {"cam1_pos02.jpg", "cam1_pos03.jpg"}) {
    EXPECT_GT(edges(file), check.most_edge_growth * sharp) << file;
    EXPECT_GT(edges(file), sharp + check.wide_edge_px) << file;
  }
}

TEST(SimulateOptions, NameTheFieldThatCannotBe) {
  SimulateOptions options = tiny("x");
  options.width = 321;
  EXPECT_NE(options.check().error().what.english().find("width"), std::string::npos);
  options = tiny("x");
  options.near_duplicates = 2;
  EXPECT_NE(options.check().error().what.english().find("near_duplicates"), std::string::npos);
  options.near_duplicates = 0;
  options.scans_only = true;
  options.fault = Fault::Blur;
  EXPECT_NE(options.check().error().what.english().find("fault is about photographs"),
            std::string::npos);
}

TEST_F(SimulatedBatch, IsNotWrittenIntoAFolderThatHoldsFiles) {
  QuietProgress quiet;
  const Result<void> again = simulateBatch(tiny(root / "one"), quiet, {});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(again.error().where, (root / "one").string());
}

TEST(SimulateOptions, AreCheckedBeforeAnythingIsMade) {
  QuietProgress quiet;
  EXPECT_EQ(simulateBatch(tiny(""), quiet, {}).error().code, ErrorCode::UnusableInput);
}

TEST(SimulatedScans, ComeWithTheirTruthAndSitOnTheMesh) {
  const TemporaryFolder temporary;
  const fs::path& root = temporary.path();
  SimulateOptions options = tiny(root);
  options.scans_only = true;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  const auto truth = *readJson(root / "truth.json");
  ASSERT_EQ(truth["pairs"].size(), 2u);
  for (const auto& pair : truth["pairs"]) {
    const PointCloud front = *readPlyCloud(root / pair["front"].get<std::string>());
    const PointCloud back = transformed(*readPlyCloud(root / pair["back"].get<std::string>()),
                                        *isometryFromJson(pair["T_front_from_back"], ""));
    const TriangleMesh mesh = readPly(root / pair["truth_mesh"].get<std::string>())->mesh;
    EXPECT_NEAR(medianSpacing(front), 0.4, 0.12);
    const KdTree tree(mesh.vertices);
    for (const PointCloud* cloud : {&front, &back}) {
      std::vector<float> off;
      for (const Eigen::Vector3f& p : cloud->points)
        off.push_back(std::sqrt(tree.nearest(p).squared_distance));
      std::nth_element(off.begin(), off.begin() + static_cast<long>(off.size() / 2), off.end());
      EXPECT_LT(off[off.size() / 2], 0.3);  // half an edge of the mesh: the nearest corner
    }
  }
}

// The points of one simulated front's broken edge.
PointCloud edgeOf(const fs::path& root, ScanNoise noise) {
  SimulateOptions options = tiny(root / (noise == ScanNoise::Stereo ? "stereo" : "scanner"));
  options.scans_only = true;
  options.scan_noise = noise;
  QuietProgress quiet;
  EXPECT_TRUE(simulateBatch(options, quiet, {}));
  const PointCloud cloud = *readPlyCloud(options.output / "front" / "f001.ply");
  PointCloud edge;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::abs(cloud.normals[i].z()) > 0.4f) continue;
    edge.points.push_back(cloud.points[i]);
    edge.normals.push_back(cloud.normals[i]);
  }
  return edge;
}

TEST(SimulatedScans, WithTheNoiseOfStereoLoseEdgeAndRoughenIt) {
  const TemporaryFolder temporary;
  const fs::path& root = temporary.path();
  const PointCloud scanner = edgeOf(root, ScanNoise::Scanner),
                   stereo = edgeOf(root, ScanNoise::Stereo);
  const auto of_scanner = static_cast<double>(scanner.size());
  EXPECT_LT(static_cast<double>(stereo.size()), 0.85 * of_scanner);  // 20 to 40 % are missing
  EXPECT_GT(static_cast<double>(stereo.size()), 0.4 * of_scanner);
  // Against the scanner's surface, as the break's own relief is as rough as the noise: 0.11 to
  // 0.16 mm of it and up to 0.1 mm outwards are, in the mean of absolute values, about 0.12 mm.
  const KdTree tree(scanner.points);
  double off_mm = 0;
  for (const Eigen::Vector3f& p : stereo.points) {
    const auto nearest = static_cast<std::size_t>(tree.nearest(p).index);
    off_mm += std::abs(scanner.normals[nearest].dot(p - scanner.points[nearest]));
  }
  EXPECT_GT(off_mm / static_cast<double>(stereo.size()), 0.08);
  EXPECT_LT(off_mm / static_cast<double>(stereo.size()), 0.2);
}

}  // namespace
}  // namespace ostraka::virtualrig
