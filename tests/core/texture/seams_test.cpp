#include "texture/seams.h"

#include <gtest/gtest.h>

#include <cmath>

#include "block.h"
#include "seam_step.h"

namespace ostraka::texture {
namespace {

// Two charts whose sides meet, the second one brighter by a fifth, and a third one alone.
class Seams : public testing::Test {
 protected:
  Seams() {
    for (const cv::Rect& chart : {one, other, alone})
      for (int y = chart.y; y < chart.br().y; ++y)
        for (int x = chart.x; x < chart.br().x; ++x) {
          faces(y, x) = 1;
          const double gain = chart == other ? 1.2 : 1;
          const double wave = 8 * std::sin(0.9 * x) * std::sin(0.7 * y);
          page(y, x) = cv::Vec3f(cv::Vec3d(90 + wave, 110 + wave, 140 + wave) * gain);
        }
    seen = faces >= 0;
  }
  cv::Mat3b levelled(int threads = 1) const {
    cv::Mat3f to = page.clone();
    levelSeams(to, faces, seen, seams, threads);
    cv::Mat3b shown;
    to.convertTo(shown, CV_8U);
    return shown;
  }
  cv::Mat3b asItIs() const {
    cv::Mat3b shown;
    page.convertTo(shown, CV_8U);
    return shown;
  }
  const cv::Rect one{10, 10, 40, 50}, other{70, 10, 40, 50}, alone{10, 80, 60, 30};
  cv::Mat3f page = cv::Mat3f(120, 120, cv::Vec3f(100, 100, 100));
  cv::Mat1i faces = cv::Mat1i(120, 120, -1);
  cv::Mat1b seen;
  const std::vector<Seam> seams = {
      {{Eigen::Vector2d(48.7, 12), {48.7, 57}}, {Eigen::Vector2d(70.4, 12), {70.4, 57}}}};
};

TEST_F(Seams, ShowTheSameOnBothSides) {
  EXPECT_GT(stepAcross(asItIs(), seen, seams), 5);
  EXPECT_LT(stepAcross(levelled(), seen, seams), 0.5);
}

TEST_F(Seams, AreMetByBothSidesHalfway) {
  const auto meanAt = [&](const cv::Mat3b& shown, int x) {
    return cv::mean(shown(cv::Rect(x, 20, 1, 30)))[1];
  };
  const double before = meanAt(asItIs(), 49), beyond = meanAt(asItIs(), 70);
  EXPECT_NEAR(meanAt(levelled(), 49), (before + beyond) / 2, 2);
  EXPECT_NEAR(meanAt(levelled(), 70), (before + beyond) / 2, 2);
}

TEST_F(Seams, ChangeNothingFarFromThemNorInOtherCharts) {
  cv::Mat3b off;
  cv::absdiff(levelled(), asItIs(), off);
  EXPECT_EQ(cv::norm(off(alone), cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(off(cv::Rect(10, 10, 20, 50)), cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(off(cv::Rect(40, 20, 5, 30)), cv::NORM_INF), 2) << "the correction fades";
}

TEST_F(Seams, AreNotLevelledToWhatIsFilledIn) {
  seen(other) = 0;
  EXPECT_EQ(cv::norm(levelled(), asItIs(), cv::NORM_INF), 0);
}

TEST_F(Seams, DoNotDependOnThreads) {
  EXPECT_EQ(cv::norm(levelled(1), levelled(3), cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(levelled(1), levelled(16), cv::NORM_INF), 0);
}

TEST(SeamsOfAMesh, LieBetweenItsCharts) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const std::vector<Chart> charts = chartsOf(tile, 0.2);
  const Atlas atlas = packed(charts, 0.2);
  const std::vector<Seam> seams = seamsOf(tile, charts, atlas);
  double length = 0;
  for (const Seam& seam : seams) {
    EXPECT_GT((seam.one[0] - seam.other[0]).norm(), 1) << "charts lie apart";
    // The strip that is laid flat is drawn out a little.
    const double one = (seam.one[1] - seam.one[0]).norm(),
                 other = (seam.other[1] - seam.other[0]).norm();
    EXPECT_NEAR(one, other, 0.2 * one) << "the same edge";
    length += (seam.one[1] - seam.one[0]).norm() * atlas.texel_mm;
  }
  EXPECT_GT(length, 2 * 140) << "both faces are bordered by their outline";
}

}  // namespace
}  // namespace ostraka::texture
