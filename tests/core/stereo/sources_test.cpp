#include "stereo/sources.h"

#include <gtest/gtest.h>

#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

// Six stops of one camera 30 degrees above the plate lie 51 degrees apart.
TEST(Sources, AViewFarFromAllOthersGetsItsNeighbours) {
  const TexturedBall ball;
  std::vector<std::vector<Frame>> pyramids;
  std::vector<View> views = ballViews(ball, 6);
  for (std::size_t i = 0; i < views.size(); i += 2) pyramids.push_back(buildPyramid(views[i], 1));
  std::vector<const Frame*> frames;
  for (const auto& pyramid : pyramids) frames.push_back(&pyramid.front());
  const auto links = chooseSources(frames, ball.centre.cast<float>(), {});
  ASSERT_EQ(links.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    ASSERT_EQ(links[i].size(), 2U);
    const auto apart = [&](const Link& link) {
      return (link.source - static_cast<int>(i) + 6) % 6;
    };
    EXPECT_EQ(apart(links[i][0]) + apart(links[i][1]), 6) << "one on each side";
  }
}

TEST(Sources, LieWithinTheAnglesAndLinkTheirCameras) {
  const TexturedBall ball;
  std::vector<std::vector<Frame>> pyramids;
  for (const View& view : ballViews(ball, 8)) pyramids.push_back(buildPyramid(view, 1));
  std::vector<const Frame*> frames;
  for (const auto& pyramid : pyramids) frames.push_back(&pyramid.front());
  DenseOptions options;
  options.max_sources = 4;
  const Eigen::Vector3f middle = ball.centre.cast<float>();
  const auto links = chooseSources(frames, middle, options);
  ASSERT_EQ(links.size(), frames.size());
  const Eigen::Vector3f p(5, 1, 14);
  for (std::size_t i = 0; i < links.size(); ++i) {
    EXPECT_GE(links[i].size(), 3U);
    EXPECT_LE(links[i].size(), 4U);
    for (const Link& link : links[i]) {
      const Frame& source = *frames[static_cast<std::size_t>(link.source)];
      const float cosine =
          (frames[i]->centre - middle).normalized().dot((source.centre - middle).normalized());
      EXPECT_GT(std::acos(cosine), options.min_source_angle_rad);
      EXPECT_LT(std::acos(cosine), options.max_source_angle_rad);
      const Eigen::Vector3f linked = link.rotation * frames[i]->toCamera(p) + link.translation;
      EXPECT_LT((linked - source.toCamera(p)).norm(), 1e-3F);
    }
  }
}

}  // namespace
}  // namespace ostraka::stereo
