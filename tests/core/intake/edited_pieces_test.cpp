#include "intake/edited_pieces.h"

#include <gmock/gmock.h>

namespace ostraka::intake {
namespace {

using batch::Side;
using testing::ElementsAre;
using testing::IsEmpty;

records::ScanRecord lying(int row, double x_mm, int points, Side side = Side::Front) {
  records::ScanRecord scan;
  scan.row = store::ScanRow{row};
  scan.side = side;
  scan.index = row;
  scan.points = points;
  scan.plate_x_mm = x_mm;
  scan.plate_y_mm = 0;
  return scan;
}

decisions::PairDecision joined(double x_mm, double other_x_mm, Side side = Side::Front) {
  decisions::PairDecision join;
  join.kind = decisions::DecisionKind::Join;
  join.scans = {{side, "f001", {x_mm, 0}}, {side, "f002", {other_x_mm, 0}}};
  return join;
}

// A piece at 40 mm, cut where x is 50 mm: the left, as one looks along the line, is below that.
decisions::PairDecision cutAtFifty() {
  decisions::PairDecision cut;
  cut.kind = decisions::DecisionKind::Split;
  cut.scans = {{Side::Front, "f001", {40, 0}}};
  cut.cut_mm = {Eigen::Vector2d(50, -20), Eigen::Vector2d(50, 20)};
  return cut;
}

TEST(EditedPieces, HaveAPlaceWhereBothOfItsNumbersAreKnown) {
  records::ScanRecord scan = lying(1, 12, 100);
  EXPECT_EQ(placeOf(scan), Eigen::Vector2d(12, 0));
  scan.plate_y_mm.reset();
  EXPECT_FALSE(placeOf(scan));
}

TEST(EditedPieces, OfJoinsThatShareAPieceLieAtAllPlaces) {
  const decisions::PairDecision join = joined(0, 30);
  // 31 mm is the piece at 30 mm; the last two have nothing to do with it.
  const decisions::Decisions edits = {joined(61, 90), joined(31, 60), join, joined(200, 230),
                                      joined(0, 120, Side::Back)};
  EXPECT_THAT(joinedPlaces(join, edits),
              ElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(30, 0), Eigen::Vector2d(60, 0),
                          Eigen::Vector2d(90, 0)));
  EXPECT_EQ(joinedPlaces(join, {cutAtFifty()}).size(), 2u) << "a cut joins nothing";
}

TEST(EditedPieces, ThatWereJoinedLieWithinACentimetreOfTheirPartsHull) {
  const std::vector<Eigen::Vector2d> two = {{0, 0}, {30, 0}}, three = {{0, 0}, {60, 0}, {0, 60}};
  for (const Eigen::Vector2d& in : {Eigen::Vector2d(15, 0), {15, 9}, {-9, 0}, {39, 0}})
    EXPECT_TRUE(liesBetween(in, two)) << in.transpose();
  for (const Eigen::Vector2d& off : {Eigen::Vector2d(15, 11), {-11, 0}, {41, 0}})
    EXPECT_FALSE(liesBetween(off, two)) << off.transpose();
  EXPECT_TRUE(liesBetween({20, 20}, three));
  EXPECT_TRUE(
      liesBetween({37, 37}, three));  // 74 - 60 over the root of 2: 9.9 mm off the hypotenuse
  EXPECT_FALSE(liesBetween({38, 38}, three));
}

TEST(EditedPieces, OfACutAreTheTwoWithItsMeanOnEitherSideOfIt) {
  using Halves = std::pair<std::size_t, std::size_t>;
  // (3000 * 30 + 1000 * 70) / 4000 = 40.
  EXPECT_EQ(halvesOf(cutAtFifty(), {lying(1, 30, 3000), lying(2, 70, 1000)}), Halves(0, 1));
  EXPECT_EQ(halvesOf(cutAtFifty(), {lying(1, 70, 1000), lying(2, 30, 3000)}), Halves(1, 0))
      << "the left one first";
  EXPECT_FALSE(halvesOf(cutAtFifty(), {lying(1, 30, 1000), lying(2, 70, 3000)}))
      << "their mean lies at 60";
  EXPECT_FALSE(halvesOf(cutAtFifty(), {lying(1, 30, 3000), lying(2, 45, 1000)}))
      << "both on the left";
  EXPECT_FALSE(halvesOf(cutAtFifty(), {lying(1, 30, 3000), lying(2, 70, 1000, Side::Back)}));
  records::ScanRecord gone = lying(2, 70, 1000);
  gone.index = -1;
  EXPECT_FALSE(halvesOf(cutAtFifty(), {lying(1, 30, 3000), gone}));
  // Of two pairs with that mean, the one that lies nearer together.
  EXPECT_EQ(halvesOf(cutAtFifty(), {lying(1, 10, 2000), lying(2, 30, 3000), lying(3, 70, 1000),
                                    lying(4, 70, 2000)}),
            Halves(1, 2));
}

// Two others balance around the place of the cut by chance, but what was cut lies there whole.
TEST(EditedPieces, OfACutThatIsWholeAreNoNeighboursUnlessACrumbIsLeftThere) {
  const auto between = [](int points) {
    return halvesOf(cutAtFifty(), {lying(1, -20, 4000), lying(2, 100, 4000), lying(3, 41, points)});
  };
  EXPECT_FALSE(between(4000));
  EXPECT_FALSE(between(800));
  EXPECT_TRUE(between(799)) << "less than a tenth of both";
}

TEST(EditedPieces, AreMadeByTheirEditOnceItWasComputed) {
  using Rows = std::vector<store::ScanRow>;
  EXPECT_EQ(madeBy(cutAtFifty(), {}, {lying(7, 70, 1000), lying(8, 30, 3000)}),
            (Rows{store::ScanRow{8}, store::ScanRow{7}}));
  EXPECT_THAT(madeBy(cutAtFifty(), {}, {lying(7, 40, 4000)}), IsEmpty());
  const decisions::PairDecision join = joined(0, 30);
  EXPECT_EQ(madeBy(join, {join}, {lying(3, 20, 100), lying(4, 15, 5000), lying(5, 90, 9000)}),
            Rows{store::ScanRow{4}})
      << "the largest between its parts";
  EXPECT_THAT(madeBy(join, {join}, {lying(3, 1, 2000), lying(4, 29, 3000)}), IsEmpty())
      << "its parts are two still";
  EXPECT_THAT(madeBy(join, {join}, {lying(4, 15, 5000, Side::Back)}), IsEmpty());
}

}  // namespace
}  // namespace ostraka::intake
