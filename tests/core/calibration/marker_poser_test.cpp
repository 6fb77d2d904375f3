#include "calibration/marker_poser.h"

#include <gmock/gmock.h>

#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

using testing::ElementsAre;

const PoseOptions kPosing;

// Two photographs by one camera of the simulated rig, each with all markers where they are.
class Poser : public MarkerPoser {
 public:
  Poser(const batch::Batch& batch, Progress& progress) : MarkerPoser(batch, kPosing, progress, {}) {
    state_ = rig::trueRig();
    state_.print_errors_mm.assign(4 * batch.plate->markers.size(), Eigen::Vector3d::Zero());
    for (int stop = 0; stop < 2; ++stop) {
      places_.push_back({0, 0, stop, 0});
      std::vector<rig::PlacedMarker> seen;
      for (std::size_t m = 0; m < batch.plate->markers.size(); ++m) {
        rig::PlacedMarker marker{{batch.plate->markers[m].id, {}, 0.05}, m, {}};
        marker.corners = batch.plate->markers[m].corners;
        for (std::size_t c = 0; c < 4; ++c)
          marker.seen.corners[c] = state_.cameras[0].intrinsics.project(
              state_.cameraFromPlate(0, 0, stop) * marker.corners[c]);
        seen.push_back(marker);
      }
      dropped_.emplace_back(seen.size(), char{0});
      markers_.push_back(std::move(seen));
    }
  }
  void shift(std::size_t shot, std::size_t marker, const Eigen::Vector2d& by) {
    for (Eigen::Vector2d& corner : markers_[shot][marker].seen.corners) corner += by;
  }
  void unpose(std::size_t shot) { places_[shot].camera = -1; }
  const BatchPoses& out() const { return out_; }
  using MarkerPoser::addImage;
  using MarkerPoser::dropOutliers;
  using MarkerPoser::errorsOf;
  using MarkerPoser::plateCorners;
  using MarkerPoser::sdScale;
  using MarkerPoser::tellError;
};

class Told final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { texts.push_back(text.english()); }
  std::vector<std::string> texts;
};

class MarkersOfPhotographs : public testing::Test {
 protected:
  MarkersOfPhotographs() {
    batch_.plate = rig::ring(12);
    for (const char* file : {"a.png", "b.png"})
      batch_.shots.push_back({batch::Side::Front, 0, 0, file, {}, 1600, 1200});
  }
  batch::Batch batch_;
  Told told_;
};

TEST_F(MarkersOfPhotographs, ThatAreOffTheirPlaceByMoreThanHalfAPixelAreNotUsed) {
  Poser poser(batch_, told_);
  poser.shift(0, 7, {0.24, 0.32});  // 0.4 px
  poser.shift(1, 4, {3, -4});
  EXPECT_NEAR(poser.errorsOf(0)[7], 0.4, 1e-9);
  EXPECT_NEAR(poser.errorsOf(1)[4], 5, 1e-9);
  EXPECT_NEAR(poser.errorsOf(1)[5], 0, 1e-9);
  EXPECT_EQ(poser.plateCorners(1).size(), 2u * 12 * 4);
  poser.dropOutliers();
  EXPECT_EQ(poser.plateCorners(1).size(), (2u * 12 - 1) * 4);
  EXPECT_EQ(poser.errorsOf(1).size(), 11u);
  EXPECT_THAT(told_.texts, ElementsAre("rig: marker 4 in b.png is not used: it is off its place by "
                                       "5.00 px"));
}

// Where all of a camera scatters, its markers are no outliers.
TEST_F(MarkersOfPhotographs, AreJudgedByTheScatterOfAll) {
  Poser poser(batch_, told_);
  EXPECT_EQ(poser.sdScale(), 0.2) << "no picture is exact";
  for (std::size_t shot = 0; shot < 2; ++shot)
    for (std::size_t m = 0; m < 12; ++m) poser.shift(shot, m, {0.5, -0.5});
  // Ten times the 0.05 px expected; 1.4826 makes a standard deviation of a median.
  EXPECT_NEAR(poser.sdScale(), 14.826, 1e-6);
  poser.dropOutliers();
  EXPECT_EQ(poser.plateCorners(1).size(), 2u * 12 * 4);
  EXPECT_NEAR(poser.plateCorners(3)[0].sd_px, 0.15, 1e-12);
}

TEST_F(MarkersOfPhotographs, WithoutAPoseDoNotCount) {
  Poser poser(batch_, told_);
  poser.unpose(0);
  poser.shift(0, 4, {30, 0});
  poser.dropOutliers();
  EXPECT_THAT(told_.texts, testing::IsEmpty());
  const std::vector<PlateCorner> corners = poser.plateCorners(1);
  ASSERT_EQ(corners.size(), 12u * 4);
  for (const PlateCorner& corner : corners) EXPECT_EQ(corner.stop, 1);
}

TEST_F(MarkersOfPhotographs, MakeOneErrorOverAllCorners) {
  Poser poser(batch_, told_);
  poser.addImage({}, {1, 2});
  poser.addImage({}, {2});
  poser.addImage({}, {});
  poser.tellError("photographs");
  EXPECT_NEAR(poser.out().reprojection_rms_px, std::sqrt((1.0 + 4 + 4) / 3), 1e-12);
  EXPECT_THAT(poser.out().rms_per_image_px, ElementsAre(testing::DoubleEq(std::sqrt(2.5)), 2, 0));
  EXPECT_THAT(poser.out().markers_per_image, ElementsAre(2, 1, 0));
  EXPECT_THAT(told_.texts, ElementsAre("rig: 1.732 px over 12 marker corners in 3 photographs"));
}

}  // namespace
}  // namespace ostraka::calibration
