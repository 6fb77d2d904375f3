#include "ground/ring_agreement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::ground {
namespace {

// A ring of markers about the middle of 101 x 101 cells, each the pixel of its own place; the log
// colours are a pattern all around.
class Ring : public testing::Test {
 protected:
  Ring() {
    look_.log_colours.create(101, 101);
    look_.pixel_of_cell.create(101, 101);
    for (int y = 0; y < 101; ++y)
      for (int x = 0; x < 101; ++x) {
        const double distance = std::hypot(x - 50, y - 50);
        if (distance > 35 && distance < 48) paper_(y, x) = 255;
        look_.pixel_of_cell(y, x) = {static_cast<float>(x), static_cast<float>(y)};
        look_.log_colours(y, x) = cv::Vec3f(0, patternAt(x, y), 0);
      }
  }
  static float patternAt(int x, int y) { return (x / 3 + y / 3) % 2 == 0 ? 5.F : 3.F; }
  static double turnOf(int x, int y) { return std::atan2(y - 50, x - 50); }
  PlateLook look_;
  cv::Mat1b paper_ = cv::Mat1b(101, 101, uchar{0});
};

TEST_F(Ring, OfTheSameStopAgreesWhateverTheLight) {
  cv::Mat3f empty(101, 101);
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x)  // brighter, and of half the contrast
      empty(y, x) = cv::Vec3f(9, 0.5F * patternAt(x, y) + 4, -9);
  const RingAgreement agreement = ringAgreement(empty, look_, paper_);
  EXPECT_NEAR(agreement.whole, 1, 1e-9);
  EXPECT_NEAR(agreement.typical, 1, 1e-9);
}

TEST_F(Ring, OfAnotherStopDoesNotAgree) {
  cv::Mat3f empty(101, 101);
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x) empty(y, x) = cv::Vec3f::all(8 - patternAt(x, y));
  EXPECT_NEAR(ringAgreement(empty, look_, paper_).whole, -1, 1e-9);
  EXPECT_NEAR(ringAgreement(empty, look_, paper_).typical, -1, 1e-9);
}

// A quarter of the ring is covered: four of its sixteen pieces.
TEST_F(Ring, UnderAClothIsToldByItsOtherPieces) {
  cv::Mat3f empty = look_.log_colours.clone();
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x)
      if (turnOf(x, y) > 0 && turnOf(x, y) < M_PI / 2)
        empty(y, x) = cv::Vec3f::all(static_cast<float>(7 * (x % 2)) + 8 - patternAt(x, y));
  const RingAgreement agreement = ringAgreement(empty, look_, paper_);
  EXPECT_LT(agreement.whole, 0.8);
  EXPECT_NEAR(agreement.typical, 1, 1e-6);
}

TEST_F(Ring, ThatNobodySeesAgreesWithNothing) {
  const cv::Mat3f flat(101, 101, cv::Vec3f::all(5));
  EXPECT_EQ(ringAgreement(flat, look_, paper_).whole, 0) << "no contrast";
  look_.pixel_of_cell.setTo(cv::Scalar::all(-1e4));
  const RingAgreement agreement = ringAgreement(look_.log_colours, look_, paper_);
  EXPECT_EQ(agreement.whole, 0);
  EXPECT_EQ(agreement.typical, 0);
}

}  // namespace
}  // namespace ostraka::ground
