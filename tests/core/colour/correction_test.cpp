#include "colour/correction.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <functional>

#include "rendered_chart.h"

namespace ostraka::colour {
namespace {

using Light = Patches<Eigen::Vector3d>;

Light changed(const std::function<void(std::size_t, Eigen::Vector3d&)>& change) {
  Light light = photographedPatches(camera());
  for (std::size_t i = 0; i < light.size(); ++i) change(i, light[i]);
  return light;
}

// Whether correctionBy takes the chart; where it does not it says so by its code.
bool isUsed(const Light& light) {
  const Result<Correction> found = correctionBy({light, 0});
  if (!found) {
    EXPECT_EQ(found.error().code, ErrorCode::NotEnough);
  }
  return found.has_value();
}

// Of a curve from 0 to 1 over sRGB's levels.
Eigen::Vector3d curved(const Eigen::Vector3d& light, double share) {
  return light.unaryExpr([&](double v) {
    const double e = std::pow(std::clamp(v, 0.0, 1.0), 1 / 2.2);
    return std::pow((1 - share) * e + share * e * e * (3 - 2 * e), 2.2);
  });
}

TEST(Correction, IsTheInverseOfWhatTheCameraDid) {
  const Correction found = fitted(photographedPatches(camera()));
  EXPECT_LT((found.matrix * camera() - Eigen::Matrix3d::Identity()).norm(), 1e-6);
  EXPECT_LT(found.within_95, 1e-3);
  // 0.62, 0.70 and 0.50 of white, and what they take of each other.
  const Color white = found.of(Color{223, 229, 208});
  for (const int level : white) EXPECT_NEAR(level, 255, 2);
  const cv::Mat3b picture(2, 3, cv::Vec3b(208, 229, 223));
  const cv::Mat3b corrected = found.of(picture);
  EXPECT_EQ(corrected(1, 2), cv::Vec3b(white[2], white[1], white[0]));
}

TEST(Correction, ByTheIdentityLeavesEachLevel) {
  for (int level = 0; level < 256; ++level) {
    const auto l = static_cast<std::uint8_t>(level);
    EXPECT_EQ(Correction().of(Color{l, l, l}), (Color{l, l, l}));
  }
}

TEST(Correction, IsNotLedAstrayByOnePatch) {
  for (std::size_t odd = 0; odd < 24; ++odd) {
    const Correction found = fitted(changed([&](std::size_t i, Eigen::Vector3d& v) {
      if (i == odd) v = Eigen::Vector3d(0.35, 0.35, 0.3);
    }));
    EXPECT_LT((found.matrix * camera() - Eigen::Matrix3d::Identity()).norm(), 0.05) << odd;
  }
}

TEST(ColourChart, IsUsedAsCamerasShowIt) {
  EXPECT_TRUE(isUsed(photographedPatches(camera())));
  EXPECT_TRUE(isUsed(changed([](std::size_t, Eigen::Vector3d& v) { v = curved(v, 0.4); })));
  EXPECT_TRUE(isUsed(changed([](std::size_t, Eigen::Vector3d& v) { v.array() += 0.03; })));
  EXPECT_TRUE(isUsed(changed([](std::size_t i, Eigen::Vector3d& v) {
    v *= 1 - 0.2 * static_cast<double>(i % 6) / 5;  // a window to the side
  })));
}

TEST(ColourChart, InAShadowOrGradientIsNotUsed) {
  for (const std::size_t columns : {1, 2, 3})
    EXPECT_FALSE(isUsed(changed([&](std::size_t i, Eigen::Vector3d& v) {
      if (i % 6 < columns) v *= 0.6;
    }))) << columns;
  EXPECT_FALSE(isUsed(changed(
      [](std::size_t i, Eigen::Vector3d& v) { v *= 1 - 0.5 * static_cast<double>(i % 6) / 5; })));
}

TEST(ColourChart, PartlyCoveredIsNotUsed) {
  for (const std::size_t covered : {2, 4, 8, 12}) {
    EXPECT_FALSE(isUsed(changed([&](std::size_t i, Eigen::Vector3d& v) {
      if (i < covered) v = Eigen::Vector3d(0.35, 0.35, 0.3);
    }))) << covered;
    EXPECT_FALSE(isUsed(changed([&](std::size_t i, Eigen::Vector3d& v) {
      if (i >= 24 - covered) v = Eigen::Vector3d(0.25, 0.15, 0.1);
    }))) << covered;
  }
}

TEST(ColourChart, ClippedOrWithoutColoursIsNotUsed) {
  const Result<Correction> clipped = correctionBy({photographedPatches(camera()), 1});
  ASSERT_FALSE(clipped.has_value());
  EXPECT_EQ(clipped.error().code, ErrorCode::NotEnough);
  EXPECT_FALSE(isUsed(changed([](std::size_t, Eigen::Vector3d& v) { v.setConstant(v.mean()); })));
}

}  // namespace
}  // namespace ostraka::colour
