// Two sherds beside each other.
#include "ui/catalogue/compare_window.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "../names.h"
#include "catalogue_window.h"
#include "sherds/sherd_changes.h"
#include "tests/ui/program.h"
#include "ui/catalogue/model_pane.h"

using namespace ostraka;
using namespace ostraka::ui;

class CompareWindowTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void exactlyTwoAreCompared() {
    auto* compare = child<QAction>("compare");
    auto* button = child<QPushButton>("bulkCompare");
    QVERIFY(!compare->isEnabled());
    choose(0);
    QVERIFY(!compare->isEnabled());
    chooseAlso(1);
    QVERIFY(compare->isEnabled() && button->isVisible());
    chooseAlso(2);
    QVERIFY(!compare->isEnabled() && !button->isVisible());
    QTest::keyClick(table(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(screen_->findChild<CompareWindow*>() == nullptr);
  }

  // Row 1 is the sherd 2 of 0012: "body", grey, 42 mm; row 0 its first: "rim", grey, 40 mm.
  void whatDiffersIsMarkedInWords() {
    compareRows(1, 0);
    QCOMPARE(label("firstName"), QString("ARM1-T3-0012-0001"));  // the order of the table
    QCOMPARE(label("secondName"), QString("ARM1-T3-0012-0002"));
    QCOMPARE(rowOf("part"), QStringList({"rim", "body", "differs"}));
    QCOMPARE(rowOf("ware"), QStringList({"grey", "grey", ""}));
    QCOMPARE(rowOf("length, mm"), QStringList({"40.0", "42.0", "differs: +2.0"}));
    QVERIFY2(rowOf("number").isEmpty(), "each has its own");
    QVERIFY2(rowOf("firing").isEmpty(), "nobody entered it for either");
    QVERIFY(fields()->item(indexOf("part"), 1)->font().bold());
    QVERIFY(!fields()->item(indexOf("ware"), 1)->font().bold());
  }

  void itFollowsWhatIsChanged() {
    compareRows(0, 1);
    const QString before = label("compareSummary");
    const std::vector<records::FieldChange> changes = {{sample_->row(0), "firing", "oxidised"},
                                                       {sample_->row(2), "part", "rim"}};
    QVERIFY(sherds::SherdChanges(sample_->catalogue()).apply(changes, {}).has_value());
    sample_->session().tellSherdsChanged();
    QCOMPARE(rowOf("firing"), QStringList({"oxidised", "", "only one entered"}));
    QCOMPARE(rowOf("part"), QStringList({"rim", "rim", ""}));
    QVERIFY(label("compareSummary") != before);
  }

  void twoThatJoinAreSaidToJoin() {
    const records::FieldChange joins{sample_->row(0), "joins", "ARM1-T3-0012-0002"};
    QVERIFY(sherds::SherdChanges(sample_->catalogue()).apply(std::span(&joins, 1), {}).has_value());
    compareRows(0, 1);
    QVERIFY(label("compareSummary").endsWith("The two are recorded as joining."));
    QVERIFY(rowOf("joins with").isEmpty());
  }

  void withoutAModelThePictureStaysAndSaysWhy() {
    compareRows(0, 1);
    QTRY_COMPARE(label("firstWhy"),
                 QString("No model: the sherd belongs to no batch of photographs."));
    auto* pane = part<ModelPane>("firstModel");
    QVERIFY(!pane->showsModel());
    records::SherdRecord photographed;
    photographed.batch = {1};
    pane->clear();
    pane->showSherd(sample_->session().jobs(), {}, photographed);
    QTRY_VERIFY(pane->whyNoModel().startsWith("No model yet"));
  }

  void bothModelsAreTurnedByTheKeysAsOne() {
    sample_->giveModel(0);
    sample_->giveModel(2);
    compareRows(0, 1);
    auto* first = part<ModelPane>("firstModel");
    auto* second = part<ModelPane>("secondModel");
    QTRY_VERIFY(first->showsModel() && second->showsModel());
    QVERIFY(label("firstWhy").isEmpty());
    const auto pose = [](const ModelPane* pane) { return pane->modelView()->viewPose(); };
    QCOMPARE(pose(second).half_height_mm, pose(first).half_height_mm);
    first->setFocus();
    QTRY_VERIFY(first->hasFocus());
    QTest::keyClick(first, Qt::Key_Right);
    QVERIFY(pose(second).view_from_front.isApprox(pose(first).view_from_front, 1e-6));
    part<QCheckBox>("turnTogether")->click();
    QTest::keyClick(first, Qt::Key_Right);
    QVERIFY(!pose(second).view_from_front.isApprox(pose(first).view_from_front, 0.01));
    QTest::keyClick(first, Qt::Key_A);
    QVERIFY(pose(second).view_from_front.isApprox(pose(first).view_from_front, 1e-6));
    QTest::keyClick(first, Qt::Key_S);
    QVERIFY(first->modelView()->hasSection() && second->modelView()->hasSection());
    QTest::keyClick(first, Qt::Key_Tab);
    QTRY_VERIFY(second->hasFocus());
    QTest::keyClick(second, Qt::Key_Tab);
    QTRY_VERIFY(part<QCheckBox>("turnTogether")->hasFocus());
    QVERIFY2(namelessIn(*window()).isEmpty(), qPrintable(namelessIn(*window()).join('\n')));
  }

  void itFitsASmallScreenAndGoesWithTheProject() {
    compareRows(0, 1);
    QVERIFY2(
        window()->minimumSizeHint().height() <= 440 && window()->minimumSizeHint().width() <= 840,
        "1280x720 at 150 %, without the frame");
    screen_->closeProject();
    QVERIFY(screen_->findChild<CompareWindow*>() == nullptr);
  }

 private:
  void chooseAlso(int row) {
    QTest::mouseClick(table()->viewport(), Qt::LeftButton, Qt::ControlModifier,
                      table()->visualRect(table()->model()->index(row, 0)).center());
  }
  void compareRows(int first, int second) {
    choose(first);
    chooseAlso(second);
    QTest::keyClick(table(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(QTest::qWaitForWindowActive(window()));
  }
  CompareWindow* window() { return screen_->findChild<CompareWindow*>(); }
  template <class T>
  T* part(const char* name) {
    return named<T>(*window(), name);
  }
  QString label(const char* name) { return part<QLabel>(name)->text(); }
  QTableWidget* fields() { return part<QTableWidget>("comparedFields"); }
  int indexOf(const QString& field) {
    for (int row = 0; row < fields()->rowCount(); ++row)
      if (fields()->item(row, 0)->text() == field) return row;
    return -1;
  }
  QStringList rowOf(const QString& field) {
    const int row = indexOf(field);
    QStringList texts;
    for (int column = 1; row >= 0 && column < fields()->columnCount(); ++column)
      texts << fields()->item(row, column)->text();
    return texts;
  }
};

OSTRAKA_UI_TEST(CompareWindowTest)
#include "compare_window_test.moc"
