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
  const Contact contact = restingFacet(stool(), Isometry3d::Identity(), Vector3d(3, 3, 4));
  ASSERT_TRUE(contact.found);
  std::array<int, 3> feet = contact.points;
  std::sort(feet.begin(), feet.end());
  EXPECT_EQ(feet, (std::array<int, 3>{0, 1, 2}));
}

TEST(Contact, ACentreBeyondTheLowFeetTipsItOntoTheFourth) {
  const Contact contact = restingFacet(stool(), Isometry3d::Identity(), Vector3d(7, 7, 4));
  ASSERT_TRUE(contact.found);
  EXPECT_TRUE(std::count(contact.points.begin(), contact.points.end(), 3) == 1);
}

TEST(Contact, ACentreOutsideTheFeetRestsNowhere) {
  EXPECT_FALSE(restingFacet(stool(), Isometry3d::Identity(), Vector3d(30, 3, 4)).found);
}

TEST(Contact, ASteepSkirtBelowTheFeetCarriesNothing) {
  Strip strip = stool();
  strip.shell.push_back({5, 0, -1});
  strip.shell_normals.push_back(Eigen::Vector3f(0, -0.98f, -0.2f));
  strip.shell_inside.push_back(0);
  const Contact contact = restingFacet(strip, Isometry3d::Identity(), Vector3d(3, 3, 4));
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
  const Evidence e = contactEvidence(front, back, pose, pivot, true, false, 0, options);
  return 1 / std::sqrt(e.information(5, 5));
}

TEST(Contact, KnowsTheHeightToWhatItsFeetShareAndWhatTheScanResolves) {
  // sigma^2 = plate^2 + own^2 / 3, own = 0.15 or 0.6 grains
  EXPECT_NEAR(heightSigma(true, 0.4), std::sqrt(0.06 * 0.06 + 0.06 * 0.06 / 3), 1e-6);
  EXPECT_NEAR(heightSigma(false, 0.4), std::sqrt(0.06 * 0.06 + 0.24 * 0.24 / 3), 1e-6);
  EXPECT_NEAR(heightSigma(false, 0.8), std::sqrt(0.06 * 0.06 + 0.48 * 0.48 / 3), 1e-6);
}

TEST(Contact, TheGradientIsTheSlopeOfTheCost) {
  Strip front = stool(), back = stool();
  for (Strip* side : {&front, &back})  // upside down in the other's frame, their tops are below
    side->shell_normals.assign(5, Eigen::Vector3f(0, 0, 1));
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(Vector3d(1, 2, 6));
  pose.rotate(Eigen::AngleAxisd(3.0, Vector3d(1, 0.1, 0.05).normalized()));
  const Vector3d pivot(2, 3, 4);
  const ContactOptions options;
  const auto cost = [&](const Isometry3d& p) {
    return contactEvidence(front, back, p, pivot, true, true, 0, options).cost;
  };
  const Evidence evidence = contactEvidence(front, back, pose, pivot, true, true, 0, options);
  EXPECT_GT(evidence.cost, 1);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const Vector6 x = kStep * Vector6::Unit(k);
    const double slope = (cost(changed(pose, x, pivot)) - cost(changed(pose, -x, pivot))) / 2e-6;
    EXPECT_NEAR(evidence.gradient[k], slope, 1e-4 * (1 + std::abs(slope))) << k;
  }
}

}  // namespace
}  // namespace ostraka::registration
