#include "rig/marker_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ostraka::rig {
namespace {

double encoded(double linear) {
  return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

// A black square on white paper in linear light, blurred, then stored by the sRGB curve.
cv::Mat photographOf(const Quad& quad, double blur_px, double noise) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1);
  const Eigen::Vector2d centre = (quad[0] + quad[1] + quad[2] + quad[3]) / 4;
  cv::Mat image(static_cast<int>(centre.y() * 2), static_cast<int>(centre.x() * 2), CV_8U);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      double inside = 1;
      for (int e = 0; e < 4; ++e) {
        const Eigen::Vector2d d = (quad[(e + 1) % 4] - quad[e]).normalized();
        Eigen::Vector2d n(d.y(), -d.x());
        if (n.dot(quad[e] - centre) < 0) n = -n;
        const double across = n.dot(Eigen::Vector2d(x, y) - quad[e]);
        inside *= 0.5 * std::erfc(across / blur_px * M_SQRT1_2);
      }
      const double linear = 0.02 * inside + 0.6 * (1 - inside);
      image.at<unsigned char>(y, x) =
          cv::saturate_cast<unsigned char>(encoded(linear * (1 + noise * normal(random))));
    }
  return image;
}

const Quad kQuad{Eigen::Vector2d(40.3, 42.8), Eigen::Vector2d(118.6, 37.1),
                 Eigen::Vector2d(124.2, 109.7), Eigen::Vector2d(35.9, 101.4)};

Quad moved(Quad quad, double by) {
  for (int c = 0; c < 4; ++c) quad[c] += Eigen::Vector2d(c % 2 ? by : -by, c < 2 ? by : -by);
  return quad;
}

TEST(RefineByEdges, FindsBlurredCornersWithoutTheInsetOfStoredValues) {
  for (const double blur : {0.6, 1.0, 1.4}) {
    const auto found = refineByEdges(photographOf(kQuad, blur, 0), moved(kQuad, 0.7), 4);
    ASSERT_TRUE(found.has_value()) << blur;
    // Eight bits in the dark leave 0.02 px; in stored values the inset is 0.3 px.
    for (int c = 0; c < 4; ++c) EXPECT_LT(((*found)[c] - kQuad[c]).norm(), 0.04) << blur;
  }
}

Quad enlarged(Quad quad, double factor) {
  for (Eigen::Vector2d& corner : quad) corner *= factor;
  return quad;
}

// Large photographs are softer in pixels; the band beside an edge follows the blur.
TEST(RefineByEdges, FollowsTheBlurOfLargePictures) {
  const Quad large = enlarged(kQuad, 4);
  for (const double blur : {2.0, 4.0, 6.0}) {
    const auto found = refineByEdges(photographOf(large, blur, 0.02), moved(large, 4), 4);
    ASSERT_TRUE(found.has_value()) << blur;
    // A tenth of the sharp picture's pixel; with the noise of a real one.
    for (int c = 0; c < 4; ++c) EXPECT_LT(((*found)[c] - large[c]).norm(), 0.1) << blur;
  }
}

TEST(RefineByEdges, HoldsUnderFivePercentOfNoise) {
  const auto found = refineByEdges(photographOf(kQuad, 0.8, 0.05), moved(kQuad, 0.7), 4);
  ASSERT_TRUE(found.has_value());
  for (int c = 0; c < 4; ++c) EXPECT_LT(((*found)[c] - kQuad[c]).norm(), 0.1);
}

TEST(RefineByEdges, GivesNothingWhereThereIsNoEdge) {
  EXPECT_FALSE(refineByEdges(cv::Mat(160, 160, CV_8U, cv::Scalar(90)), kQuad, 4).has_value());
  Quad outside = kQuad;
  for (Eigen::Vector2d& corner : outside) corner.x() += 60;
  EXPECT_FALSE(refineByEdges(photographOf(kQuad, 0.8, 0), outside, 4).has_value());
}

TEST(OutwardPerPixel, MovesSquareCornersAlongTheirDiagonals) {
  const Quad square{Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 0), Eigen::Vector2d(10, 10),
                    Eigen::Vector2d(0, 10)};
  const Quad outward = outwardPerPixel(square);
  EXPECT_LT((outward[0] - Eigen::Vector2d(-1, -1)).norm(), 1e-12);
  EXPECT_LT((outward[2] - Eigen::Vector2d(1, 1)).norm(), 1e-12);
}

}  // namespace
}  // namespace ostraka::rig
