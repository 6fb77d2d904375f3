#include "registration/pose_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

class PoseFiguresTest : public testing::Test {
 protected:
  // The truth with the back moved by this, front's frame, mm.
  Eigen::Isometry3d movedBy(double x, double z) const {
    Eigen::Isometry3d pose = sherd_.truth;
    pose.pretranslate(Eigen::Vector3d(x, 0, z));
    return pose;
  }
  // Mean distance of what lies to the right (side 1) or the left (-1) of the sherd's middle.
  double meanAt(int side, const Eigen::Isometry3d& pose) const {
    double sum = 0;
    int count = 0;
    const FractureGaps gaps = fractureGaps(front_, back_, pose);
    const auto add = [&](const StripLevel& strip, const std::vector<float>& of_mm,
                         const Eigen::Isometry3d& front_from_side) {
      for (std::size_t i = 0; i < of_mm.size(); ++i) {
        const double x = (front_from_side * strip.points[i].cast<double>()).x();
        if (std::isnan(of_mm[i]) || side * x < 12) continue;
        sum += of_mm[i];
        ++count;
      }
    };
    add(front_.fine, gaps.front_mm, Eigen::Isometry3d::Identity());
    add(back_.fine, gaps.back_mm, pose);
    EXPECT_GT(count, 100);
    return sum / count;
  }
  double touchingShare(const Eigen::Isometry3d& pose) const {
    const FractureGaps gaps = fractureGaps(front_, back_, pose);
    EXPECT_EQ(gaps.front_mm.size(), front_.fine.points.size());
    EXPECT_EQ(gaps.back_mm.size(), back_.fine.points.size());
    const auto touches = [](float mm) { return !std::isnan(mm); };
    return static_cast<double>(std::ranges::count_if(gaps.front_mm, touches) +
                               std::ranges::count_if(gaps.back_mm, touches)) /
           static_cast<double>(gaps.front_mm.size() + gaps.back_mm.size());
  }
  SimulatedSherd sherd_ = simulatedSherd({});
  Strip front_ = std::move(*prepareStrip(sherd_.front, {}));
  Strip back_ = std::move(*prepareStrip(sherd_.back, {}));
};

TEST_F(PoseFiguresTest, TellAGoodFitAndTheWallOfFiveMillimetres) {
  const PoseFigures good = figuresAt(front_, back_, sherd_.truth);
  EXPECT_LT(good.fracture_rms_mm, 0.12);  // noise of 0.03 mm on either side
  EXPECT_GT(good.fracture_overlap, 0.3);
  EXPECT_NEAR(good.thickness_mm, 5, 0.1);
  EXPECT_LT(good.crossing_share, 0.01);
  const PoseFigures aside = figuresAt(front_, back_, movedBy(0.5, 0));
  EXPECT_GT(aside.fracture_rms_mm, 2 * good.fracture_rms_mm);
}

TEST_F(PoseFiguresTest, FollowAWallThatIsPulledApartOrPressedThrough) {
  EXPECT_NEAR(figuresAt(front_, back_, movedBy(0, -0.5)).thickness_mm, 5.5, 0.1);
  EXPECT_GT(figuresAt(front_, back_, movedBy(0, 6)).crossing_share, 0.5);
}

TEST_F(PoseFiguresTest, OfSidesThatDoNotMeetAreNone) {
  const PoseFigures apart = figuresAt(front_, back_, movedBy(200, 0));
  EXPECT_EQ(apart.fracture_rms_mm, 0);
  EXPECT_EQ(apart.fracture_overlap, 0);
  EXPECT_EQ(touchingShare(movedBy(200, 0)), 0);
}

// What a person sees of a fracture and the share that is written below are one count.
TEST_F(PoseFiguresTest, AsManyPointsHaveAGapAsTheFigureSaysTouch) {
  for (const double x : {0.0, 0.4, 0.9, 1.3})
    EXPECT_NEAR(touchingShare(movedBy(x, 0)),
                figuresAt(front_, back_, movedBy(x, 0)).fracture_overlap, 1e-9);
  EXPECT_GT(touchingShare(sherd_.truth), touchingShare(movedBy(1.3, 0)) + 0.1);
}

// Moved to the right, the back stands out there, and on the left the front does.
TEST_F(PoseFiguresTest, DistancesArePositiveWhereTheBackStandsOut) {
  EXPECT_NEAR(meanAt(1, sherd_.truth), 0, 0.05);
  EXPECT_NEAR(meanAt(-1, sherd_.truth), 0, 0.05);
  EXPECT_GT(meanAt(1, movedBy(0.3, 0)), 0.1);
  EXPECT_LT(meanAt(-1, movedBy(0.3, 0)), -0.1);
}

}  // namespace
}  // namespace ostraka::registration
