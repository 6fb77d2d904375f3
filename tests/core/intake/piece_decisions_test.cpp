#include "intake/piece_decisions.h"

#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

class PieceDecisions : public catalogue::SmallProject {
 protected:
  PieceDecisions() { batch = newBatch({bag4}); }
  PieceDecision join() {
    PieceDecision d;
    d.batch = batch;
    d.side = batch::Side::Back;
    d.pieces = {{"b003", {10.5, -20}}, {"b004", {30, -22.25}}};
    d.decision = "0190a0b0-0000-7000-8000-000000000001";
    return d;
  }
  store::BatchRow batch;
};

TEST_F(PieceDecisions, KeepWhoWhenWhereAndWhichPieces) {
  ASSERT_TRUE(decidePieces(catalogue(), join(), anna));
  PieceDecision cut = join();
  cut.side = batch::Side::Front;
  cut.verdict = PieceVerdict::Cut;
  cut.pieces.resize(1);
  cut.cut_mm = {Eigen::Vector2d(1.25, 2), Eigen::Vector2d(3, 4)};
  ASSERT_TRUE(decidePieces(catalogue(), cut, anna));
  const std::vector<PieceDecision> all = catalogue::valueIn(pieceDecisions(catalogue(), batch));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].by, anna.person);
  EXPECT_GT(all[0].at_ms, 1'790'000'000'000);
  EXPECT_EQ(all[0].side, batch::Side::Back);
  EXPECT_EQ(all[0].verdict, PieceVerdict::Join);
  ASSERT_EQ(all[0].pieces.size(), 2u);
  EXPECT_EQ(all[0].pieces[1].name, "b004");
  EXPECT_EQ(all[0].pieces[1].place_mm, Eigen::Vector2d(30, -22.25));
  EXPECT_EQ(all[1].verdict, PieceVerdict::Cut);
  EXPECT_EQ(all[1].cut_mm[0], Eigen::Vector2d(1.25, 2));
  EXPECT_EQ(all[1].cut_mm[1], Eigen::Vector2d(3, 4));
}

TEST_F(PieceDecisions, AreTakenBackByAnotherRowAndNeverRemoved) {
  const PieceDecisionRow row = *decidePieces(catalogue(), join(), anna);
  PieceDecision back = join();
  back.verdict = PieceVerdict::Withdraw;
  back.replaces = row;
  ASSERT_TRUE(decidePieces(catalogue(), back, anna));
  EXPECT_EQ(catalogue::valueIn(pieceDecisions(catalogue(), batch)).size(), 2u);
  EXPECT_THROW(catalogue().database().run("DELETE FROM piece_decision"), store::SqlFailure);
  EXPECT_THROW(catalogue().database().run("UPDATE piece_decision SET note = ''"),
               store::SqlFailure);
}

TEST_F(PieceDecisions, WithoutAPersonOrPiecesAreRefused) {
  EXPECT_FALSE(decidePieces(catalogue(), join(), {}));
  PieceDecision one = join();
  one.pieces.resize(1);
  EXPECT_FALSE(decidePieces(catalogue(), one, anna));
  PieceDecision stray = join();
  stray.verdict = PieceVerdict::Withdraw;
  stray.replaces = {77};
  EXPECT_FALSE(decidePieces(catalogue(), stray, anna));
  EXPECT_TRUE(catalogue::valueIn(pieceDecisions(catalogue(), batch)).empty());
}

}  // namespace
}  // namespace ostraka::intake
