#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "rendering/sheet.h"
#include "rig/camera.h"
#include "rig/plate_markers.h"
#include "simulated_batch.h"
#include "virtualrig/simulate.h"
#include "virtualrig/walk_around.h"

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;

SimulateOptions small(const fs::path& output) {
  SimulateOptions options;
  options.seed = 21;
  options.sherds = 2;
  options.width = 800;
  options.output = output;
  options.threads = 1;
  options.hand_held.emplace().photographs = 3;
  return options;
}

class BatchByHand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "byhand_XXXXXX").string();
    root = mkdtemp(pattern.data());
    QuietProgress quiet;
    ASSERT_TRUE(simulateBatch(small(root / "one"), quiet, {}));
  }
  static void TearDownTestSuite() { fs::remove_all(root); }
  static fs::path root;
};
fs::path BatchByHand::root;

TEST_F(BatchByHand, IsReadAsPhotographsOfFreeCamerasOverASheet) {
  EXPECT_EQ(digestsOf(root / "one").size(), 1u + 3 + 3 + 6 + 2 + 2);
  QuietProgress quiet;
  const Result<batch::Batch> batch = batch::readBatch(root / "one", {}, quiet);
  ASSERT_TRUE(batch) << batch.error().what;
  EXPECT_EQ(batch->way, batch::Way::FreeCamera);
  EXPECT_EQ(batch->shots.size(), 6u);
  ASSERT_TRUE(batch->plate && batch->plate->sheet);
  EXPECT_TRUE(batch->plate->sheet->sizes().isApprox(Eigen::Vector2d(297, 210)));
  EXPECT_EQ(batch->plate->markers.size(), 32u);
}

TEST_F(BatchByHand, HasTheSameBytesForTheSameSeedAndAnyNumberOfThreads) {
  SimulateOptions options = small(root / "again");
  options.threads = 3;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  EXPECT_EQ(digestsOf(root / "one"), digestsOf(root / "again"));
}

TEST_F(BatchByHand, MasksAgreeWithTheProjectedMeshes) {
  const auto images = *rig::readCameras(root / "one/truth/cameras.json");
  ASSERT_EQ(images.size(), 6u);
  for (const rig::PosedImage& image : images) {
    const cv::Mat mask = cv::imread(maskOf(root / "one", image).string(), cv::IMREAD_GRAYSCALE);
    ASSERT_FALSE(mask.empty()) << image.file;
    const cv::Mat drawn = projectedMeshes(root / "one", image, mask.size());
    // OpenCV's polygons take every touched pixel: half a pixel more all around, never less.
    const double both = cv::countNonZero((mask > 0) & (drawn > 0)),
                 either = cv::countNonZero(drawn);
    EXPECT_GT(both, 500) << image.file;
    EXPECT_GE(both, 0.995 * cv::countNonZero(mask)) << image.file;
    EXPECT_GT(both / either, 0.9) << image.file;
  }
}

// Light paper spreads over black alike on all four sides, as print and sharpening do: corners may
// lie inside by some tenths of a pixel, the middle of a marker may not. Out of focus, or with a
// sherd before its edge, one in fifty may be off by a little more.
TEST_F(BatchByHand, ShowsTheMarkersWhereTheTrueCamerasProjectThem) {
  const auto images = *rig::readCameras(root / "one/truth/cameras.json");
  const batch::Plate plate = *batch::readPlate(root / "one/plate.json");
  std::size_t seen_markers = 0, off_markers = 0;
  for (const rig::PosedImage& image : images) {
    const cv::Mat photograph = cv::imread((root / "one" / image.file).string());
    const auto markers = rig::findPlateMarkers(photograph, plate);
    ASSERT_TRUE(markers);
    EXPECT_GE(markers->size(), 15u) << image.file;
    for (const rig::SeenMarker& seen : *markers) {
      Eigen::Vector2d off = Eigen::Vector2d::Zero();
      for (std::size_t c = 0; c < 4; ++c)
        off += seen.corners[c] - image.project(plate.markers[seen.id].corners[c]);
      EXPECT_LT((off / 4).norm(), 0.5) << image.file << " marker " << seen.id;
      ++seen_markers;
      off_markers += (off / 4).norm() > 0.3;
    }
  }
  EXPECT_LE(50 * off_markers, seen_markers);
}

TEST_F(BatchByHand, PhotographsTellTheirTimeAndLens) {
  const auto images = *rig::readCameras(root / "one/truth/cameras.json");
  std::set<std::string> times;
  for (const rig::PosedImage& image : images) {
    const std::string bytes = *readFile(root / "one" / image.file);
    EXPECT_NE(bytes.find("Virtual telephone"), std::string::npos) << image.file;
    const std::size_t at = bytes.find("2026:07:14 ");
    ASSERT_NE(at, std::string::npos);
    times.insert(bytes.substr(at, 19));
  }
  EXPECT_EQ(times.size(), images.size());
  EXPECT_TRUE(std::is_sorted(images.begin(), images.end(), [](const auto& a, const auto& b) {
    return a.side == b.side ? a.file < b.file : a.side < b.side;
  }));
}

// Variance of the second differences of the brightness: less where the picture is soft.
double sharpness(const fs::path& file, const cv::Rect& where) {
  const cv::Mat grey = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
  cv::Mat differences;
  cv::Laplacian(grey(where), differences, CV_32F);
  cv::Scalar mean, deviation;
  cv::meanStdDev(differences, mean, deviation);
  return deviation[0] * deviation[0];
}

TEST_F(BatchByHand, AWideOpenLensSoftensThePhotographsAndNotTheMasks) {
  SimulateOptions options = small(root / "open");
  options.fstop = 1;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  double open = 0, usual = 0;  // a telephone's lens: nearly everything is sharp
  const auto images = *rig::readCameras(root / "open/truth/cameras.json");
  for (const rig::PosedImage& image : images) {
    EXPECT_EQ(*readFile(maskOf(root / "open", image)), *readFile(maskOf(root / "one", image)));
    // The lowest rows are nearest to a low camera: 20 cm instead of 30, a blur of 4 pixels.
    const cv::Rect near(0, image.intrinsics.height * 3 / 4, image.intrinsics.width,
                        image.intrinsics.height / 4);
    open += sharpness(root / "open" / image.file, near);
    usual += sharpness(root / "one" / image.file, near);
  }
  EXPECT_LT(open, 0.8 * usual);
}

TEST_F(BatchByHand, ThingsBesideTheSherdsAreSeenAndAreNoSherds) {
  SimulateOptions options = small(root / "clutter");
  options.hand_held->clutter = 4;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  int changed = 0;
  const auto images = *rig::readCameras(root / "clutter/truth/cameras.json");
  for (const rig::PosedImage& image : images) {
    const cv::Mat with = cv::imread(maskOf(root / "clutter", image).string(), cv::IMREAD_GRAYSCALE),
                  without = cv::imread(maskOf(root / "one", image).string(), cv::IMREAD_GRAYSCALE);
    EXPECT_EQ(cv::countNonZero((with > 0) & (with != without)), 0) << image.file;
    const cv::Mat shown = cv::imread((root / "clutter" / image.file).string(), 0),
                  empty = cv::imread((root / "one" / image.file).string(), 0);
    cv::Mat difference;
    cv::absdiff(shown, empty, difference);
    changed += cv::countNonZero(difference > 60);
  }
  // A black block of the scale bar alone has 60 mm^2: 250 pixels of 0.5 mm.
  EXPECT_GT(changed, 6 * 250);
}

// A look under the raised edge met the table where the paper's shade has no end.
TEST_F(BatchByHand, ASheetThatRisesHighIsPhotographedToo) {
  SimulateOptions options = small(root / "raised");
  options.width = 320;
  options.hand_held->table = rendering::TableKind::CuttingMat;
  options.hand_held->bend_mm = 12;
  QuietProgress quiet;
  ASSERT_TRUE(simulateBatch(options, quiet, {}));
  const auto images = rig::readCameras(root / "raised" / "truth" / "cameras.json");
  ASSERT_TRUE(images);
  for (const rig::PosedImage& image : *images) {
    const cv::Mat photograph = cv::imread((root / "raised" / image.file).string());
    ASSERT_FALSE(photograph.empty()) << image.file;
    EXPECT_LT(cv::countNonZero(photograph.reshape(1) == 0), 0.05 * photograph.total() * 3);
  }
}

TEST(WalkAround, StaysWhereAPersonWithATelephoneStands) {
  rendering::HandHeldOptions hand;
  hand.photographs = 200;
  vessels::Random random(5);
  const CameraModel model = cameraModel(rendering::CameraKind::Phone, random);
  const std::vector<FreeShot> shots = walkAround(hand, model, 1600, random);
  ASSERT_EQ(shots.size(), 400u);
  double sum = 0, squares = 0, rolled = 0, drift = 0;
  std::set<int> sectors;
  for (const FreeShot& shot : shots) {
    const Eigen::Vector3d eye = shot.camera_from_plate.inverse().translation();
    const double up = std::asin(eye.z() / eye.norm()) * 180 / std::numbers::pi;
    EXPECT_GT(up, 21.99);
    EXPECT_LT(up, 72.01);
    // A4's own distance, up to the 1.5 % by which telephones differ in focal length.
    EXPECT_GT(eye.norm(), 256);
    EXPECT_LT(eye.norm(), 335);
    const double roll = std::asin(shot.camera_from_plate.linear()(0, 2)) * 180 / std::numbers::pi;
    EXPECT_LT(std::abs(roll), 7.001);
    rolled = std::max(rolled, std::abs(roll));
    const double focal = shot.intrinsics.fx / (1600 * model.focal_per_width) - 1;
    sum += focal;
    squares += focal * focal;
    drift += (shot.intrinsics.cx - 799.5) * (shot.intrinsics.cx - 799.5);
    EXPECT_EQ(shot.intrinsics.distortion, model.distortion);
    sectors.insert(static_cast<int>(std::floor(std::atan2(eye.y(), eye.x()) / 0.5236)));
  }
  // 400 draws: the SD of an SD is 3.5 %, so 12 % is more than 3 sigma.
  EXPECT_NEAR(std::sqrt(squares / 400), 0.004, 0.0005);
  EXPECT_LT(std::abs(sum / 400), 0.0008);
  EXPECT_NEAR(std::sqrt(drift / 400), 3, 0.4);
  EXPECT_GT(rolled, 4);
  EXPECT_EQ(sectors.size(), 12u);  // all around
}

TEST(WalkAround, ACameraOfALongerLensStandsFartherAway) {
  rendering::HandHeldOptions hand;
  hand.photographs = 20;
  vessels::Random random(6), other(6);
  const auto nearest = [&](const CameraModel& model, vessels::Random& from) {
    double least = 1e9;
    for (const FreeShot& shot : walkAround(hand, model, 1600, from))
      least = std::min(least, shot.camera_from_plate.inverse().translation().norm());
    return least;
  };
  const CameraModel phone = cameraModel(rendering::CameraKind::Phone, random),
                    dslr = cameraModel(rendering::CameraKind::Dslr, other);
  EXPECT_NEAR(nearest(dslr, other) / nearest(phone, random),
              dslr.focal_per_width / phone.focal_per_width, 0.01);
}

TEST(Sheet, RisesByItsBendAndSherdsLieOnIt) {
  vessels::Random random(3);
  const rendering::SheetSurface sheet(rig::SheetSize::A4, 3, random);
  float low = 1e9f, high = -1e9f;
  for (float x = -148; x <= 148; x += 4)
    for (float y = -104; y <= 104; y += 4) {
      const float z = sheet.height({x, y});
      low = std::min(low, z);
      high = std::max(high, z);
      const float step = 0.5f;
      EXPECT_NEAR(sheet.slope({x, y}).x(),
                  (sheet.height({x + step, y}) - sheet.height({x - step, y})) / (2 * step), 1e-4);
    }
  EXPECT_NEAR(high, 3, 0.1);
  EXPECT_NEAR(low, 0, 0.1);
  std::vector<Eigen::Vector3f> body;
  for (float x = -20; x <= 20; ++x)
    for (float y = -20; y <= 20; ++y) body.emplace_back(x, y, 0.f);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(60, -30, 0);
  const Eigen::Isometry3d lying = rendering::restingOn(sheet, pose, body);
  float gap = 1e9f, widest = 0;
  for (const Eigen::Vector3f& v : body) {
    const Eigen::Vector3f p = (lying * v.cast<double>()).cast<float>();
    gap = std::min(gap, p.z() - sheet.height(p.head<2>()));
    widest = std::max(widest, p.z() - sheet.height(p.head<2>()));
  }
  EXPECT_NEAR(gap, 0, 1e-4);
  EXPECT_LT(widest, 0.5);  // it is tilted along: untilted, up to 1.5 mm of air
}

TEST(Sheet, OfAnySizeHasItsMarkersOnThePaper) {
  for (const rig::SheetSize size :
       {rig::SheetSize::A4, rig::SheetSize::A3, rig::SheetSize::Letter}) {
    const batch::Plate plate = rig::sheetPlate(size);
    EXPECT_GE(plate.markers.size(), 30u);
    EXPECT_LE(plate.markers.size(), 100u);  // of DICT_5X5_100
    for (std::size_t i = 0; i < plate.markers.size(); ++i) {
      EXPECT_EQ(plate.markers[i].id, static_cast<int>(i));
      for (const Eigen::Vector3d& c : plate.markers[i].corners)
        EXPECT_TRUE(plate.sheet->contains(c.head<2>()));
    }
  }
}

TEST(HandHeldOptions, NameTheFieldThatCannotBe) {
  SimulateOptions options = small("x");
  options.hand_held->photographs = 2;
  EXPECT_NE(options.check().error().what.english().find("hand_held"), std::string::npos);
  options = small("x");
  options.hand_held->bend_mm = 50;
  EXPECT_NE(options.check().error().what.english().find("bend"), std::string::npos);
  options = small("x");
  options.fault = Fault::Blur;
  EXPECT_NE(options.check().error().what.english().find("no fault"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::virtualrig
