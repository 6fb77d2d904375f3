// An edit in the catalogue is taken back, but nothing that others wrote.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue_window.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "tests/ui/program.h"
#include "ui/catalogue/catalogue_screen.h"

using namespace ostraka;
using namespace ostraka::ui;

class UndoTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void anEditIsSavedAtOnceAndCanBeUndone() {
    choose(0);
    QTest::keyClick(table(), Qt::Key_F2);
    auto* part = child<QLineEdit>("field_part");
    QTRY_VERIFY(part->hasFocus());
    QTest::keyClicks(part, "rim; neck");
    QTest::keyClick(part, Qt::Key_Return);
    QCOMPARE(sample_->value(0, "part"), QString("rim; neck"));
    QCOMPARE(table()->model()->index(0, 3).data().toString(), QString("rim; neck"));
    QCOMPARE(sample_->session().undo().undoText(), QString("change part"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "part"), QString("rim"));
    QCOMPARE(part->text(), QString("rim"));
    sample_->session().undo().redo();
    QCOMPARE(sample_->value(0, "part"), QString("rim; neck"));
    const auto history = catalogue::History(sample_->catalogue()).of(sample_->sherds()[0]);
    QCOMPARE(history->front().field, std::string("part"));
    QVERIFY(static_cast<bool>(history->front().by));
  }

  void undoLeavesWhatSomebodyElseWroteMeanwhile() {
    choose(0);
    auto* ware = child<QLineEdit>("field_ware");
    ware->setFocus();
    ware->selectAll();
    QTest::keyClicks(ware, "coarse");
    QTest::keyClick(ware, Qt::Key_Return);
    auto elsewhere = upkeep::Project::connect(sample_->session().folder());
    QVERIFY(elsewhere.has_value());
    const records::FieldChange other{sample_->sherds()[0], "ware", "painted"};
    QVERIFY(sherds::SherdChanges(*elsewhere).apply(std::span(&other, 1), {}).has_value());
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "ware"), QString("painted"));
    const QString told = child<QLabel>("problem")->text();
    QVERIFY2(child<QLabel>("problem")->isVisible() && told.contains("ARM1-T3-0012-0001") &&
                 told.contains("ware was changed meanwhile"),
             qPrintable(told));
    QCOMPARE(sample_->session().undo().count(), 0);
    sample_->session().lookForOthers();
    QCOMPARE(ware->text(), QString("painted"));
    QCOMPARE(table()->model()->index(0, 4).data().toString(), QString("painted"));
    QVERIFY(child<QLabel>("problem")->isVisible());
  }

  void whoMovesASherdIsToldWhatItLeavesBehind() {
    putIntoBag4({0});
    choose(0);
    auto* place = child<QComboBox>("field_place");
    place->setFocus();
    QTest::keyClick(place, Qt::Key_Down);
    QCOMPARE(sample_->value(0, "context"), QString("0013"));
    QCOMPARE(sample_->value(0, "bag"), QString());
    const QString told = child<QLabel>("problem")->text();
    QVERIFY2(child<QLabel>("problem")->isVisible() &&
                 told.contains("because there is no bag 4 in 0013 yet.") &&
                 told.contains("a number of the old context: ARM1-T3-0012-0001."),
             qPrintable(told));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "context"), QString("0012"));
    QCOMPARE(sample_->value(0, "bag"), QString("4"));
  }

  void manyAreMovedByTheSameRule() {
    putIntoBag4({0, 2});
    filter("bag:4");
    QCOMPARE(table()->model()->rowCount(), 2);
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_A, Qt::ControlModifier);
    auto* field = child<QComboBox>("bulkField");
    field->setCurrentIndex(field->findData("context"));
    QTest::keyClicks(child<QLineEdit>("bulkValue"), "0013");
    auto* summary = child<QLabel>("bulkSummary");
    QTRY_VERIFY(summary->text().startsWith("To change: 2. Unchanged: 0. Rejected: 0."));
    QVERIFY2(summary->text().contains("leave their bag, because there is no bag 4 in 0013 yet."),
             qPrintable(summary->text()));
    auto* make = child<QPushButton>("bulkMakeBags");
    QVERIFY(make->isVisible());
    QTest::mouseClick(make, Qt::LeftButton);
    QTRY_VERIFY(summary->text().startsWith("To change: 2.") && !summary->text().contains("leave"));
    QVERIFY(make->isHidden());
    QTest::mouseClick(child<QPushButton>("bulkApply"), Qt::LeftButton);
    for (const int sherd : {0, 2}) {
      QCOMPARE(sample_->value(sherd, "context"), QString("0013"));
      QCOMPARE(sample_->value(sherd, "bag"), QString("4"));
    }
    QVERIFY(child<QLabel>("problem")->text().contains("ARM1-T3-0012-0001, ARM1-T3-0012-0002"));
    QCOMPARE(sample_->session().undo().count(), 1);
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(2, "bag"), QString("4"));
  }

 private:
  void putIntoBag4(const std::vector<int>& sherds) {
    records::BagRecord bag;
    bag.context = SampleProject::must(
        catalogue::Places(sample_->catalogue()).contextByPlace("ARM1", "T3", "0012"));
    bag.number = "4";
    SampleProject::must(catalogue::Places(sample_->catalogue()).save(bag, {}));
    for (const int sherd : sherds) {
      const records::FieldChange into{sample_->row(sherd), "bag", "4"};
      SampleProject::must(
          sherds::SherdChanges(sample_->catalogue()).apply(std::span(&into, 1), {}));
    }
  }
};

OSTRAKA_UI_TEST(UndoTest)
#include "undo_test.moc"
