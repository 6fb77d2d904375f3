#include "evaluate/identify.h"

#include <gtest/gtest.h>

#include "box.h"
#include "evaluate/samples.h"

namespace ostraka::evaluate {
namespace {

TrueSherd sherdAt(double front_x, double back_x) {
  TrueSherd sherd;
  sherd.mesh = boxMesh(30, 20, 6, 4);
  sherd.plate_front_from_model = Eigen::Translation3d(front_x, 0, 0);
  sherd.plate_back_from_model = Eigen::Translation3d(back_x, 0, 0);
  return sherd;
}

NamedScan scanAt(const std::string& name, float x, double spacing_mm = 1.0) {
  NamedScan scan{name, {}};
  for (const Eigen::Vector3d& p : areaSamples(boxMesh(30, 20, 6), spacing_mm, 1).points)
    scan.cloud.points.push_back(p.cast<float>() + Eigen::Vector3f(x, 0, 0));
  return scan;
}

TEST(TruthOfScans, TellsScansApartByWhereTheyLie) {
  // On the back the two sherds have changed places.
  const PairsTruth truth =
      truthOfScans({scanAt("f1", 0), scanAt("f2", 50)}, {scanAt("b1", 0), scanAt("b2", 50)},
                   {sherdAt(0, 50), sherdAt(50, 0)}, 2);
  ASSERT_EQ(truth.pairs.size(), 2u);
  EXPECT_EQ(truth.pairs[0].front + truth.pairs[0].back, "f1b2");
  EXPECT_EQ(truth.pairs[1].front + truth.pairs[1].back, "f2b1");
  EXPECT_NEAR(truth.pairs[0].front_from_back.translation().x(), -50, 1e-12);
  EXPECT_EQ(truth.unseen_pairs, 0);
}

TEST(TruthOfScans, LeavesCrumbsAndPiecesAloneAndCountsWhatHasNoScan) {
  const PairsTruth truth =
      truthOfScans({scanAt("piece", 0.1f, 2.0), scanAt("whole", 0, 0.4), scanAt("crumb", 200)},
                   {scanAt("b1", 0)}, {sherdAt(0, 0), sherdAt(50, 50)}, 1);
  ASSERT_EQ(truth.pairs.size(), 1u);
  EXPECT_EQ(truth.pairs[0].front, "whole") << "the scan with the most points";
  EXPECT_EQ(truth.unpaired_front, (std::vector<std::string>{"piece", "crumb"}));
  EXPECT_EQ(truth.unseen_pairs, 1);
}

}  // namespace
}  // namespace ostraka::evaluate
