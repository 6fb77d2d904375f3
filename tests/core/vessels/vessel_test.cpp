#include "vessels/vessel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace ostraka::vessels {
namespace {

constexpr VesselForm kForms[] = {VesselForm::Bowl, VesselForm::Jar, VesselForm::Jug};
constexpr double kUneven_mm = 0.8;  // hands, the wheel and age together

Vessel vessel(VesselForm form, std::uint64_t seed = 3) {
  Random random(seed);
  return Vessel::make(form, 6, random);
}

TEST(Vessel, StandsOnItsBaseWithItsRimOnTop) {
  std::set<std::string> names;
  for (const VesselForm form : kForms) {
    const Vessel v = vessel(form);
    names.insert(name(v.form()));
    EXPECT_NEAR(v.radius(0), 0, 0.1) << "the base's middle lies on the axis";
    EXPECT_GT(v.heel(), 20);
    EXPECT_LT(v.heel(), v.length());
    const double top = v.outer(v.length(), 1).z();
    for (double s = 0; s < v.length(); s += 5) {
      EXPECT_LT(v.outer(s, 1).z(), top + kUneven_mm);
    }
    EXPECT_LT(v.outer(0.6 * v.heel(), 1).z(), 1.5) << "the base is flat";
  }
  EXPECT_EQ(names, (std::set<std::string>{"bowl", "jar", "jug"}));
}

TEST(Vessel, HasAWallOfItsThicknessEverywhere) {
  for (const VesselForm form : kForms) {
    const Vessel v = vessel(form);
    for (double s = 10; s < v.length(); s += 10)
      for (const double theta : {0.0, 2.0, 4.0}) {
        EXPECT_GE(v.thickness(s), 3);
        EXPECT_LE(v.thickness(s), 10);
        const double wall = (v.outer(s, theta) - v.inner(s, theta)).norm();
        EXPECT_LT(wall, v.thickness(s) + kUneven_mm) << name(form) << " at " << s;
        EXPECT_GT(wall, 0.6 * v.thickness(s)) << name(form) << " at " << s << ", a bend";
      }
  }
}

// The length of a sherd's sides is measured along s.
TEST(Vessel, CountsTheLengthOfItsProfile) {
  for (const VesselForm form : kForms) {
    const Vessel v = vessel(form);
    double way = 0;
    constexpr double kStep = 8;  // long against the unevenness, short against the curves
    const int steps = static_cast<int>(v.length() / kStep);
    for (int i = 0; i < steps; ++i)
      way += (v.outer((i + 1) * kStep, 1) - v.outer(i * kStep, 1)).norm();
    EXPECT_NEAR(way / (steps * kStep), 1, 0.03) << name(form);
  }
}

TEST(Vessel, IsRoundUpToWhatHandsLeave) {
  const Vessel v = vessel(VesselForm::Jar);
  for (double theta = 0; theta < 6.2; theta += 0.3) {
    const Eigen::Vector3d p = v.outer(100, theta);
    EXPECT_NEAR(std::hypot(p.x(), p.y()), v.radius(100), kUneven_mm);
    EXPECT_NEAR(std::remainder(std::atan2(p.y(), p.x()) - theta, 2 * M_PI), 0, 1e-9);
  }
}

TEST(Vessel, IsTheSameForTheSameSeedAlone) {
  const Vessel one = vessel(VesselForm::Jug), same = vessel(VesselForm::Jug),
               other = vessel(VesselForm::Jug, 4);
  EXPECT_EQ(one.outer(80, 2), same.outer(80, 2));
  EXPECT_EQ(one.inner(80, 2), same.inner(80, 2));
  EXPECT_NE(one.length(), other.length());
}

}  // namespace
}  // namespace ostraka::vessels
