#include "registration/break_misfit.h"

#include <gtest/gtest.h>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

BreakMisfit misfitOf(const SimulatedSherd& front, const SimulatedSherd& back,
                     const Eigen::Isometry3d& front_from_back) {
  return breakMisfit(*prepareStrip(front.front, {}), *prepareStrip(back.back, {}), front_from_back);
}

TEST(BreakMisfit, WhiteNoiseIsAveragedAwayAndLittleOfItIsAlike) {
  const SimulatedSherd sherd = simulatedSherd({.noise_mm = 0.1});
  const BreakMisfit misfit = misfitOf(sherd, sherd, sherd.truth);
  // 0.14 mm between two noisy points; a patch of 1.5 mm radius holds some forty.
  EXPECT_LT(misfit.rms_mm, 0.05);
  EXPECT_GT(misfit.rms_mm, 0.005);
  EXPECT_LT(misfit.alike, 6);
  EXPECT_GT(misfit.places, 30);  // 130 mm of fracture, 2.6 mm of it seen by both
}

TEST(BreakMisfit, AnotherBreakOfTheSameOutlineStandsOutOfTheSameNoise) {
  const SimulatedSherd sherd = simulatedSherd({.noise_mm = 0.1});
  const SimulatedSherd other = simulatedSherd({.seed = 2, .shape = 1, .noise_mm = 0.1});
  const BreakMisfit same = misfitOf(sherd, sherd, sherd.truth);
  const BreakMisfit wrong = misfitOf(sherd, other, sherd.truth);
  EXPECT_GT(wrong.rms_mm, 2.5 * same.rms_mm);
  EXPECT_GT(wrong.alike, 2 * same.alike);  // the relief differs over millimetres
}

TEST(BreakMisfit, SidesThatDoNotMeetHaveNone) {
  const SimulatedSherd sherd = simulatedSherd({});
  Eigen::Isometry3d far = sherd.truth;
  far.pretranslate(Eigen::Vector3d(0, 0, 100));
  const BreakMisfit misfit = misfitOf(sherd, sherd, far);
  EXPECT_EQ(misfit.rms_mm, 0);
  EXPECT_EQ(misfit.places, 0);
}

}  // namespace
}  // namespace ostraka::registration
