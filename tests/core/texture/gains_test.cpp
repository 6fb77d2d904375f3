#include "texture/gains.h"

#include <gtest/gtest.h>

#include <random>

namespace ostraka::texture {
namespace {

// Places of different colours in four photographs of different exposures; photographs 0 and 1 show
// the first 300 places, 2 and 3 the last 300, 1 and 2 a few of both.
std::vector<std::vector<Sample>> fourPhotographs(const std::vector<float>& exposures, int shared) {
  std::mt19937 chance(3);
  std::uniform_real_distribution<float> level(60, 120), noise(0.98f, 1.02f);
  std::vector<std::vector<Sample>> samples;
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector3f color(level(chance), level(chance), level(chance));
    std::vector<Sample> place(4);
    for (std::size_t v = 0; v < 4; ++v) {
      const bool is_shown =
          (i < 300) == (v < 2) || (std::abs(i - 300) < shared && (v == 1 || v == 2));
      if (is_shown) place[v] = {color * exposures[v] * noise(chance), 1};
    }
    samples.push_back(place);
  }
  return samples;
}

TEST(Gains, BringExposuresTogetherOverWhatIsShared) {
  const std::vector<float> exposures = {1.0f, 0.8f, 1.3f, 0.9f};
  const Eigen::MatrixX3d gains = gainsOf(fourPhotographs(exposures, 30));
  for (int channel = 0; channel < 3; ++channel)
    for (int v = 1; v < 4; ++v)
      EXPECT_NEAR(gains(v, channel) * exposures[static_cast<std::size_t>(v)],
                  gains(0, channel) * exposures[0], 0.02);
}

TEST(Gains, AreNotMisledByHighlights) {
  std::vector<std::vector<Sample>> samples = fourPhotographs({1, 1, 1, 1}, 30);
  for (std::size_t i = 0; i < 300; i += 8) samples[i][0].level *= 2;
  const Eigen::MatrixX3d gains = gainsOf(samples);
  EXPECT_NEAR(gains(0, 1) / gains(1, 1), 1, 0.02);
}

TEST(Gains, KeepTheLevelOfWhatSharesNothing) {
  const Eigen::MatrixX3d gains = gainsOf(fourPhotographs({1, 1, 1.5f, 1.5f}, 0));
  EXPECT_NEAR(gains(0, 0), gains(3, 0), 0.05);
  EXPECT_EQ(gainsOf({}).rows(), 0);
}

}  // namespace
}  // namespace ostraka::texture
