#include "baselines/super_four_point_sets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fracture_pair.h"

namespace ostraka::baselines {
namespace {

// Two scans of one broken edge, each of two thirds of the way around: half of each is also in the
// other, sampled at other places. 0.05 mm of noise.
struct HalfShared {
  PointCloud front, back;
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();

  explicit HalfShared(unsigned seed) : random(seed) {
    truth.translate(Eigen::Vector3d(30, -12, 5));
    truth.rotate(Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, -0.5).normalized()));
    addTo(front, 0, Eigen::Isometry3d::Identity());
    addTo(back, 2 * M_PI / 3, truth.inverse());
  }
  double error_mm(const Eigen::Isometry3d& pose) const {
    double sum = 0;
    for (const Eigen::Vector3f& p : back.points)
      sum += (pose * p.cast<double>() - truth * p.cast<double>()).squaredNorm();
    return std::sqrt(sum / static_cast<double>(back.size()));
  }

 private:
  double uniform() { return static_cast<double>(random()) / 4294967296.0; }
  static Eigen::Vector3d wall(double phi, double z) {
    const double r = registration::outlineRadius(phi, z, 0, 1);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  void addTo(PointCloud& cloud, double from_rad, const Eigen::Isometry3d& pose) {
    for (int k = 0; k < 4000; ++k) {
      const double phi = from_rad + uniform() * 4 * M_PI / 3, z = 5 * uniform();
      const Eigen::Vector3d p = wall(phi, z);
      const Eigen::Vector3d n =
          (wall(phi + 1e-4, z) - p).cross(wall(phi, z + 1e-4) - p).normalized();
      const double noise = 0.1 * (uniform() + uniform() + uniform() - 1.5);  // SD 0.05
      cloud.points.push_back((pose * Eigen::Vector3d(p + noise * n)).cast<float>());
      cloud.normals.push_back((pose.linear() * n).cast<float>());
    }
  }
  std::mt19937 random;
};

// Points 0.6 mm apart hold a base of 20 mm to a degree or two: 1 mm at the far end.
TEST(SuperFourPointSets, FindsTheMotionOfCloudsThatShareOnlyHalf) {
  const HalfShared pair(5);
  const auto found = superFourPointSets(pair.front, pair.back, {.overlap = 0.35}, {});
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(pair.error_mm(*found), 2.0);
  const Eigen::Matrix3d turn = found->linear();
  EXPECT_NEAR((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-9);
  EXPECT_GT(turn.determinant(), 0);
}

TEST(SuperFourPointSets, FindsTheKnownPoseOfAFractureFromNothing) {
  const FracturePair pair;
  const auto found = superFourPointSets(pair.front, pair.back, {}, {});
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(pair.error_mm(*found), 1.8) << "as 4PCS";
}

TEST(SuperFourPointSets, TheSameInputGivesTheSamePose) {
  const FracturePair pair;
  const SuperFourPointOptions hasty{.overlap = 0.1, .bases = 6};
  const auto one = superFourPointSets(pair.front, pair.back, hasty, {});
  const auto other = superFourPointSets(pair.front, pair.back, hasty, {});
  ASSERT_EQ(one.has_value(), other.has_value());
  if (one) {
    EXPECT_TRUE(one->matrix() == other->matrix());
  }
}

TEST(SuperFourPointSets, SaysSoWhereTooLittleMeets) {
  const FracturePair pair;
  const auto few = superFourPointSets(firstPoints(pair.front, 15), pair.back, {}, {});
  ASSERT_FALSE(few.has_value());
  EXPECT_EQ(few.error().code, ErrorCode::NotEnough);
  const SuperFourPointOptions strict{.accuracy_mm = 0.05, .overlap = 0.9, .bases = 4};
  const auto none = superFourPointSets(pair.front, pair.back, strict, {});
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::Failed);
}

// All points of a smooth ring lie as well elsewhere: the number of sets that are tried is bounded.
TEST(SuperFourPointSets, ARoundSmoothBreakTakesNoLonger) {
  PointCloud ring;
  for (int k = 0; k < 3000; ++k) {
    const double phi = 2 * M_PI * k / 3000;
    const Eigen::Vector3d out(std::cos(phi), std::sin(phi), 0);
    ring.points.push_back((25 * out + Eigen::Vector3d(0, 0, k % 5)).cast<float>());
    ring.normals.push_back(out.cast<float>());
  }
  const auto found = superFourPointSets(ring, ring, {.bases = 4}, {});
  EXPECT_TRUE(found.has_value() || found.error().code == ErrorCode::Failed);
}

TEST(SuperFourPointSets, StopsOnRequest) {
  const FracturePair pair;
  std::stop_source stop;
  stop.request_stop();
  const auto found = superFourPointSets(pair.front, pair.back, {}, stop.get_token());
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::baselines
