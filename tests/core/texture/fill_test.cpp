#include "texture/fill.h"

#include <gtest/gtest.h>

namespace ostraka::texture {
namespace {

TEST(Fill, LeavesWhatIsKnownAndContinuesItEvenly) {
  cv::Mat3f page(37, 53, cv::Vec3f(0, 0, 0));
  cv::Mat1b known = cv::Mat1b::zeros(page.size());
  for (int y = 0; y < page.rows; ++y)
    for (int x = 0; x < page.cols; ++x)
      if (x < 10 || x > 40) {
        page(y, x) = x < 10 ? cv::Vec3f(100, 50, 20) : cv::Vec3f(200, 50, 20);
        known(y, x) = 255;
      }
  const cv::Mat3f all = filled(page, known);
  for (int y = 0; y < page.rows; ++y)
    for (int x = 0; x < page.cols; ++x) {
      if (known(y, x)) {
        EXPECT_EQ(all(y, x), page(y, x));
      }
      EXPECT_GE(all(y, x)[0], 99.9f);
      EXPECT_LE(all(y, x)[0], 200.1f);
      EXPECT_NEAR(all(y, x)[1], 50, 0.01);
    }
  EXPECT_LT(all(18, 13)[0], 140) << "nearer the left";
  EXPECT_GT(all(18, 37)[0], 160);
}

TEST(Fill, OfNothingKnownIsThePageItself) {
  const cv::Mat3f page(5, 4, cv::Vec3f(7, 8, 9));
  EXPECT_EQ(filled(page, cv::Mat1b::zeros(page.size()))(2, 2), page(2, 2));
}

}  // namespace
}  // namespace ostraka::texture
