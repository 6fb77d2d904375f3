#include "checks/scale_check.h"

#include <gmock/gmock.h>

namespace ostraka::checks {
namespace {

using testing::HasSubstr;

// Two cameras 500 mm from the axis by the plate's markers, on +x and on +y, looking level at it.
calibration::BatchPoses twoLevelViews() {
  calibration::BatchPoses poses;
  poses.images.resize(2);
  poses.images[0].camera_from_plate.linear() << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  poses.images[1].camera_from_plate.linear() << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  for (int k = 0; k < 2; ++k) {
    poses.images[k].file = "/batch/front/cam" + std::to_string(k) + "_pos00.jpg";
    poses.images[k].intrinsics = {4000, 3000, 10000, 10000, 2000, 1500, {}};
    poses.images[k].camera_from_plate.translation() = Eigen::Vector3d(0, 0, 500);
  }
  return poses;
}

// What lies between x = -20 and x = 20 mm, and is `length_mm` long.
batch::KnownLength marked(const calibration::BatchPoses& poses, double length_mm) {
  batch::KnownLength known;
  known.length_mm = length_mm;
  for (const rig::PosedImage& image : poses.images) {
    const std::string name = std::filesystem::path(image.file).filename().string();
    known.ends[0].push_back({name, image.project({-20, 0, 0})});
    known.ends[1].push_back({name, image.project({20, 0, 0})});
  }
  return known;
}

TEST(ScaleCheck, SaysWhichLengthContradictsByHowMuchAndWhatToDo) {
  const calibration::BatchPoses poses = twoLevelViews();
  // 0.05 mm a pixel, rounding and two ends: 0.02 mm. 40 mm instead of 40.4 are 0.99 % too few.
  const ScaleCheck check = checkScale(poses, {marked(poses, 40.4)});
  ASSERT_EQ(check.doubts.size(), 1u);
  EXPECT_THAT(check.doubts[0],
              HasSubstr("the length of 40.40 mm marked on the front side measures 40.00 +- 0.02 mm "
                        "in the photographs (-0.99 %)"));
  EXPECT_THAT(check.doubts[0], HasSubstr("0.99 % too small"));
  EXPECT_THAT(check.doubts[0], HasSubstr("'ostraka plate --ruler-measured'"));
  EXPECT_THAT(check.doubts[0], HasSubstr("reprint the plate at 100 %"));
  EXPECT_EQ(check.warnings, check.doubts);
  EXPECT_TRUE(check.lengths.at(0).at("contradicts").get<bool>());
  EXPECT_NEAR(check.lengths.at(0).at("error_pct").get<double>(), -0.990, 1e-3);
}

TEST(ScaleCheck, HasNoDoubtAboutALengthThatAgrees) {
  const calibration::BatchPoses poses = twoLevelViews();
  const ScaleCheck check = checkScale(poses, {marked(poses, 40.05)});
  EXPECT_TRUE(check.doubts.empty());
  EXPECT_TRUE(check.warnings.empty());
  ASSERT_EQ(check.agreeing.size(), 1u);
  EXPECT_THAT(check.agreeing[0], HasSubstr("40.00 +- 0.02 mm"));
}

TEST(ScaleCheck, SaysWhatALengthNeedsThatCannotBeCompared) {
  const calibration::BatchPoses poses = twoLevelViews();
  batch::KnownLength known = marked(poses, 40);
  known.side = batch::Side::Back;
  const ScaleCheck check = checkScale(poses, {known});
  EXPECT_TRUE(check.doubts.empty());
  ASSERT_EQ(check.warnings.size(), 1u);
  EXPECT_THAT(check.warnings[0], HasSubstr("two photographs of the back side"));
}

TEST(ScaleCheck, DoubtsADistanceBetweenMarkersThatWereKeptOut) {
  calibration::BatchPoses poses;
  poses.held_out = {{0, 12, 290, 290.8}, {6, 18, 290, 291}};  // 0.28 and 0.34 %
  const ScaleCheck check = checkScale(poses, {});
  ASSERT_EQ(check.doubts.size(), 1u);
  EXPECT_THAT(check.doubts[0], HasSubstr("markers 6 and 18"));
  EXPECT_TRUE(check.warnings.empty()) << "the poses have warned of it already";
}

}  // namespace
}  // namespace ostraka::checks
