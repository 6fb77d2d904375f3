// Predictions for a small rig: pictures of 400 pixels, four stops, one sherd of each size.
#include "virtualrig/predict.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <numbers>

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double kDegree = std::numbers::pi / 180;

// 1120 pixels wide, 0.34 mm a pixel, cameras at 25, 44 and 64 degrees.
VirtualRig designedRig() {
  vessels::Random random(5);
  return makeRig(1120, 4, random);
}

// The two lower cameras carried up about the plate's middle, beside the highest.
VirtualRig steepRig() {
  VirtualRig rig = designedRig();
  for (int c = 0; c < 2; ++c) {
    Eigen::Isometry3d& pose = rig.camera_from_room[static_cast<std::size_t>(c)];
    const Eigen::Vector3d axis =
        pose.inverse().translation().cross(Eigen::Vector3d::UnitZ()).normalized();
    pose = pose * Eigen::AngleAxisd(elevation(rig, c) - 64 * kDegree, axis);
  }
  return rig;
}

rig::Rig calibrated(const VirtualRig& from) {
  rig::Rig rig;
  for (int c = 0; c < from.cameras(); ++c) {
    rig::RigCamera camera;
    camera.camera = c;
    camera.intrinsics = from.intrinsics[static_cast<std::size_t>(c)];
    camera.camera_from_turntable = from.camera_from_room[static_cast<std::size_t>(c)];
    rig.cameras.push_back(camera);
  }
  for (std::size_t k = 0; k < from.angles_rad.size(); ++k) {
    rig.stops.push_back(static_cast<int>(k));
    rig.stop_angles_rad.push_back(from.angles_rad[k] - from.angles_rad[0]);
  }
  return rig;
}

class Predict : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "ostraka_predict_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    designed_ = of(designedRig(), "designed");
    steep_ = of(steepRig(), "steep");
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static Prediction of(const VirtualRig& rig, const char* name) {
    PredictOptions options;
    options.width = 560;
    options.sherds_per_size = 1;
    options.work = folder_ / name;
    QuietProgress quiet;
    const Result<Prediction> prediction = predict(calibrated(rig), options, quiet, {});
    EXPECT_TRUE(prediction.has_value()) << prediction.error().sentence();
    return prediction ? *prediction : Prediction();
  }

  static fs::path folder_;
  static Prediction designed_, steep_;
};

fs::path Predict::folder_;
Prediction Predict::designed_, Predict::steep_;

TEST_F(Predict, TellsWhatToExpectOfEachSize) {
  const std::array<std::pair<double, double>, 3> widths{{{18, 34}, {38, 58}, {68, 96}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const SizePrediction& size = designed_.sizes[k];
    EXPECT_GT(size.width_mm, widths[k].first) << size.name;
    EXPECT_LT(size.width_mm, widths[k].second) << size.name;
    EXPECT_EQ(size.sherds, 1);
    EXPECT_GT(size.seen, 0.9) << size.name;
  }
  // Pictures of 0.69 mm a pixel are too coarse for models worth judging, but the large one has one.
  EXPECT_EQ(designed_.sizes[2].without_model, 0);
  EXPECT_GT(designed_.sizes[2].accuracy_mm, 0.02);
}

TEST_F(Predict, CarriesFiguresToTheRigsOwnResolution) {
  EXPECT_EQ(designed_.photographs, 2 * 3 * 4);
  EXPECT_DOUBLE_EQ(designed_.width_share, 0.5);
  EXPECT_GT(designed_.seconds, 0);
  EXPECT_DOUBLE_EQ(designed_.expectedSeconds(designed_.seconds), 4 * designed_.seconds);
  EXPECT_DOUBLE_EQ(designed_.expectedAccuracy(designed_.sizes[2]),
                   designed_.sizes[2].accuracy_mm / 2);
}

// What each sherd adds and what any batch takes is what the simulated one took, but for what lies
// between the stages.
TEST_F(Predict, SharesTheSecondsOutAmongTheSherds) {
  double together = designed_.fixed_seconds;
  for (const SizePrediction& size : designed_.sizes) together += size.sherds * size.seconds;
  EXPECT_LE(together, designed_.seconds);
  EXPECT_GT(together, 0.7 * designed_.seconds);
  // By surface: 82 mm across against 26.
  EXPECT_GT(designed_.sizes[2].seconds, 4 * designed_.sizes[0].seconds);
  EXPECT_GT(designed_.sizes[0].seconds, 0);
}

TEST_F(Predict, RanksARigThatOnlyLooksDownSteeplyAsWorse) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(steep_.sizes[k].break_seen, designed_.sizes[k].break_seen) << steep_.sizes[k].name;
}

// Four stops show the breaks better with the highest camera lower; whether models are better is
// for the simulation to say.
TEST_F(Predict, SimulatesAMoveBeforeItIsRecommended) {
  ASSERT_EQ(designed_.moves.size(), 1U);
  const MoveTried& tried = designed_.moves[0];
  EXPECT_LT(tried.move.raise_rad, 0);
  for (const SizePrediction& size : tried.sizes) EXPECT_EQ(size.sherds, 1);
  EXPECT_NE(tried.sizes[2].accuracy_mm, designed_.sizes[2].accuracy_mm);
  EXPECT_EQ(tried.better, isBetter(tried.sizes, designed_.sizes));
  char figure[32];
  std::snprintf(figure, sizeof figure, ", %.3f mm and ",
                designed_.expectedAccuracy(tried.sizes[2]));
  EXPECT_THAT(designed_.remarks,
              Contains(AllOf(HasSubstr("Camera C"), HasSubstr(figure), HasSubstr(" instead of "),
                             HasSubstr(tried.better ? " should be lower, by "
                                                    : "models would not be better"))));
}

TEST(IsBetter, AsksForMoreThanChanceAndForNoLossElsewhere) {
  std::array<SizePrediction, 3> before;
  for (SizePrediction& size : before) {
    size.sherds = 2;
    size.accuracy_mm = 0.1;
    size.completeness_percent = 96;
  }
  const auto changed = [&](double accuracy_mm, double percent, int without_model = 0) {
    auto after = before;
    after[0].accuracy_mm = accuracy_mm;
    after[0].completeness_percent = percent;
    after[0].without_model = without_model;
    return isBetter(after, before);
  };
  EXPECT_FALSE(changed(0.1, 96));
  EXPECT_TRUE(changed(0.07, 96));        // 11 % in the geometric mean of the sizes
  EXPECT_FALSE(changed(0.08, 96));       // 7 %
  EXPECT_TRUE(changed(0.1, 99.3));       // 1.1 % in the mean
  EXPECT_FALSE(changed(0.07, 95));       // more accurate, less complete
  EXPECT_FALSE(changed(0.11, 99.3));     // more complete, less accurate: 3.2 %
  EXPECT_FALSE(changed(0.07, 99.9, 1));  // but a model is lost
  auto after = before;
  for (SizePrediction& size : after) size.accuracy_mm = 0.05;
  EXPECT_TRUE(isBetter(after, before));
  after[2].accuracy_mm = 0.14;  // two sizes gain, one loses too much
  EXPECT_FALSE(isBetter(after, before));
  before[0].without_model = 1;
  EXPECT_TRUE(changed(0.1, 96, 0));  // a model more
}

TEST_F(Predict, KnowsHowTheCamerasStand) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(steep_.elevations_rad[c], 64 * kDegree, 3 * kDegree);
  EXPECT_THAT(designed_.remarks, Not(Contains(HasSubstr("falls outside"))));
  EXPECT_GT(designed_.elevations_rad[2], designed_.elevations_rad[0]);
}

}  // namespace
}  // namespace ostraka::virtualrig
