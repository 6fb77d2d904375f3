// A person's decisions in the catalogue: rows are only added, and what counts follows.
#include "ui/review/catalogue_entry.h"

#include <QTemporaryDir>
#include <QTest>

#include "catalogue/piece_decisions.h"
#include "catalogue/project.h"

namespace ostraka::ui {

using catalogue::Verdict;
using pipeline::DecisionKind;

class CatalogueEntryTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void aPairCountsAndItsWithdrawalTakesItBack();
  void initialsInOtherCapitalsAreTheSamePerson();
  void eachScanSetAsideHasARow();
  void joinsAndCutsAreKeptAndTakenBack();
  void aScanThatIsNotEnteredIsSaid();
  void theBatchIsQueuedAgain();
  void aBatchIsSettledUnlessItsScaleIsInDoubt();

 private:
  pipeline::PairDecision decision(DecisionKind kind, int number) {
    pipeline::PairDecision d;
    d.kind = kind;
    d.number = number;
    d.by = "AP";
    d.scans = {{batch::Side::Front, "f001", {0, 0}}, {batch::Side::Back, "b001", {0, 0}}};
    return d;
  }
  catalogue::Catalogue& rows() { return project_->catalogue(); }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<catalogue::Project> project_;
  catalogue::BatchRow batch_;
};

void CatalogueEntryTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  catalogue::ProjectRecord record;
  record.code = "ARM";
  record.title = "Trial";
  auto made = catalogue::Project::create(folder_->path().toStdString() + "/project", record);
  QVERIFY2(made.has_value(), made ? "" : made.error().sentence().c_str());
  project_ = std::make_unique<catalogue::Project>(std::move(*made));
  catalogue::BatchRecord batch;
  batch.number = "B0001";
  const auto row = rows().addBatch(batch, {});
  QVERIFY2(row.has_value(), row ? "" : row.error().sentence().c_str());
  batch_ = *row;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    catalogue::ScanRecord scan;
    scan.batch = batch_;
    scan.side = side;
    scan.index = 1;
    scan.name = side == batch::Side::Front ? "f001" : "b001";
    scan.path = "results/B0001/scans/" + scan.name + ".ply";
    const auto saved = rows().save(scan, {});
    QVERIFY2(saved.has_value(), saved ? "" : saved.error().sentence().c_str());
  }
}

void CatalogueEntryTest::aBatchIsSettledUnlessItsScaleIsInDoubt() {
  using catalogue::BatchState;
  QVERIFY(rows().setBatchState(batch_, BatchState::Review, {}).has_value());
  QVERIFY(settleBatch(rows(), "B0001", "AP", true).has_value());
  QCOMPARE(rows().batch(batch_)->state, BatchState::Done);
  QVERIFY(settleBatch(rows(), "B0001", "AP", false).has_value());
  QCOMPARE(rows().batch(batch_)->state, BatchState::Review);
  catalogue::BatchRecord doubtful = *rows().batch(batch_);
  doubtful.scale_doubts = "The scale is not right: 50 mm measure 49.5 mm.";
  QVERIFY(rows().saveBatch(doubtful, {}).has_value());
  QVERIFY(settleBatch(rows(), "B0001", "AP", true).has_value());
  QCOMPARE(rows().batch(batch_)->state, BatchState::Review);
}

void CatalogueEntryTest::aPairCountsAndItsWithdrawalTakesItBack() {
  const auto entered = enterDecision(rows(), "B0001", decision(DecisionKind::Pair, 1));
  QVERIFY2(entered.has_value(), entered ? "" : entered.error().sentence().c_str());
  QCOMPARE(rows().currentDecisions(batch_)->size(), std::size_t{1});
  QCOMPARE(rows().currentDecisions(batch_)->front().verdict, Verdict::Accept);
  QCOMPARE(rows().persons()->size(), std::size_t{1});
  pipeline::PairDecision back = decision(DecisionKind::Withdraw, 2);
  back.replaces = {1};
  QVERIFY(enterDecision(rows(), "B0001", back).has_value());
  QCOMPARE(rows().currentDecisions(batch_)->size(), std::size_t{0});
  QCOMPARE(rows().decisions(batch_)->size(), std::size_t{2});
  QCOMPARE(rows().persons()->size(), std::size_t{1});
}

void CatalogueEntryTest::initialsInOtherCapitalsAreTheSamePerson() {
  QVERIFY(enterDecision(rows(), "B0001", decision(DecisionKind::Pair, 1)).has_value());
  pipeline::PairDecision typed = decision(DecisionKind::Aside, 2);
  typed.by = "ap";
  const auto entered = enterDecision(rows(), "B0001", typed);
  QVERIFY2(entered.has_value(), entered ? "" : entered.error().sentence().c_str());
  QCOMPARE(rows().persons()->size(), std::size_t{1});
  const auto decisions = rows().decisions(batch_);
  for (const catalogue::PairDecision& row : *decisions)
    QCOMPARE(row.by, rows().persons()->front().row);
}

void CatalogueEntryTest::eachScanSetAsideHasARow() {
  QVERIFY(enterDecision(rows(), "B0001", decision(DecisionKind::Aside, 1)).has_value());
  QCOMPARE(rows().decisions(batch_)->size(), std::size_t{2});
}

void CatalogueEntryTest::joinsAndCutsAreKeptAndTakenBack() {
  pipeline::PairDecision join = decision(DecisionKind::Join, 2);
  join.scans[0] = {batch::Side::Back, "b002", {5, 6}};
  QVERIFY(enterDecision(rows(), "B0001", join).has_value());
  pipeline::PairDecision back = join;
  back.kind = DecisionKind::Withdraw;
  back.number = 3;
  back.replaces = {2};
  QVERIFY(enterDecision(rows(), "B0001", back).has_value());
  const auto kept = catalogue::pieceDecisions(rows(), batch_);
  QCOMPARE(kept->size(), std::size_t{2});
  QCOMPARE(kept->at(0).side, batch::Side::Back);
  QCOMPARE(kept->at(0).pieces.at(0).name, std::string("b002"));
  QCOMPARE(kept->at(1).verdict, catalogue::PieceVerdict::Withdraw);
  QCOMPARE(kept->at(1).replaces, kept->at(0).row);
  QCOMPARE(rows().decisions(batch_)->size(), std::size_t{0});
}

void CatalogueEntryTest::aScanThatIsNotEnteredIsSaid() {
  pipeline::PairDecision d = decision(DecisionKind::Pair, 1);
  d.scans[1].id = "b009";
  const auto refused = enterDecision(rows(), "B0001", d);
  QVERIFY(!refused.has_value());
  QVERIFY(refused.error().sentence().find("b009") != std::string::npos);
  QVERIFY(!enterDecision(rows(), "B0077", d).has_value());
}

void CatalogueEntryTest::theBatchIsQueuedAgain() {
  QVERIFY(queueAgain(rows(), "B0001", "AP").has_value());
  QCOMPARE(rows().batch(batch_)->state, catalogue::BatchState::Queued);
}

}  // namespace ostraka::ui

QTEST_GUILESS_MAIN(ostraka::ui::CatalogueEntryTest)
#include "catalogue_entry_test.moc"
