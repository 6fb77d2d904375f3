// Which piece of a batch is which when it was computed again.
#include "intake/same_pieces.h"
#include "records/records.h"

#include <gtest/gtest.h>

namespace ostraka::intake {
namespace {

using batch::Side;

records::ScanRecord piece(const char* name, double x_mm, Side side = Side::Front) {
  records::ScanRecord scan;
  scan.side = side;
  scan.name = name;
  scan.plate_x_mm = x_mm;
  scan.plate_y_mm = 0;
  return scan;
}

decisions::PairDecision joinOf(const char* first, double x_mm, double other_x_mm) {
  decisions::PairDecision join;
  join.kind = decisions::DecisionKind::Join;
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
  records::ScanRecord nowhere = piece("f002", 0);
  nowhere.plate_x_mm = nowhere.plate_y_mm = std::nullopt;
  EXPECT_EQ(samePieces({nowhere}, {piece("f001", 0), piece("f002", 50)}, {}), std::vector<int>{1});
}

TEST(SamePieces, OneThatWasJoinedIsKnownByThePlacesOfItsParts) {
  const decisions::Decisions join = {joinOf("f001", 1, 31)};
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

// A mask that was mended in the same computation: a new piece comes first and has the old name.
TEST(SamePieces, AJoinedOneIsNoStrangerOfTheSameName) {
  const decisions::Decisions join = {joinOf("f001", 0, 30)};
  EXPECT_EQ(samePieces({piece("f001", 0), piece("f002", 30)},
                       {piece("f001", -80), piece("f002", 15)}, join),
            (std::vector<int>{1, -1}));
  EXPECT_EQ(samePieces({piece("f001", 0), piece("f002", 30)},
                       {piece("f001", -12), piece("f002", 15)}, join),
            (std::vector<int>{1, -1}));
  EXPECT_EQ(samePieces({piece("f001", 15)},
                       {piece("f001", -80), piece("f002", 0), piece("f003", 30)}, join),
            std::vector<int>{1});
}

TEST(SamePieces, OneThatWasJoinedTwiceLiesBetweenAllThree) {
  const decisions::Decisions joins = {joinOf("f001", 0, 30), joinOf("f001", 0, 90)};
  EXPECT_EQ(samePieces({piece("f001", 0), piece("f002", 30), piece("f003", 90)},
                       {piece("f001", 45)}, joins),
            (std::vector<int>{0, -1, -1}));
}

class CutPieces : public testing::Test {
 protected:
  static records::ScanRecord piece(const char* name, double x_mm, int points, int row = 0) {
    records::ScanRecord scan = intake::piece(name, x_mm);
    scan.points = points;
    scan.row = store::ScanRow{row};
    return scan;
  }
  CutPieces() {
    decisions::PairDecision cut;
    cut.kind = decisions::DecisionKind::Split;
    cut.scans = {{Side::Front, "f001", {40, 0}}};
    cut.cut_mm = {Eigen::Vector2d(50, -20), Eigen::Vector2d(50, 20)};  // the left is below 50
    edits = {cut};
  }
  decisions::Decisions edits;
  // Of 3000 points at 30 and 1000 at 70.
  const std::vector<records::ScanRecord> whole = {piece("f001", 40, 4000, 1)};
  const std::vector<records::ScanRecord> halves = {
      piece("f001", 12, 500, 3), piece("f002", 30, 3000, 1), piece("f003", 70, 1000, 2)};
};

TEST_F(CutPieces, GoOnAsTheLargerHalfWhateverTheyAreCalled) {
  EXPECT_EQ(samePieces(whole, halves, edits), std::vector<int>{1});
}

TEST_F(CutPieces, GoOnWhereTheNumberWasTyped) {
  EXPECT_EQ(samePieces(whole, halves, edits, {{store::ScanRow{1}, Eigen::Vector2d(68, 3)}}),
            std::vector<int>{2});
  EXPECT_EQ(samePieces(whole, halves, edits, {{store::ScanRow{7}, Eigen::Vector2d(68, 3)}}),
            std::vector<int>{1})
      << "that number is another's";
}

TEST_F(CutPieces, AreAgainWhatTheyWereWhenTheCutIsTakenBack) {
  EXPECT_EQ(samePieces(halves, whole, edits), (std::vector<int>{-1, 0, -1}));
  std::vector<records::ScanRecord> other_half = halves;
  std::swap(other_half[1].row, other_half[2].row);
  EXPECT_EQ(samePieces(other_half, whole, edits), (std::vector<int>{-1, -1, 0}))
      << "the half that was known first";
}

// A cut that was taken back, and a chip that lay beside the piece and is masked out now.
TEST_F(CutPieces, AreNoNeighboursThatCameOrWent) {
  const std::vector<records::ScanRecord> beside = {piece("f001", 40, 4000, 2),
                                                   piece("f002", 80, 150, 1)};
  EXPECT_EQ(samePieces(beside, whole, edits), (std::vector<int>{0, -1}));
  EXPECT_EQ(samePieces(whole, beside, edits, {{store::ScanRow{1}, Eigen::Vector2d(79, 0)}}),
            std::vector<int>{0});
}

// Two others balance around the place of the cut.
TEST_F(CutPieces, AreNoNeighboursWhoseMeanLiesThereByChance) {
  const std::vector<records::ScanRecord> others = {piece("f008", -20, 4000, 8),
                                                   piece("f009", 100, 4000, 9)};
  const auto with = [&](std::vector<records::ScanRecord> pieces) {
    pieces.insert(pieces.end(), others.begin(), others.end());
    return pieces;
  };
  EXPECT_EQ(samePieces(with(whole), with(halves), edits), (std::vector<int>{1, 3, 4}));
  EXPECT_EQ(samePieces(with(halves), with(whole), edits), (std::vector<int>{-1, 0, -1, 1, 2}));
  // Taken back before it was computed; one of the others is new.
  std::vector<records::ScanRecord> small = others;
  small[0].points = small[1].points = 2000;
  EXPECT_EQ(samePieces({whole[0], small[1]}, {whole[0], small[0], small[1]}, edits),
            (std::vector<int>{0, 2}));
}

TEST_F(CutPieces, AreKnownByTheirPlacesOnceTheyAreTwo) {
  EXPECT_EQ(samePieces(halves, halves, edits), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(samePieces(whole, whole, edits), std::vector<int>{0});
}

}  // namespace
}  // namespace ostraka::intake
