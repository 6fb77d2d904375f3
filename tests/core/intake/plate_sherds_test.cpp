// Whose front lies where, and which number a joined sherd keeps.
#include "intake/plate_sherds.h"

#include "catalogue/batches.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

using batch::Side;

class PlateSherdsTest : public catalogue::SmallProject {
 protected:
  PlateSherdsTest() {
    records::BatchRecord record;
    record.number = "B0001";
    batch = *catalogue::Batches(catalogue()).add(record, anna);
  }

  void lay(const char* name, double x_mm, int points, const char* number) {
    records::ScanRecord scan;
    scan.batch = batch;
    scan.index = name[3] - '0';
    scan.name = name;
    scan.path = std::string("results/B0001/scans/") + name + ".ply";
    scan.points = points;
    scan.plate_x_mm = x_mm;
    scan.plate_y_mm = 0;
    records::SherdRecord sherd;
    sherd.batch = batch;
    sherd.front = *catalogue::Batches(catalogue()).save(scan, anna);
    sherd.context = context12;
    sherd.number = number;
    ASSERT_TRUE(sherds::Sherds(catalogue()).add(sherd, anna).has_value());
  }

  JoinedNumbers joined(double first_x_mm, double second_x_mm, Side side = Side::Front) {
    decisions::PairDecision join;
    join.kind = decisions::DecisionKind::Join;
    join.scans = {{side, "f001", {first_x_mm, 0}}, {side, "f002", {second_x_mm, 0}}};
    return PlateSherds(catalogue(), "B0001").afterJoin(join);
  }

  store::BatchRow batch;
};

TEST_F(PlateSherdsTest, ASherdIsFoundWhereItsFrontLies) {
  lay("f001", -40, 100, "ARM1-T3-0012-0001");
  lay("f002", 0, 100, "");
  const PlateSherds sherds(catalogue(), "B0001");
  ASSERT_NE(sherds.at({-38, 1}), nullptr);
  EXPECT_EQ(sherds.at({-38, 1})->number, "ARM1-T3-0012-0001");
  EXPECT_EQ(sherds.at({2, 0})->number, "");
  EXPECT_EQ(sherds.at({40, 0}), nullptr);
  EXPECT_EQ(PlateSherds(catalogue(), "B0009").at({0, 0}), nullptr);
}

TEST_F(PlateSherdsTest, TheJoinedSherdKeepsTheNumberOfThePieceThatItLiesAt) {
  lay("f001", 0, 100, "ARM1-T3-0012-0001");
  lay("f002", 25, 900, "ARM1-T3-0012-0002");
  // Mean at 22.5 mm: 2.5 mm from the larger piece.
  const JoinedNumbers one = joined(0, 25);
  EXPECT_EQ(one.kept, "ARM1-T3-0012-0002");
  EXPECT_EQ(one.left, "ARM1-T3-0012-0001");
  const JoinedNumbers other = joined(25, 0);
  EXPECT_EQ(other.kept, "ARM1-T3-0012-0002");
  EXPECT_EQ(other.left, "ARM1-T3-0012-0001");
}

TEST_F(PlateSherdsTest, FarFromBothTheFirstNamedKeepsItsNumber) {
  lay("f001", 0, 500, "ARM1-T3-0012-0001");
  lay("f002", 40, 500, "ARM1-T3-0012-0002");
  EXPECT_EQ(joined(0, 40).kept, "ARM1-T3-0012-0001");
  EXPECT_EQ(joined(0, 40).left, "ARM1-T3-0012-0002");
}

TEST_F(PlateSherdsTest, ADraftAndBacksLeaveNoNumberBehind) {
  lay("f001", 0, 500, "ARM1-T3-0012-0001");
  lay("f002", 40, 500, "");
  EXPECT_EQ(joined(0, 40).kept, "ARM1-T3-0012-0001");
  EXPECT_EQ(joined(0, 40).left, "");
  EXPECT_EQ(joined(40, 0).left, "ARM1-T3-0012-0001") << "the draft's piece is named first";
  EXPECT_EQ(joined(40, 0).kept, "");
  EXPECT_EQ(joined(0, 40, Side::Back).kept, "");
  EXPECT_EQ(joined(0, 90).left, "") << "nothing lies there";
}

}  // namespace
}  // namespace ostraka::intake
