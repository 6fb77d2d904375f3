// A place that was typed wrongly gets its right name, or becomes one with the right place.
#include "ui/catalogue/places_dialog.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "catalogue_window.h"
#include "records/sherd.h"
#include "tests/ui/program.h"
#include "ui/catalogue/catalogue_screen.h"

using namespace ostraka;
using namespace ostraka::ui;

class PlacesDialogTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() {
    open();
    choose(0);
    child<QAction>("renamePlaces")->trigger();
    dialog_ = screen_->findChild<PlacesDialog*>();
    QVERIFY(dialog_ != nullptr && dialog_->isVisible());
  }
  void cleanup() { close(); }

  void aWrongNameIsPutRightAndUndone() {
    QCOMPARE(line()->text(), QString("0012"));  // of the sherd that is chosen
    QVERIFY(!act()->isEnabled());
    type("0112");
    QVERIFY2(told().contains("keep the number that is written on them"), qPrintable(told()));
    QCOMPARE(act()->text(), QString("Rename"));
    const QString number = sample_->value(0, "number");
    QTest::mouseClick(act(), Qt::LeftButton);
    QCOMPARE(sample_->value(0, "context"), QString("0112"));
    QCOMPARE(sample_->value(0, "number"), number);
    QCOMPARE(line()->text(), QString("0112"));
    QVERIFY(places().contains("context 0112"));
    QCOMPARE(sample_->session().undo().undoText(), QString("rename 0012 to 0112"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "context"), QString("0012"));
    QVERIFY(places().contains("context 0012"));
    sample_->session().undo().redo();
    QCOMPARE(sample_->value(0, "context"), QString("0112"));
  }

  void aNameThatExistsJoinsThePlacesOnceItIsSaid() {
    type("0013");
    QVERIFY2(told().startsWith("0013 exists already. Join with it?"), qPrintable(told()));
    QCOMPARE(act()->text(), QString("Join places"));
    QCOMPARE(sample_->value(0, "context"), QString("0012"));
    QTest::mouseClick(act(), Qt::LeftButton);
    QCOMPARE(sample_->value(0, "context"), QString("0013"));
    QVERIFY(!places().contains("context 0012"));
    QCOMPARE(line()->text(), QString("0013"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "context"), QString("0012"));
    QVERIFY(places().contains("context 0012"));
  }

  void whatCannotBeANameIsRefusedInPlace() {
    type("");
    QVERIFY(told().contains("must not be empty"));
    QVERIFY(!act()->isEnabled());
    type(QString(300, QLatin1Char('1')));
    QTest::mouseClick(act(), Qt::LeftButton);
    QVERIFY2(told().contains("at most 200"), qPrintable(told()));
    QCOMPARE(sample_->session().undo().count(), 0);
  }

 private:
  QLineEdit* line() { return dialog_->findChild<QLineEdit*>("placeName"); }
  QPushButton* act() { return dialog_->findChild<QPushButton*>("placeRename"); }
  QString told() { return dialog_->findChild<QLabel*>("placeTold")->text(); }
  void type(const QString& name) {
    line()->setFocus();
    line()->selectAll();
    if (name.isEmpty())
      QTest::keyClick(line(), Qt::Key_Delete);
    else
      QTest::keyClicks(line(), name);
  }
  QStringList places() {
    QStringList all;
    for (QTreeWidgetItemIterator at(dialog_->findChild<QTreeWidget*>("places")); *at != nullptr;
         ++at)
      all << (*at)->text(0);
    return all;
  }

  PlacesDialog* dialog_ = nullptr;
};

OSTRAKA_UI_TEST(PlacesDialogTest)
#include "places_dialog_test.moc"
