#include "baselines/pcl_methods.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "fracture_pair.h"

namespace ostraka::baselines {
namespace {

struct Named {
  std::string name;
  double most_mm;  ///< how far from the truth it may end
  std::function<Result<Eigen::Isometry3d>(const PointCloud&, const PointCloud&,
                                          const Eigen::Isometry3d&, std::stop_token)>
      run;
};
void PrintTo(const Named& method, std::ostream* out) {
  *out << method.name;
}

// Point to point slides along a strip of one sherd's height: half a millimetre. Searches end within
// one and a half spacings of their points, those among few corners within two and a half.
std::vector<Named> methods() {
  using Pose = Eigen::Isometry3d;
  return {{"TrimmedIcp", 0.5,
           [](const PointCloud& f, const PointCloud& b, const Pose& start, std::stop_token stop) {
             return trimmedIcp(f, b, start, {}, stop);
           }},
          {"GeneralizedIcp", 0.3,
           [](const PointCloud& f, const PointCloud& b, const Pose& start, std::stop_token stop) {
             return generalizedIcp(f, b, start, {}, stop);
           }},
          {"FeatureRansac", 2.0,
           [](const PointCloud& f, const PointCloud& b, const Pose&, std::stop_token stop) {
             return featureRansac(f, b, {.max_rounds = 1500}, stop);
           }},
          {"FourPointSets", 1.8,
           [](const PointCloud& f, const PointCloud& b, const Pose&, std::stop_token stop) {
             return fourPointSets(f, b, {.bases = 8}, stop);
           }},
          {"KeypointFourPointSets", 3.0,
           [](const PointCloud& f, const PointCloud& b, const Pose&, std::stop_token stop) {
             return keypointFourPointSets(f, b, keypointDefaults(), stop);
           }}};
}

class PclMethod : public testing::TestWithParam<Named> {
 protected:
  Result<Eigen::Isometry3d> run(const PointCloud& front, const PointCloud& back,
                                std::stop_token stop = {}) const {
    return GetParam().run(front, back, registration::startOff(pair.sherd, 0.5, 0.02), stop);
  }
  FracturePair pair;
};
INSTANTIATE_TEST_SUITE_P(Each, PclMethod, testing::ValuesIn(methods()),
                         [](const auto& method) { return method.param.name; });

TEST_P(PclMethod, FindsTheKnownPose) {
  const auto found = run(pair.front, pair.back);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(pair.error_mm(*found), GetParam().most_mm);
  const Eigen::Matrix3d turn = found->linear();
  EXPECT_NEAR((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-9);
}

// PCL seeds 4PCS with the time and draws from what all threads share.
TEST_P(PclMethod, TheSameInputGivesTheSamePoseOnEveryThread) {
  Eigen::Isometry3d poses[2];
  bool found[2] = {};
  parallelFor(2, 2, [&](std::size_t i) {
    const auto pose = run(pair.front, pair.back);
    if (!pose) return;
    found[i] = true;
    poses[i] = *pose;
  });
  ASSERT_TRUE(found[0] && found[1]);
  EXPECT_TRUE(poses[0].matrix() == poses[1].matrix());
}

TEST_P(PclMethod, TooFewPointsAndPointsWithoutNormalsAreRefused) {
  const auto few = run(pair.front, firstPoints(pair.back, 15));
  ASSERT_FALSE(few.has_value());
  EXPECT_EQ(few.error().code, ErrorCode::NotEnough);
  PointCloud bare = pair.back;
  bare.normals.clear();
  const auto without = run(pair.front, bare);
  ASSERT_FALSE(without.has_value());
  EXPECT_EQ(without.error().code, ErrorCode::NotEnough);
}

TEST_P(PclMethod, StopsOnRequest) {
  std::stop_source stop;
  stop.request_stop();
  const auto found = run(pair.front, pair.back, stop.get_token());
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}

TEST(PclMethods, IcpThatMeetsNothingOrUsesUpItsRoundsDidNotConverge) {
  const FracturePair pair;
  Eigen::Isometry3d far = pair.sherd.truth;
  far.pretranslate(Eigen::Vector3d(500, 0, 0));
  IcpOptions hasty;
  hasty.max_rounds = 2;
  const Eigen::Isometry3d start = registration::startOff(pair.sherd, 0.8, 0.03);
  for (const auto& found : {trimmedIcp(pair.front, pair.back, far, {}, {}),
                            generalizedIcp(pair.front, pair.back, far, {}, {}),
                            trimmedIcp(pair.front, pair.back, start, hasty, {}),
                            generalizedIcp(pair.front, pair.back, start, hasty, {})}) {
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().code, ErrorCode::Failed);
  }
}

TEST(PclMethods, SearchesThatReachNoOverlapDidNotConverge) {
  const FracturePair pair;
  const FeatureRansacOptions ransac{.max_rounds = 500, .inlier_mm = 0.05};
  const FourPointOptions sets{.accuracy_mm = 0.02, .overlap = 0.9, .bases = 4};
  for (const auto& found : {featureRansac(pair.front, pair.back, ransac, {}),
                            fourPointSets(pair.front, pair.back, sets, {}),
                            keypointFourPointSets(pair.front, pair.back, sets, {})}) {
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().code, ErrorCode::Failed);
  }
}

TEST(PclMethods, AFeatureIsThreeHistogramsOfOneSum) {
  const FracturePair pair;
  const auto front = pointFeatures(pair.front, 4);
  ASSERT_EQ(front.size(), pair.front.size());
  double sum = 0;
  for (const float bin : front.front()) sum += bin;
  EXPECT_NEAR(sum, 300, 0.1);
}

}  // namespace
}  // namespace ostraka::baselines
