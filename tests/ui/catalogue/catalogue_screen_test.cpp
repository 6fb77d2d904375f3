#include "ui/catalogue/catalogue_screen.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QOpenGLWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "catalogue_window.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "store/database.h"
#include "tests/ui/program.h"
#include "ui/catalogue/drawing_page.h"
#include "ui/catalogue/model_pane.h"
#include "ui/look/look.h"
#include "ui/sherds/sherd_edits.h"
#include "ui/viewport/sherd_view.h"

using namespace ostraka;
using namespace ostraka::ui;

class CatalogueScreenTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void theFilterLineFindsAndItsChipsTakeAway() {
    QCOMPARE(child<QLabel>("count")->text(), QString("40 sherd(s)"));
    QTest::keyClick(screen_.get(), Qt::Key_F, Qt::ControlModifier);
    QTRY_VERIFY(child<QLineEdit>("filter")->hasFocus());
    filter("rim ware:grey");
    QCOMPARE(table()->model()->rowCount(), 7);  // every sixth of 40
    QCOMPARE(screen_->findChildren<QToolButton*>("chip").size(), 2);
    QTest::mouseClick(screen_->findChildren<QToolButton*>("chip").first(), Qt::LeftButton);
    QCOMPARE(child<QLineEdit>("filter")->text(), QString("ware:grey"));
    QCOMPARE(table()->model()->rowCount(), 20);
  }

  void aFilterThatIsNotUnderstoodIsNamedInPlace() {
    filter("rim");
    filter("colour:red");
    QTRY_VERIFY2(screen_->findChildren<QToolButton*>("chip").isEmpty(), "no part of this line");
    QVERIFY(child<QLabel>("problem")->isVisible());
    QVERIFY(child<QLabel>("problem")->text().contains("colour"));
    filter("grey");
    QVERIFY(!child<QLabel>("problem")->isVisible());
  }

  void whatCouldNotBeSavedStaysWithItsSherdUntilItIs() {
    choose(0);
    auto* ware = child<QLineEdit>("field_ware");
    const QString before = ware->text();
    auto& database = sample_->session().project().catalogue().database();
    database.run(
        "CREATE TEMP TRIGGER full BEFORE UPDATE ON sherd BEGIN SELECT RAISE(ABORT, 'full'); "
        "END");
    ware->setFocus();
    ware->selectAll();
    QTest::keyClicks(ware, "coarse");
    QTest::keyClick(ware, Qt::Key_Return);
    QCOMPARE(sample_->value(0, "ware"), before);
    choose(1);
    QVERIFY(ware->text() != QString("coarse"));
    choose(0);
    QCOMPARE(ware->text(), QString("coarse"));
    database.run("DROP TRIGGER full");
    ware->setFocus();
    QTest::keyClick(ware, Qt::Key_Return);
    QCOMPARE(sample_->value(0, "ware"), QString("coarse"));
    QVERIFY(!child<QWidget>("refusal")->isVisible());
    sample_->session().undo().undo();  // and it does not come back over what follows
    QCOMPARE(ware->text(), before);
    table()->setFocus();
    QCOMPARE(sample_->value(0, "ware"), before);
    sample_->session().undo().redo();
    choose(1);
    choose(0);
    QCOMPARE(ware->text(), QString("coarse"));
    QVERIFY(!child<QWidget>("refusal")->isVisible());
  }

  void termsAreShownAndTypedInTheWindowsLanguage() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::French));
    const auto back = qScopeGuard([&] { QLocale::setDefault(before); });
    sample_->session().tellVocabulariesChanged();
    choose(0);
    auto* part = child<QLineEdit>("field_part");
    QCOMPARE(part->text(), QString("bord"));
    QCOMPARE(table()->model()->index(0, 3).data().toString(), QString("bord"));
    part->setFocus();
    part->selectAll();
    QTest::keyClicks(part, "bord; col");
    QTest::keyClick(part, Qt::Key_Return);
    QCOMPARE(sample_->value(0, "part"), QString("rim; neck"));
    QCOMPARE(part->text(), QString("bord; col"));
    filter("col");
    QCOMPARE(table()->model()->rowCount(), 1);
  }

  void theHistoryTellsMeasuresAsPeopleReadThem() {
    choose(0);
    QStringList told;
    for (const QTreeWidget* tree : screen_->findChildren<QTreeWidget*>())
      if (tree->accessibleName() == QLatin1String("History"))
        for (int i = 0; i < tree->topLevelItemCount(); ++i) told << tree->topLevelItem(i)->text(2);
    const QStringList lengths = told.filter(QLatin1String("length, mm: "));
    QCOMPARE(lengths.size(), 1);
    QCOMPARE(lengths.front(), QString("length, mm: 40.0"));
  }

  void withoutAMouseTheArrowsChooseWhatGetsANumber() {
    screen_->setInFront(true);
    child<QTableView>("sherds")->clearSelection();
    child<QAction>("giveNumbers")->trigger();
    QVERIFY(child<QLabel>("problem")->text().startsWith("Choose the sherds"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
    QVERIFY(child<QTableView>("sherds")->selectionModel()->hasSelection());
  }

  void aBatchThatIsComputedTakesNothingOutOfThePersonsHands() {
    choose(3);
    auto* note = child<QLineEdit>("field_note");
    note->setFocus();
    QTest::keyClicks(note, "spout brok");
    sample_->addDraft();
    sample_->session().tellBatchChanged("B0001");
    QVERIFY(note->hasFocus());
    QTest::keyClicks(QApplication::focusWidget(), "en");
    QCOMPARE(note->text(), QString("spout broken"));
    QCOMPARE(sample_->session().undo().count(), 0);
    QCOMPARE(table()->model()->rowCount(), 41);
    table()->setFocus();
    QCOMPARE(sample_->value(6, "note"), QString("spout broken"));
    QCOMPARE(note->text(), QString("spout broken"));
    QCOMPARE(table()->selectionModel()->selectedRows().size(), 1);
    QCOMPARE(table()->currentIndex().data().toString(), QString("ARM1-T3-0012-0004"));

    sample_->addDraft();
    child<QLineEdit>("filter")->setFocus();
    QTest::keyClicks(child<QLineEdit>("filter"), "ri");
    sample_->session().tellBatchChanged("B0002");
    QCOMPARE(table()->model()->rowCount(), 42);
    QVERIFY(child<QLineEdit>("filter")->hasFocus());
    QCOMPARE(child<QLineEdit>("filter")->text(), QString("ri"));
    QCOMPARE(note->text(), QString("spout broken"));

    // What is marked is written over; nothing was typed yet.
    note->setFocus();
    note->selectAll();
    sample_->addDraft();
    sample_->session().tellBatchChanged("B0003");
    QCOMPARE(table()->model()->rowCount(), 43);
    QCOMPARE(note->selectedText(), QString("spout broken"));
  }

  void aBatchThatIsComputedKeepsWhatIsTypedForMany() {
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_A, Qt::ControlModifier);
    auto* value = child<QLineEdit>("bulkValue");
    value->setFocus();
    QTest::keyClicks(value, "nec");
    sample_->addDraft();
    sample_->session().tellBatchChanged("B0001");
    QCOMPARE(table()->model()->rowCount(), 41);
    QCOMPARE(table()->selectionModel()->selectedRows().size(), 40);
    QVERIFY(value->hasFocus());
    QTest::keyClicks(value, "k");
    QTRY_VERIFY(child<QLabel>("bulkSummary")->text().startsWith("To change: 40."));
    auto* field = child<QComboBox>("bulkField");
    field->setCurrentIndex(field->findData("weight_g"));
    value->selectAll();
    QTest::keyClicks(value, "1,250");
    QVERIFY(child<QLabel>("bulkSummary")->text().contains("can be read as 1250 or as 1.250"));
    QVERIFY(!child<QPushButton>("bulkApply")->isEnabled());
  }

  void aSherdMovesToAnotherContextInOneStep() {
    choose(0);
    auto* place = child<QComboBox>("field_place");
    QCOMPARE(place->currentText(), QString("ARM1 T3 0012"));
    place->setFocus();
    QTest::keyClick(place, Qt::Key_Down);
    QCOMPARE(sample_->value(0, "context"), QString("0013"));
    QCOMPARE(sample_->value(0, "number"), QString("ARM1-T3-0012-0001"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "context"), QString("0012"));
    QCOMPARE(place->currentText(), QString("ARM1 T3 0012"));
  }

  void aNumberThatIsTakenIsRefusedInPlace() {
    choose(1);
    auto* number = child<QLineEdit>("field_number");
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, "ARM1-T3-0012-0001");
    QTest::keyClick(number, Qt::Key_Return);
    auto* text = child<QLabel>("refusalText");
    QVERIFY(text->isVisible());
    QVERIFY(text->text().contains("belongs to another sherd"));
    QVERIFY(text->text().contains("It is ARM1-T3-0012-0001."));
    QCOMPARE(sample_->session().undo().count(), 0);
  }

  void aNumberThatReadsAsAnotherSherdsIsAskedAboutOnce() {
    choose(1);
    auto* number = child<QLineEdit>("field_number");
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, "ARM1/T3/12/1");
    QTest::keyClick(number, Qt::Key_Return);
    auto* text = child<QLabel>("refusalText");
    QVERIFY(text->isVisible());
    QVERIFY2(text->text().contains("differs from the existing number ARM1-T3-0012-0001"),
             qPrintable(text->text()));
    QCOMPARE(sample_->session().undo().count(), 0);
    QTest::mouseClick(child<QPushButton>("confirmChange"), Qt::LeftButton);
    QCOMPARE(sample_->session().undo().count(), 1);
    QCOMPARE(sample_->value(2, "number"), QString("ARM1/T3/12/1"));
  }

  void theModelOfTheSherdCanBeTurned() {
    sample_->giveModel(0);
    choose(0);
    auto* pane = child<ModelPane>("model");
    QTRY_VERIFY(pane->showsModel());
    auto* canvas = child<QOpenGLWidget>("canvas");
    QTRY_VERIFY(canvas->isVisible());
    const auto clay = [&] {
      const QImage shown = canvas->grabFramebuffer();
      int count = 0;
      for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) {
          const QColor pixel = shown.pixelColor(x, y);
          if (pixel.red() > pixel.blue() + 30) ++count;
        }
      return count;
    };
    QTRY_VERIFY(clay() > 1000);
    const QImage before = canvas->grabFramebuffer();
    const QPoint middle = canvas->rect().center();
    QTest::mousePress(canvas, Qt::LeftButton, {}, middle);
    QTest::mouseMove(canvas, middle + QPoint(60, 10));
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, middle + QPoint(60, 10));
    QTRY_VERIFY(canvas->grabFramebuffer() != before);
    QVERIFY2(screen_->isActiveWindow(), "the first 3D view takes no focus away");
    choose(1);
    QVERIFY2(!pane->showsModel(), "a sherd without a model shows its picture");
  }

  void manyAreChangedAtOnceAfterAPreview() {
    filter("rim");
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_A, Qt::ControlModifier);
    auto* value = child<QLineEdit>("bulkValue");
    QVERIFY(value->isVisible());
    QTest::keyClick(table(), Qt::Key_F2);
    QTRY_VERIFY(value->hasFocus());
    QVERIFY2(!child<QPushButton>("bulkApply")->isEnabled(), "nothing was typed yet");
    auto* field = child<QComboBox>("bulkField");
    field->setCurrentIndex(field->findData("condition"));
    QTest::keyClicks(value, "singed");
    QTRY_VERIFY(child<QLabel>("bulkSummary")->text().startsWith("To change: 0."));
    const QStringList why = child<QLabel>("bulkSummary")->text().split('\n');
    QCOMPARE(why.size(), 2);  // one reason for all of them, whole
    QVERIFY2(why[1].startsWith("'singed' is "), qPrintable(why[1]));
    QVERIFY(!child<QPushButton>("bulkApply")->isEnabled());
    value->selectAll();
    QTest::keyClicks(value, "burnt");
    QTRY_VERIFY(child<QLabel>("bulkSummary")->text().startsWith("To change: 14."));
    QTest::mouseClick(child<QPushButton>("bulkApply"), Qt::LeftButton);
    QCOMPARE(sample_->value(0, "condition"), QString("burnt"));
    QCOMPARE(sample_->value(39, "condition"), QString("burnt"));
    QCOMPARE(sample_->value(1, "condition"), QString());
    // A second click on the same place empties nothing.
    QTest::mouseClick(child<QPushButton>("bulkApply"), Qt::LeftButton);
    QVERIFY(!child<QPushButton>("bulkApply")->isEnabled());
    QVERIFY(!child<QLabel>("bulkSummary")->text().contains("To change:"));
    QCOMPARE(sample_->value(0, "condition"), QString("burnt"));
    QTest::keyClick(value, Qt::Key_Return);
    QTRY_VERIFY(child<QLabel>("bulkSummary")->text().startsWith("To change: 14."));
    QTest::mouseClick(child<QPushButton>("bulkApply"), Qt::LeftButton);
    QCOMPARE(sample_->value(0, "condition"), QString());
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "condition"), QString("burnt"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(39, "condition"), QString());
  }

  void manyThatNobodyStoppedAreChangedThoughTheProjectIsClosed() {
    std::vector<records::FieldChange> changes;
    for (const store::SherdRow sherd : sample_->sherds())
      for (const char* field : {"ware", "note", "fabric"})
        changes.push_back({sherd, field, "as typed"});
    const auto elsewhere = upkeep::Project::connect(sample_->session().folder());
    QVERIFY(elsewhere.has_value());
    elsewhere->database().run("BEGIN IMMEDIATE");
    auto edits = std::make_unique<SherdEdits>(sample_->session());
    QCOMPARE(edits->change("many", changes), QString());
    QVERIFY(edits->isBusy());
    QTest::qWait(300);  // it waits for the other one
    edits.reset();
    elsewhere->database().run("COMMIT");
    QTRY_COMPARE_WITH_TIMEOUT(sample_->value(39, "note"), QString("as typed"), 30000);
    QTest::qWait(300);  // nothing is taken back
    for (const int sherd : {0, 20, 39})
      QCOMPARE(sample_->value(sherd, "note"), QString("as typed"));
  }

  void veryManyAreChangedByAWorkerAndCanBeStopped() {
    SampleProject large(400);
    screen_->openProject(large.session());
    QVERIFY(400 > SherdEdits::kAtOnce);
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_A, Qt::ControlModifier);
    auto* field = child<QComboBox>("bulkField");
    field->setCurrentIndex(field->findData("ware"));
    auto* value = child<QLineEdit>("bulkValue");
    auto* apply = child<QPushButton>("bulkApply");
    QTest::keyClicks(value, "white");
    QTRY_VERIFY(child<QLabel>("bulkSummary")->text().startsWith("To change: 400."));
    // Another one writes meanwhile, so that it is stopped before it is done however fast it is.
    auto elsewhere = upkeep::Project::connect(large.session().folder());
    QVERIFY(elsewhere.has_value());
    elsewhere->database().run("BEGIN IMMEDIATE");
    QTest::mouseClick(apply, Qt::LeftButton);
    auto* stop = child<QPushButton>("bulkStop");
    QVERIFY(stop->isVisible());
    QVERIFY2(!apply->isVisible(), "one such act at a time");
    QTest::mouseClick(stop, Qt::LeftButton);
    elsewhere->database().run("COMMIT");
    QTRY_VERIFY(!stop->isVisible());
    QTRY_COMPARE(child<QLabel>("problem")->text(), QString("Cancelled. Nothing was changed."));
    for (const int sherd : {0, 200, 399}) QVERIFY(large.value(sherd, "ware") != "white");
    QCOMPARE(large.session().undo().count(), 0);
    large.session().lookForOthers();  // a worker writes as another does: the preview is made anew
    QTRY_VERIFY(apply->isEnabled());
    QTest::mouseClick(apply, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(large.session().undo().count(), 1, 30000);
    for (const int sherd : {0, 200, 399}) QCOMPARE(large.value(sherd, "ware"), QString("white"));
    QCOMPARE(table()->model()->index(0, 4).data().toString(), QString("white"));
    QVERIFY(table()->isEnabled());
    large.session().undo().undo();
    QTRY_COMPARE_WITH_TIMEOUT(large.value(0, "ware"), QString("grey"), 30000);
    QTRY_VERIFY_WITH_TIMEOUT(!stop->isVisible() && table()->isEnabled(), 30000);
    QCOMPARE(large.value(1, "ware"), QString("red slipped"));
    QCOMPARE(large.value(399, "ware"), QString("red slipped"));
    const records::FieldChange other{large.sherds()[399], "ware", "painted"};
    QVERIFY(sherds::SherdChanges(*elsewhere).apply(std::span(&other, 1), {}).has_value());
    large.session().undo().redo();
    QTRY_COMPARE_WITH_TIMEOUT(large.session().undo().count(), 0, 30000);
    QVERIFY(child<QLabel>("problem")->text().contains("ware was changed meanwhile"));
    QCOMPARE(large.value(0, "ware"), QString("grey"));
    QCOMPARE(large.value(399, "ware"), QString("painted"));
    screen_->closeProject();
  }

  void aDraftGetsTheNumberThatIsProposed() {
    sample_->addDraft();
    filter("state:draft");
    choose(0);
    auto* give = child<QPushButton>("giveNumber");
    QVERIFY(give->isVisible());
    QCOMPARE(give->text(), QString("Assign number ARM1-T3-0012-0021"));
    QTest::mouseClick(give, Qt::LeftButton);
    QCOMPARE(sample_->value(40, "number"), QString("ARM1-T3-0012-0021"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(40, "number"), QString());
  }

  void whoLacksAContextDoesNotKeepTheOthersFromTheirNumbers() {
    sample_->addDraft();
    sample_->addDraft(false);
    sample_->addDraft();
    filter("state:draft");
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_A, Qt::ControlModifier);
    QTest::mouseClick(child<QPushButton>("bulkNumbers"), Qt::LeftButton);
    QCOMPARE(sample_->value(40, "number"), QString("ARM1-T3-0012-0021"));
    QCOMPARE(sample_->value(41, "number"), QString());
    QCOMPARE(sample_->value(42, "number"), QString("ARM1-T3-0012-0022"));
    const QString said = child<QLabel>("problem")->text();
    QVERIFY2(said.startsWith("1 sherd") && said.contains("context"), qPrintable(said));
  }

  void aComputedLengthHasNoFifteenDigits() {
    for (int i = 0; i < 40; ++i)  // whichever is the first row
      SampleProject::must(
          sherds::SherdChanges(sample_->session().project().catalogue())
              .apply(std::vector<records::FieldChange>{{sample_->row(i), "length_mm",
                                                        "53.929898797564384"}},
                     {}));
    choose(0);
    auto* field = child<QLineEdit>("field_length_mm");
    QTRY_COMPARE(field->text(), QStringLiteral("53.9"));
    QTest::keyClick(field, Qt::Key_Return);  // nothing was typed
    QCOMPARE(sample_->value(0, "length_mm"), QStringLiteral("53.929898797564384"));
  }

  void anotherScreenCanShowASherd() {
    screen_->showItem("arm1-t3-0013-0007");
    QCOMPARE(table()->currentIndex().row(), 26);
    QSignalSpy wants(screen_.get(), &Screen::wantsScreen);
    filter("rim");
    QTest::mouseClick(child<QPushButton>("exportThese"), Qt::LeftButton);
    QCOMPARE(wants.count(), 1);
    QCOMPARE(wants.first().at(0).toString(), QString("export"));
    QCOMPARE(wants.first().at(1).toString(), QString("filter:rim"));
    choose(0);
    QCOMPARE(screen_->chosen(), QString("filter:rim"));  // one is only looked at
    QTest::keyClick(table(), Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(screen_->chosen().startsWith("rows:"));
    QVERIFY(child<QPushButton>("exportThese")->text().contains('2'));
  }

  void whoWorksIsAskedOnce() {
    auto* initials = child<QLineEdit>("initials");
    QVERIFY(!initials->isVisible());
    sample_->session().setInitials("");
    QVERIFY(initials->isVisible());
    QTest::keyClicks(initials, "BK");
    QTest::keyClick(initials, Qt::Key_Return);
    QCOMPARE(sample_->session().initials(), QString("BK"));
    QVERIFY2(initials->isVisible(), "the table below it does not move");
    screen_->setInFront(false);
    screen_->setInFront(true);
    QVERIFY(!initials->isVisible());
  }

  void anEmptyProjectSaysWhatToDoFirst() {
    SampleProject empty(0);
    screen_->openProject(empty.session());
    QVERIFY(screen_->findChild<QTableView*>("sherds")->isHidden());
    screen_->closeProject();
    QVERIFY(!screen_->isEnabled());
  }

  void everyControlHasAName() {
    choose(0);
    for (QWidget* widget : screen_->findChildren<QWidget*>()) {
      const bool control = qobject_cast<QLineEdit*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QAbstractButton*>(widget) ||
                           qobject_cast<QAbstractItemView*>(widget);
      const bool part =
          qobject_cast<QHeaderView*>(widget) || qobject_cast<QLineEdit*>(widget->parentWidget());
      if (!control || part || !widget->isVisible()) continue;
      const QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
      QVERIFY2(said && !said->text(QAccessible::Name).isEmpty(),
               qPrintable(widget->objectName() + widget->metaObject()->className()));
    }
  }

  void looksRightInEveryTheme() {
    const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Sunlight}) {
      applyLook(*qApp, theme, 100);
      QTRY_COMPARE(table()->palette().color(QPalette::Base), qApp->palette().color(QPalette::Base));
      filter("rim");
      sample_->giveModel(6);  // the second rim of the first context
      choose(0);
      choose(1);
      QTRY_VERIFY(child<ModelPane>("model")->showsModel());
      QTRY_VERIFY(table()
                      ->model()
                      ->index(1, 0)
                      .data(Qt::DecorationRole)
                      .value<QIcon>()
                      .availableSizes()
                      .contains(QSize(240, 240)));
      if (!folder.isEmpty())
        screen_->grab().save(folder + "/catalogue-" + themeName(theme) + ".png");
      table()->setFocus();
      QTest::keyClick(table(), Qt::Key_A, Qt::ControlModifier);
      auto* value = child<QLineEdit>("bulkValue");
      value->selectAll();
      QTest::keyClicks(value, "mould");
      QTRY_VERIFY(child<QLabel>("bulkSummary")->text().contains("To change:"));
      if (!folder.isEmpty())
        screen_->grab().save(folder + "/catalogue-many-" + themeName(theme) + ".png");
      QVERIFY(child<QLabel>("bulkSummary")->isVisible());
    }
  }
};

OSTRAKA_UI_TEST(CatalogueScreenTest)
#include "catalogue_screen_test.moc"
