// Which piece of a batch is which when it was computed again.
#include "catalogue/same_pieces.h"

#include <gtest/gtest.h>

namespace ostraka::catalogue {
namespace {

using batch::Side;

ScanRecord piece(const char* name, double x_mm, Side side = Side::Front) {
  ScanRecord scan;
  scan.side = side;
  scan.name = name;
  scan.plate_x_mm = x_mm;
  scan.plate_y_mm = 0;
  return scan;
}

pipeline::PairDecision joinOf(const char* first, double x_mm, double other_x_mm) {
  pipeline::PairDecision join;
  join.kind = pipeline::DecisionKind::Join;
  join.scans = {{Side::Front, first, {x_mm, 0}}, {Side::Front, "f009", {other_x_mm, 0}}};
  return join;
}

TEST(SamePieces, AreKnownByTheirPlacesTheNearestFirst) {
  EXPECT_EQ(
      samePieces({piece("f001", 0), piece("f002", 9)}, {piece("f001", 7), piece("f002", 1)}, {}),
      (std::vector<int>{1, 0}));
  EXPECT_EQ(samePieces({piece("f001", 0)}, {piece("f001", 10)}, {}), std::vector<int>{-1});
  EXPECT_EQ(samePieces({piece("f001", 0)}, {piece("b001", 0, Side::Back)}, {}),
            std::vector<int>{-1});
}

TEST(SamePieces, WithoutAPlaceAreKnownByTheirNames) {
  ScanRecord nowhere = piece("f002", 0);
  nowhere.plate_x_mm = nowhere.plate_y_mm = std::nullopt;
  EXPECT_EQ(samePieces({nowhere}, {piece("f001", 0), piece("f002", 50)}, {}), std::vector<int>{1});
}

TEST(SamePieces, OneThatWasJoinedOrCutKeepsItsNameWhereverItsMeanLiesNow) {
  const pipeline::Decisions join = {joinOf("f001", 1, 31)};
  EXPECT_EQ(samePieces({piece("f001", 0), piece("f002", 30)}, {piece("f001", 15)}, join),
            (std::vector<int>{0, -1}));
  // Taken back: the whole piece is known, and its first part is found where it lay.
  EXPECT_EQ(samePieces({piece("f001", 15)}, {piece("f001", 0), piece("f002", 30)}, join),
            std::vector<int>{0});
  // Its place is taken by another: that one is it, whatever the names are.
  EXPECT_EQ(samePieces({piece("f001", 0)}, {piece("f001", 15), piece("f002", 2)}, join),
            std::vector<int>{1});
  EXPECT_EQ(samePieces({piece("f003", 60)}, {piece("f003", 80)}, join), std::vector<int>{-1})
      << "the decision is about a piece elsewhere";
}

}  // namespace
}  // namespace ostraka::catalogue
