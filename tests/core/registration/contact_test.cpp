#include "registration/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Four feet at z = 1, 1, 1, 3 and a top.
Strip stool() {
  Strip strip;
  strip.shell = {{0, 0, 1}, {10, 0, 1}, {0, 10, 1}, {10, 10, 3}, {4, 4, 9}};
  strip.shell_normals.assign(5, Eigen::Vector3f(0, 0, -1));
  strip.shell_inside.assign(5, 1);
  strip.centre = Vector3d(4, 4, 4);
  return strip;
}

TEST(Contact, AStoolRestsOnTheThreeLowFeetUnderItsCentre) {
  const Contact contact = restingFacet(stool(), Isometry3d::Identity(), Vector3d(3, 3, 4), {});
  ASSERT_TRUE(contact.found);
  std::array<int, 3> feet = contact.points;
  std::sort(feet.begin(), feet.end());
  EXPECT_EQ(feet, (std::array<int, 3>{0, 1, 2}));
}

TEST(Contact, ACentreBeyondTheLowFeetTipsItOntoTheFourth) {
  const Contact contact = restingFacet(stool(), Isometry3d::Identity(), Vector3d(7, 7, 4), {});
  ASSERT_TRUE(contact.found);
  EXPECT_TRUE(std::count(contact.points.begin(), contact.points.end(), 3) == 1);
}

TEST(Contact, ACentreOutsideTheFeetRestsNowhere) {
  EXPECT_FALSE(restingFacet(stool(), Isometry3d::Identity(), Vector3d(30, 3, 4), {}).found);
}

TEST(Contact, ASteepSkirtBelowTheFeetCarriesNothing) {
  Strip strip = stool();
  strip.shell.push_back({5, 0, -1});
  strip.shell_normals.push_back(Eigen::Vector3f(0, -0.98f, -0.2f));
  strip.shell_inside.push_back(0);
  const Contact contact = restingFacet(strip, Isometry3d::Identity(), Vector3d(3, 3, 4), {});
  ASSERT_TRUE(contact.found);
  EXPECT_EQ(std::count(contact.points.begin(), contact.points.end(), 5), 0);
}

// Three feet 0.01 mm above where they belong, in the front's frame.
double heightSigma(bool on_face, double grain_mm) {
  Strip back = stool();
  if (!on_face) back.shell_inside.assign(5, 0);
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(Vector3d(0, 0, -0.99));
  ContactOptions options;
  options.grain_mm = grain_mm;
  const Vector3d pivot(10.0 / 3, 10.0 / 3, 0);  // between the feet: height and tilts part
  Strip front = stool();
  front.centre = Vector3d(3, 3, 4);
  const Evidence e = contactEvidence(front, back, pose, pivot, rig::SheetBend{}, {}, 0, options);
  return 1 / std::sqrt(e.information(5, 5));
}

TEST(Contact, KnowsTheHeightToWhatItsFeetShareAndWhatTheScanResolves) {
  // sigma^2 = plate^2 + own^2 / 3, own = 0.15 or 0.6 grains
  EXPECT_NEAR(heightSigma(true, 0.4), std::sqrt(0.06 * 0.06 + 0.06 * 0.06 / 3), 1e-6);
  EXPECT_NEAR(heightSigma(false, 0.4), std::sqrt(0.06 * 0.06 + 0.24 * 0.24 / 3), 1e-6);
  EXPECT_NEAR(heightSigma(false, 0.8), std::sqrt(0.06 * 0.06 + 0.48 * 0.48 / 3), 1e-6);
}

// 0.02 mm^-1 x^2 within 50 mm: 2 mm high at x = 10.
rig::SheetBend trough() {
  rig::SheetBend bend;
  bend.reach_mm = 50;
  bend.coefficients_mm[0] = 0.02 * 50 * 50;
  return bend;
}

TEST(Contact, OnABentSheetAStoolRestsWhereItsFeetMeetThePaper) {
  // The paper lies at 0, 0.5, 0.5 and 3.92 mm below four feet: all stand but the second, 0.3 mm
  // above it. On a plane all would stand but the first.
  Strip bent = stool();
  bent.shell = {{0, 0, 0}, {5, 0, 0.8F}, {-5, 10, 0.5F}, {14, 10, 3.92F}, {4, 4, 9}};
  const auto feet = [&](const rig::SheetBend& ground) {
    std::array<int, 3> points =
        restingFacet(bent, Isometry3d::Identity(), Vector3d(3, 5, 4), ground).points;
    std::sort(points.begin(), points.end());
    return points;
  };
  EXPECT_EQ(feet(trough()), (std::array<int, 3>{0, 2, 3}));
  EXPECT_EQ(feet({}), (std::array<int, 3>{1, 2, 3}));
}

TEST(Contact, ABentSheetGivesWayByAShareOfItsRise) {
  // Three feet 10 mm from the lowest line, where it rises by 2 mm: sigma^2 = plate^2 + own^2 / 3 +
  // rise^2 / 3
  Strip front, back = stool();
  back.shell = {{-10, 0, 2}, {-10, 10, 2}, {10, 5, 2}, {14, 5, 20}, {6, 5, 20}};
  front.centre = back.centre = Vector3d(0, 5, 10);
  ContactOptions options;
  options.grain_mm = 0.4;
  const auto height = [&](const rig::SheetBend& ground) {
    const Evidence e = contactEvidence(front, back, Isometry3d::Identity(),
                                       Vector3d(-10.0 / 3, 5, 2), ground, {}, 0, options);
    return std::pair(1 / std::sqrt(e.information(5, 5)), e.gradient[5] / e.information(5, 5));
  };
  const auto [flat_sigma, flat_height] = height({});
  EXPECT_NEAR(flat_sigma, std::sqrt(0.06 * 0.06 + 0.06 * 0.06 / 3), 1e-6);
  EXPECT_NEAR(flat_height, 2 - 0.03, 1e-6);
  const auto [bent_sigma, bent_height] = height(trough());
  EXPECT_NEAR(bent_sigma, std::sqrt(0.06 * 0.06 + 0.06 * 0.06 / 3 + 4.0 / 3), 1e-6);
  EXPECT_NEAR(bent_height, -0.03, 1e-6);
}

// On bent sheets. Weights follow its rise, and their own slope is left out: own
// errors beside which the rise is nothing leave the heights' slope alone.
enum class Bent { Neither, Fronts, Backs };
class ContactOn : public testing::TestWithParam<Bent> {};

TEST_P(ContactOn, TheGradientIsTheSlopeOfTheCost) {
  Strip front = stool(), back = stool();
  for (Strip* side : {&front, &back})  // upside down in the other's frame, their tops are below
    side->shell_normals.assign(5, Eigen::Vector3f(0, 0, 1));
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(Vector3d(1, 2, 6));
  pose.rotate(Eigen::AngleAxisd(3.0, Vector3d(1, 0.1, 0.05).normalized()));
  const Vector3d pivot(2, 3, 4);
  const ContactOptions options;
  const auto evidenceAt = [&](const Isometry3d& p) {
    const rig::SheetBend fronts = GetParam() == Bent::Fronts ? trough() : rig::SheetBend{};
    const rig::SheetBend backs = GetParam() == Bent::Backs ? trough() : rig::SheetBend{};
    const double widened = GetParam() == Bent::Neither ? 0 : 1e4;
    return contactEvidence(front, back, p, pivot, fronts, backs, widened, options);
  };
  const double unit = GetParam() == Bent::Neither ? 1 : 1e8;
  const auto cost = [&](const Isometry3d& p) { return unit * evidenceAt(p).cost; };
  const Evidence evidence = evidenceAt(pose);
  EXPECT_GT(unit * evidence.cost, 1);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const Vector6 x = kStep * Vector6::Unit(k);
    const double slope = (cost(changed(pose, x, pivot)) - cost(changed(pose, -x, pivot))) / 2e-6;
    EXPECT_NEAR(unit * evidence.gradient[k], slope, 1e-4 * (1 + std::abs(slope))) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Sheets, ContactOn,
                         testing::Values(Bent::Neither, Bent::Fronts, Bent::Backs));

}  // namespace
}  // namespace ostraka::registration
