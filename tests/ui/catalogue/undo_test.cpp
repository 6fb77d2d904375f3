// An edit in the catalogue is taken back, but nothing that others wrote.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>

#include "catalogue/history.h"
#include "catalogue_window.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
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
};

int main(int argc, char** argv) {
  prepareOpenGl();
  QApplication application(argc, argv);
  UndoTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "undo_test.moc"
