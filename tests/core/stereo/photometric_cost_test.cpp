#include "stereo/photometric_cost.h"

#include <gtest/gtest.h>

#include "ball_frames.h"
#include "stereo/sources.h"

namespace ostraka::stereo {
namespace {

// In the middle of the picture of the ball.
const cv::Point kMiddle(100, 80);

class PhotometricCosts : public testing::Test {
 protected:
  std::vector<Link> linksTo(const std::vector<int>& sources) const {
    std::vector<Link> links;
    for (const int source : sources)
      links.push_back(
          linkBetween(ball_.frames[0], ball_.frames[static_cast<std::size_t>(source)], source));
    return links;
  }
  BallFrames ball_{8};
  Plane truth_ = touching(ball_.ball, ball_.frames[0], kMiddle);
};

TEST_F(PhotometricCosts, AreLeastWhereTheSurfaceIs) {
  const std::vector<Link> links = linksTo({1, 2, 3, 14, 15});
  PhotometricCost cost(ball_.all, 0, links, {});
  ASSERT_TRUE(cost.moveTo(kMiddle));
  const float at_surface = cost.cost(truth_);
  EXPECT_LT(at_surface, 0.25F);
  for (const float off_mm : {-1.0F, -0.5F, 0.5F, 1.0F})
    EXPECT_GT(cost.cost({truth_.depth + off_mm, truth_.normal}), at_surface + 0.1F) << off_mm;
  Plane tilted = truth_;
  tilted.normal = (tilted.normal + Eigen::Vector3f(0.8F, 0, 0)).normalized();
  EXPECT_GT(cost.cost(tilted), at_surface);
}

TEST_F(PhotometricCosts, OfASourceThatIsNotThereIsThatOfChance) {
  const std::vector<Link> links = linksTo({1});
  PhotometricCost one(ball_.all, 0, links, {.best_sources = 1});
  PhotometricCost three(ball_.all, 0, links, {.best_sources = 3});
  ASSERT_TRUE(one.moveTo(kMiddle) && three.moveTo(kMiddle));
  EXPECT_NEAR(three.cost(truth_), (one.cost(truth_) + 2) / 3, 1e-5);
}

TEST_F(PhotometricCosts, AreNoneOfPlanesThatNobodyCanSee) {
  const std::vector<Link> links = linksTo({1, 2});
  PhotometricCost cost(ball_.all, 0, links, {});
  EXPECT_FALSE(cost.moveTo({3, 3})) << "beside the ball";
  ASSERT_TRUE(cost.moveTo(kMiddle));
  EXPECT_EQ(cost.cost({truth_.depth, -truth_.normal}), kNoMatch);
  EXPECT_EQ(cost.cost({10 * truth_.depth, truth_.normal}), kNoMatch) << "out of their pictures";
  cost.use(0);
  EXPECT_EQ(cost.cost(truth_), kNoMatch);
}

// A photograph of something else, here the negative.
TEST_F(PhotometricCosts, LeaveASourceAsideThatShowsSomethingElse) {
  std::vector<View> views = ballViews(ball_.ball, 8);
  cv::bitwise_not(views[2].photograph, views[2].photograph);
  const Frame negative = buildPyramid(views[2], 1).front();
  ball_.all[2] = &negative;
  const std::vector<Link> links = linksTo({2, 1});
  PhotometricCost cost(ball_.all, 0, links, {.best_sources = 1});
  ASSERT_TRUE(cost.moveTo(kMiddle));
  EXPECT_EQ(cost.bestSources(truth_, 1), 2U) << "the second of the links";
  EXPECT_EQ(cost.bestSources(truth_, 3), ~0U) << "too few to choose";
  EXPECT_LT(cost.cost(truth_), 0.25F);
  cost.use(1);
  EXPECT_GT(cost.cost(truth_), 1.5F);
}

}  // namespace
}  // namespace ostraka::stereo
