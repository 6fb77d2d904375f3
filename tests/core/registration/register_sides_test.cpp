#include "registration/register_sides.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "registration/contact.h"
#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;

Result<Registration> run(const scan::Scan& front, const scan::Scan& back,
                         const std::vector<Isometry3d>& starts, RegistrationOptions options = {},
                         bool on_plate = true, std::stop_token stop = {}) {
  const Result<Strip> front_strip = prepareStrip(front, options.strip);
  if (!front_strip) return front_strip.error();
  const Result<Strip> back_strip = prepareStrip(back, options.strip);
  if (!back_strip) return back_strip.error();
  QuietProgress quiet;
  Constraints constraints;
  if (on_plate) constraints.front_support = constraints.back_support = rig::SheetBend{};
  return registerSides(*front_strip, *back_strip, starts, constraints, options, quiet, stop);
}

// As scans are: they end a little above the plate that their sherd stands on.
SimulatedSherd raised(SimulatedSherd sherd, double mm) {
  const Eigen::Vector3f up(0, 0, static_cast<float>(mm));
  for (Eigen::Vector3f& p : sherd.front.cloud.points) p += up;
  for (Eigen::Vector3f& p : sherd.back.cloud.points) p += up;
  sherd.truth.pretranslate(Eigen::Vector3d(0, 0, 2 * mm));
  return sherd;
}

TEST(RegisterSides, FindsTheKnownPoseFromMillimetresOff) {
  const SimulatedSherd sherd = raised(simulatedSherd({}), ContactOptions{}.scanned_face_gap_mm);
  const auto found = run(sherd.front, sherd.back, {startOff(sherd, 1.5, 0.05)});
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(rms_mm(found->front_from_back, sherd.truth, sherd.back), 0.05);
  EXPECT_FALSE(found->check_failed) << found->reason;
  EXPECT_LT(found->uncertainty_mm, 0.1);
  EXPECT_NEAR(found->thickness_mm, 5.0, 0.12);
  EXPECT_GT(found->log_likelihood, 2.0);
}

// The paper's method says nothing of its pose but the distance of the points: the rest is measured.
TEST(RegisterSides, WhatTheBilateralBoundaryIcpFindsIsMeasuredAsOurs) {
  const SimulatedSherd sherd = raised(simulatedSherd({}), ContactOptions{}.scanned_face_gap_mm);
  RegistrationOptions options;
  options.method = Method::BilateralBoundary;
  options.height_step_mm = 0;
  const Isometry3d near = startOff(sherd, 0.5, 0.02), far = startOff(sherd, 1.5, 0.05);
  const auto found = run(sherd.front, sherd.back, {near}, options);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(rms_mm(found->front_from_back, sherd.truth, sherd.back), 0.3);
  const auto ours = run(sherd.front, sherd.back, {near});
  ASSERT_TRUE(ours.has_value());
  EXPECT_NEAR(found->fracture_overlap, ours->fracture_overlap, 0.15);
  EXPECT_NEAR(found->thickness_mm, ours->thickness_mm, 0.4);
  EXPECT_GT(found->uncertainty_mm, 0.5 * ours->uncertainty_mm);
  EXPECT_GE(found->fracture_rms_mm, ours->fracture_rms_mm);

  // From farther off it stays in a wrong place, and that is seen.
  options.height_step_mm = RegistrationOptions{}.height_step_mm;
  const auto astray = run(sherd.front, sherd.back, {far}, options);
  ASSERT_TRUE(astray.has_value()) << astray.error().what;
  EXPECT_GT(astray->uncertainty_mm, 0.4 * rms_mm(astray->front_from_back, sherd.truth, sherd.back));
  EXPECT_TRUE(astray->check_failed);
}

// Two per cent of a sherd's radius are 0.4 mm of its fracture.
TEST(RegisterSides, BilateralBoundaryIcpFindsThePairsOwnScaleAndIsMeasuredAtIt) {
  constexpr double kScale = 1.02;
  SimulatedSherd sherd = simulatedSherd({});
  for (Eigen::Vector3f& p : sherd.back.cloud.points) p /= static_cast<float>(kScale);
  RegistrationOptions options;
  options.method = Method::BilateralBoundary;
  options.height_step_mm = 0;
  const auto fixed = run(sherd.front, sherd.back, {sherd.truth}, options, false);
  options.free_scale = true;
  const auto found = run(sherd.front, sherd.back, {sherd.truth}, options, false);
  ASSERT_TRUE(fixed.has_value() && found.has_value());
  EXPECT_EQ(fixed->scale, 1.0);
  EXPECT_NEAR(found->scale, kScale, 0.004);
  EXPECT_LT(found->fracture_rms_mm, 0.7 * fixed->fracture_rms_mm);
  EXPECT_NEAR(found->thickness_mm, 5.0, 0.4);
  double squares = 0;
  for (const Eigen::Vector3f& p : sherd.back.cloud.points)
    squares += (found->front_from_back * (found->scale * p.cast<double>()) -
                sherd.truth * (kScale * p.cast<double>()))
                   .squaredNorm();
  EXPECT_LT(std::sqrt(squares / static_cast<double>(sherd.back.cloud.size())), 0.35);
}

class OtherPeoplesMethods : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(RegisterSides, OtherPeoplesMethods,
                         testing::Values(Method::TrimmedIcp, Method::GeneralizedIcp,
                                         Method::FeatureRansac, Method::FourPointSets,
                                         Method::KeypointFourPointSets, Method::FastGlobal,
                                         Method::SuperFourPointSets));

// A pose that is off by more than may pass (0.40 mm) fails the check.
TEST_P(OtherPeoplesMethods, AreMeasuredAsOursAndFlaggedWhereTheyAreOff) {
  const SimulatedSherd sherd = raised(simulatedSherd({}), ContactOptions{}.scanned_face_gap_mm);
  RegistrationOptions options;
  options.method = GetParam();
  const std::vector<Isometry3d> starts = {startOff(sherd, 200, 0), startOff(sherd, 0.5, 0.02)};
  const auto found = run(sherd.front, sherd.back, starts, options);
  if (!found) {  // a break with few corners: it says so
    EXPECT_EQ(GetParam(), Method::KeypointFourPointSets);
    EXPECT_EQ(found.error().code, ErrorCode::Failed);
    return;
  }
  EXPECT_EQ(found->start, 1) << "from there, or the one nearest to it";
  EXPECT_GT(found->fracture_overlap, 0.2);
  EXPECT_GT(found->fracture_rms_mm, 0.03) << "the scans' own noise";
  EXPECT_GT(found->uncertainty_mm, 0.01);
  EXPECT_NEAR(found->thickness_mm, 5.0, 2.0);
  const double off = rms_mm(found->front_from_back, sherd.truth, sherd.back);
  EXPECT_TRUE(found->check_failed || off < 0.4) << off << ", " << found->uncertainty_mm;
}

// Another break: each method lays something on something, and the check refuses it.
TEST_P(OtherPeoplesMethods, NeverPassAnotherBreak) {
  const SimulatedSherd sherd = simulatedSherd({}), other = simulatedSherd({.seed = 2, .shape = 1});
  RegistrationOptions options;
  options.method = GetParam();
  const auto found = run(sherd.front, other.back, {startOff(sherd, 0.5, 0.02)}, options);
  if (found) {
    EXPECT_TRUE(found->check_failed || found->log_likelihood < 0) << found->log_likelihood;
  } else {
    EXPECT_EQ(found.error().code, ErrorCode::Failed);
  }
}

TEST(RegisterSides, FindsTheKnownPoseInFramesWithoutPlate) {
  const SimulatedSherd sherd = simulatedSherd({.seed = 3});
  const auto found = run(sherd.front, sherd.back, {startOff(sherd, 1.0, 0.04)}, {}, false);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  EXPECT_LT(rms_mm(found->front_from_back, sherd.truth, sherd.back), 0.05);
}

TEST(RegisterSides, SwappingTheSidesInvertsThePose) {
  const SimulatedSherd sherd = simulatedSherd({.seed = 5});
  const Isometry3d start = startOff(sherd, 0.8, 0.03);
  const auto there = run(sherd.front, sherd.back, {start});
  const auto back = run(sherd.back, sherd.front, {start.inverse()});
  ASSERT_TRUE(there.has_value() && back.has_value());
  // Both end within the fit's own stop of 0.001 mm per round of one minimum; outlines are cut in
  // cells that lie otherwise.
  EXPECT_LT(rms_mm(there->front_from_back, back->front_from_back.inverse(), sherd.back), 0.03);
}

TEST(RegisterSides, AnyNumberOfThreadsGivesTheSameBits) {
  const SimulatedSherd sherd = simulatedSherd({});
  const std::vector<Isometry3d> starts = {startOff(sherd, 1, 0.03), startOff(sherd, -1.2, 0.02),
                                          startOff(sherd, 0.4, -0.05)};
  RegistrationOptions options;
  const auto one = run(sherd.front, sherd.back, starts, options);
  ASSERT_TRUE(one.has_value());
  for (const int threads : {3, 16}) {
    options.threads = threads;
    const auto many = run(sherd.front, sherd.back, starts, options);
    ASSERT_TRUE(many.has_value());
    EXPECT_TRUE(one->front_from_back.matrix() == many->front_from_back.matrix());
    EXPECT_EQ(one->log_likelihood, many->log_likelihood);
  }
}

TEST(RegisterSides, AnotherBreakOfTheSameOutlineFitsWorse) {
  const SimulatedSherd sherd = simulatedSherd({});
  const SimulatedSherd other = simulatedSherd({.seed = 2, .shape = 1});
  const auto right = run(sherd.front, sherd.back, {startOff(sherd, 0.5, 0.02)});
  const auto wrong = run(sherd.front, other.back, {startOff(sherd, 0.5, 0.02)});
  ASSERT_TRUE(right.has_value() && wrong.has_value());
  EXPECT_LT(right->fracture_rms_mm, 0.12);
  EXPECT_GT(wrong->fracture_rms_mm, 2 * right->fracture_rms_mm);
  EXPECT_GT(right->log_likelihood, wrong->log_likelihood + 4);  // 50 to 1
}

TEST(RegisterSides, TheUncertaintyIsOfTheSizeOfTheErrors) {
  double squares = 0, claimed = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const SimulatedSherd sherd = simulatedSherd({.seed = seed, .noise_mm = 0.06});
    const auto found = run(sherd.front, sherd.back, {startOff(sherd, 0.5, 0.02)});
    ASSERT_TRUE(found.has_value());
    const double error = rms_mm(found->front_from_back, sherd.truth, sherd.back);
    squares += error * error;
    claimed += found->uncertainty_mm * found->uncertainty_mm;
  }
  // Never a third of the truth; white noise is kinder than the correlated noise it reckons with.
  EXPECT_LT(squares, 9 * claimed);
}

// Where no fractures meet nothing but the start tells how the sides lie. Its uncertainty was stated
// as 30 m.
TEST(RegisterSides, SidesThatDoNotMeetAreNoMoreUncertainThanTheyAreLarge) {
  const SimulatedSherd sherd = simulatedSherd({});
  Isometry3d start = sherd.truth;
  start.pretranslate(Eigen::Vector3d(100, 0, 0));
  const auto found = run(sherd.front, sherd.back, {start}, {}, false);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_TRUE(found->check_failed);
  EXPECT_GT(found->uncertainty_mm, 1) << "a start's height";
  EXPECT_LT(found->uncertainty_mm, 45) << "the sherd's size";
}

TEST(RegisterSides, NoStartAndNoNormalsAreRefused) {
  SimulatedSherd sherd = simulatedSherd({});
  EXPECT_EQ(run(sherd.front, sherd.back, {}).error().code, ErrorCode::NotEnough);
  sherd.back.cloud.normals.clear();
  const auto found = run(sherd.front, sherd.back, {sherd.truth});
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::NotEnough);
  EXPECT_EQ(found.error().where, "b");
}

TEST(RegisterSides, StopsOnRequest) {
  const SimulatedSherd sherd = simulatedSherd({});
  std::stop_source stop;
  stop.request_stop();
  const auto found = run(sherd.front, sherd.back, {sherd.truth}, {}, false, stop.get_token());
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}

TEST(RegisterSides, ASmoothRoundSherdThatSlidIsCalledSlipped) {
  const SimulatedSherd sherd = simulatedSherd({.relief = 0});
  for (const double slid_mm : {1.0, 3.0, 8.0}) {
    Isometry3d start = sherd.truth;
    start.prerotate(Eigen::AngleAxisd(slid_mm / 20, Eigen::Vector3d::UnitZ()));
    const auto found = run(sherd.front, sherd.back, {start});
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->check_failed) << slid_mm << " mm: uncertain by " << found->uncertainty_mm
                                     << ", rival " << found->runner_up_gap << " below";
  }
}

}  // namespace
}  // namespace ostraka::registration
