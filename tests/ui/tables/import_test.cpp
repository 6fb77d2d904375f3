// A table is looked at, and entered whole or not at all; in a real window.
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <optional>

#include "../named.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "exchange/export_folder.h"
#include "files/folder_lock.h"
#include "records/sherd.h"
#include "sample_project.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/look/look.h"
#include "ui/tables/import_dialog.h"

using namespace ostraka;
using namespace ostraka::ui;

class ImportTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<SampleProject> sample_;
  std::unique_ptr<CatalogueScreen> screen_;
  ImportModel* model_ = nullptr;

  template <class T>
  T* child(const char* name) {
    return named<T>(*screen_, name);
  }
  QString table(const QByteArray& text) {
    const QString path = sample_->folder() + "/table.csv";
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("no table");
    return path;
  }
  QString sherds() {
    return table(
        "number,site,trench,context,ware,part\r\n"
        "ARM1-T3-0012-0001,ARM1,T3,0012,black,rim\r\n"         // changed
        "ARM1-T3-0013-0001,ARM1,T3,0013,red slipped,body\r\n"  // as it is
        "ARM1-T3-0012-0900,ARM1,T3,0012,grey,base\r\n"         // new
        "ARM1-T3-0012-0002,ARM1,T3,0012,grey,rimm\r\n"         // no such part
        "ARM1-T9-0001-0001,ARM1,T9,0001,grey,body\r\n");       // no such trench
  }
  void open() {
    QTest::mouseClick(child<QPushButton>("import"), Qt::LeftButton);
    QVERIFY(QTest::qWaitForWindowActive(child<ImportDialog>("importDialog")));
    model_ = screen_->findChild<ImportModel*>();
  }
  QString summary() { return child<QLabel>("importSummary")->text(); }

 private slots:
  void init() {
    sample_ = std::make_unique<SampleProject>(10);
    screen_ = std::make_unique<CatalogueScreen>();
    screen_->resize(1280, 720);
    screen_->openProject(sample_->session());
    activate(*screen_);
  }
  void cleanup() {
    screen_.reset();
    sample_.reset();
  }

  void eachRowSaysWhatItWouldDoAndNothingIsTakenYet() {
    open();
    QVERIFY(!child<QPushButton>("importEnter")->isEnabled());
    model_->setSource(sherds());
    QTRY_COMPARE(summary(), QString("1 new, 1 updated, 1 unchanged, 2 rejected."));
    auto* rows = child<QTableWidget>("importRows");
    QCOMPARE(rows->rowCount(), 5);
    QCOMPARE(rows->item(0, 0)->text(), QString("5"));  // the refused first
    QCOMPARE(rows->item(0, 1)->text(), QString("rejected"));
    QVERIFY(rows->item(0, 2)->text().contains("rimm"));
    QVERIFY2(rows->columnWidth(2) > rows->columnWidth(0), "the reason can be read");
    const QAbstractItemView* view = rows;
    QVERIFY2(rows->rowHeight(0) >= view->sizeHintForRow(0), "to its end");
    QVERIFY(rows->item(1, 2)->text().contains("0001"));
    QCOMPARE(rows->item(2, 1)->text(), QString("updated"));
    QCOMPARE(rows->item(2, 3)->text(), QString("ARM1-T3-0012-0001"));
    QCOMPARE(rows->item(2, 7)->text(), QString("grey → black"));
    QVERIFY2(!rows->item(2, 7)->icon().isNull(), "colour and arrow do not speak alone");
    QVERIFY(rows->item(2, 3)->icon().isNull());
    QCOMPARE(child<QPushButton>("importEnter")->text(), QString("Import 2 row(s)"));
    QCOMPARE(sample_->value(0, "ware"), QString("grey"));
    QTest::mouseClick(child<QPushButton>("importCancel"), Qt::LeftButton);
    QCOMPARE(sample_->value(0, "ware"), QString("grey"));
    QVERIFY(!*sherds::Sherds(sample_->catalogue()).byNumber("ARM1-T3-0012-0900"));
  }

  // As a dig's old table has them: two names of one field, a unit to be guessed, a slip of the pen.
  void columnsOfAForeignTableAreMappedByHandAndOnlyDoubtfulRowsAskForATick() {
    open();
    model_->setSource(
        table("Nr;Gewicht;thickness;weight;Fabric code\n"
              "ARM1-T3-0012-0001;21,5;4,2;22;F1\n"
              "ARM1-T3-0012-0002;20;45;20;F2\n"
              "ARM1-T3-0012-0900;7;5;7;F2\n"));
    QTRY_COMPARE(summary(), QString("0 new, 1 updated, 0 unchanged, 1 rejected. "
                                    "1 row(s) ask for a confirmation."));
    auto* field = child<QComboBox>("columnField1");
    QCOMPARE(field->currentData().toString(), QString("weight_g"));
    QCOMPARE(child<QComboBox>("columnField2")->currentData().toString(),
             QString("thickness_mean_mm"));
    QCOMPARE(child<QComboBox>("columnField3")->currentData().toString(), QString("extra.weight"));
    QVERIFY2(child<QLabel>("importProblem")
                 ->text()
                 .contains("The column 'weight' means the same as 'Gewicht'"),
             qPrintable(child<QLabel>("importProblem")->text()));
    auto* rows = child<QTableWidget>("importRows");
    for (int row = 0; row < rows->rowCount(); ++row) {
      const bool asks = rows->item(row, 1)->text() == "to confirm";
      QCOMPARE(rows->item(row, 1)->data(Qt::CheckStateRole).isValid(), asks);
    }
    // The other column is the weight after all.
    auto* other = child<QComboBox>("columnField3");
    other->setCurrentIndex(other->findData(QString("weight_g")));
    emit other->activated(other->currentIndex());
    QTRY_COMPARE(model_->state(), ImportModel::State::Ready);  // the boxes are made anew
    QCOMPARE(child<QComboBox>("columnField1")->currentData().toString(), QString("extra.Gewicht"));
    QCOMPARE(child<QPushButton>("importEnter")->text(), QString("Import 1 row(s)"));
    QTest::mouseClick(child<QPushButton>("importConfirm"), Qt::LeftButton);
    QCOMPARE(child<QPushButton>("importEnter")->text(), QString("Import 2 row(s)"));
    QTest::mouseClick(child<QPushButton>("importEnter"), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(sample_->value(0, "weight_g"), QString("22"));
    QCOMPARE(sample_->value(0, "thickness_mean_mm"), QString("4.2"));
    QCOMPARE(sample_->value(2, "thickness_mean_mm"), QString("45"));
    for (int row = 0; row < rows->rowCount(); ++row)
      QVERIFY(rows->item(row, 1)->text() != "to confirm");
    // The same columns once more are as they were left.
    model_->setSource(
        table("Nr;Gewicht;thickness;weight;Fabric code\n"
              "ARM1-T3-0012-0001;9;4,2;23;F1\n"));
    QTRY_COMPARE(model_->state(), ImportModel::State::Ready);
    QCOMPARE(child<QComboBox>("columnField3")->currentData().toString(), QString("weight_g"));
  }

  void aRowThatAsksAsksUntilItIsConfirmed() {
    open();
    model_->setSource(
        table("Nr;Gewicht;thickness;weight;Fabric code\n"
              "ARM1-T3-0012-0001;21,5;4,2;22;F1\n"
              "ARM1-T3-0012-0002;20;45;20;F2\n"
              "ARM1-T3-0012-0900;7;5;7;F2\n"));
    QTRY_COMPARE(summary(), QString("0 new, 1 updated, 0 unchanged, 1 rejected. "
                                    "1 row(s) ask for a confirmation."));
    QTest::mouseClick(child<QPushButton>("importEnter"), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(model_->report()->asked, 1);
    QCOMPARE(child<QTableWidget>("importRows")->item(1, 1)->text(), QString("to confirm"));
    QVERIFY(child<QPushButton>("importConfirm")->isVisible());
    QVERIFY(!child<QPushButton>("importEnter")->isVisible());
    QTest::mouseClick(child<QPushButton>("importConfirm"), Qt::LeftButton);
    QCOMPARE(child<QPushButton>("importEnter")->text(), QString("Import 1 row(s)"));
    QTest::mouseClick(child<QPushButton>("importEnter"), Qt::LeftButton);
    QTRY_COMPARE(sample_->value(2, "thickness_mean_mm"), QString("45"));
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(child<QTableWidget>("importRows")->item(1, 1)->text(), QString("updated"));
    QVERIFY(!child<QPushButton>("importConfirm")->isVisible());
  }

  void enterOpensWhatHasTheFocus() {
    open();
    auto* choose = child<QPushButton>("importTable");
    QVERIFY2(choose->autoDefault(), "Enter on it did nothing");
  }

  void whatIsEnteredIsShownAndChangesCanBeUndone() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(child<QPushButton>("importEnter")->isEnabled());
    const QSignalSpy said(screen_.get(), &Screen::said);
    QTest::mouseClick(child<QPushButton>("importEnter"), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(sample_->value(0, "ware"), QString("black"));
    QVERIFY(*sherds::Sherds(sample_->catalogue()).byNumber("ARM1-T3-0012-0900"));
    QCOMPARE(child<QLabel>("count")->text(), QString("11 sherd(s)"));
    QCOMPARE(said.count(), 1);
    QVERIFY(child<QLabel>("importProblem")->text().contains("not take back new sherds"));
    const auto history = catalogue::History(sample_->catalogue()).of(sample_->sherds()[0]);
    QCOMPARE(history->front().source, std::string("import"));
    QVERIFY(static_cast<bool>(history->front().by));
    QCOMPARE(sample_->session().undo().undoText(), QString("changes by the import of table.csv"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "ware"), QString("grey"));
    sample_->session().undo().redo();
    QCOMPARE(sample_->value(0, "ware"), QString("black"));
  }

  void placesAreMadeWhenThePersonSaysSo() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(summary().endsWith("2 rejected."));
    auto* places = child<QCheckBox>("importPlaces");
    QTest::mouseClick(places, Qt::LeftButton, {}, QPoint(8, places->height() / 2));
    QTRY_VERIFY(summary().endsWith("1 rejected."));
    QTest::mouseClick(child<QPushButton>("importEnter"), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QVERIFY(*catalogue::Places(sample_->catalogue()).contextByPlace("ARM1", "T9", "0001"));
  }

  void whoStopsIsToldThatNothingWasEnteredInTheSameWindow() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(model_->canEnter());
    const auto stopped = sample_->catalogue().together([this]() -> Result<void> {
      model_->enter();  // it waits until nobody else writes
      child<QPushButton>("importCancel")->click();
      return {};
    });
    QVERIFY(stopped.has_value());
    QTRY_COMPARE(model_->state(), ImportModel::State::Ready);
    QVERIFY(child<ImportDialog>("importDialog")->isVisible());
    QVERIFY(child<QLabel>("importProblem")->text().startsWith("Cancelled. Nothing was imported."));
    QCOMPARE(sample_->value(0, "ware"), QString("grey"));
    QCOMPARE(sample_->session().undo().count(), 0);
  }

  void oneThatIsStoppedMidwaySaysHowFarItCame() {
    open();
    QByteArray rows = "number,site,trench,context\r\n";
    for (int i = 0; i < 3; ++i)
      rows += "ARM1-T3-0012-" + QByteArray::number(1000 + i) + ",ARM1,T3,0012\r\n";
    model_->setSource(table(rows));
    QTRY_VERIFY(model_->canEnter());
    JobHandle* job = nullptr;
    const auto begun = sample_->catalogue().together([&]() -> Result<void> {
      model_->enter();  // it waits until nobody else writes
      job = model_->findChildren<JobHandle*>().last();
      job->pause();
      return {};
    });
    QVERIFY(begun.has_value());
    QSignalSpy stood(job, &JobHandle::stoodStill);
    QTRY_COMPARE(stood.count(), 1);                // before the first row
    child<ImportDialog>("importDialog")->close();  // by Esc, or its cross
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(model_->report()->not_reached, 2);  // the row that was begun is entered
    QVERIFY(*sherds::Sherds(sample_->catalogue()).byNumber("ARM1-T3-0012-1000"));
    QVERIFY(!*sherds::Sherds(sample_->catalogue()).byNumber("ARM1-T3-0012-1001"));
    auto* problem = child<QLabel>("problem");
    QVERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains("2"), qPrintable(problem->text()));
  }

  void whatIsBeingTypedOutlivesAnImport() {
    auto* sherds_table = child<QTableView>("sherds");
    QTest::mouseClick(sherds_table->viewport(), Qt::LeftButton, {},
                      sherds_table->visualRect(sherds_table->model()->index(1, 0)).center());
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(model_->canEnter());
    screen_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(screen_.get()));
    auto* note = child<QLineEdit>("field_note");
    note->setFocus();
    QTest::keyClicks(note, "half a ");
    model_->enter();
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(note->text(), QString("half a "));
    QVERIFY(note->hasFocus());
    QTest::keyClick(note, Qt::Key_Return);
    QCOMPARE(sample_->value(2, "note"), QString("half a"));
  }

  void importsThatBrokeOffAreToldWhenTheProjectIsOpened() {
    QVERIFY(catalogue::Settings(sample_->catalogue())
                .setValue("import.unfinished",
                          R"([{"source":"my <bags>.csv","entered":30,"of":100},)"
                          R"({"source":"contexts.csv","entered":5,"of":7}])"));
    screen_->openProject(sample_->session());
    auto* problem = child<QLabel>("problem");
    const QString told = problem->text();
    QVERIFY2(told.contains("my &lt;bags&gt;.csv") && told.contains("30 of 100"), qPrintable(told));
    QVERIFY2(told.contains("contexts.csv") && told.contains("5 of 7"), qPrintable(told));
    emit problem->linkActivated("forget");
    QVERIFY(problem->text().isEmpty());
    screen_->openProject(sample_->session());
    QVERIFY(problem->text().isEmpty());
  }

  void contextsComeFromATableOfTheirOwn() {
    open();
    model_->setSource(
        table("site,trench,context,period,bag\r\nARM1,T3,0012,Iron Age,4\r\nARM2,,7,,1\r\n"));
    QTRY_VERIFY(model_->canEnter());
    QVERIFY2(summary().startsWith("2 new"), qPrintable(summary()));
    QVERIFY(model_->warnings().join(' ').contains("Undo does not take back contexts and bags"));
    model_->enter();
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QVERIFY(*catalogue::Places(sample_->catalogue()).contextByPlace("ARM2", "", "7"));
  }

  // A spreadsheet saves over the table, or takes it away, while its preview is read.
  void theTableThatWasLookedAtIsEnteredWhateverBecomesOfItsFile() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(model_->canEnter());
    const QString other = table("number\r\n");
    model_->setMakesPlaces(true);  // looked at once more, with the same rows
    QTRY_VERIFY(model_->canEnter());
    QCOMPARE(model_->rows().size(), std::size_t{5});
    QVERIFY(QFile::remove(other));
    model_->enter();
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(sample_->value(0, "ware"), QString("black"));
    QVERIFY(*catalogue::Places(sample_->catalogue()).contextByPlace("ARM1", "T9", "0001"));
  }

  void noOtherTableIsChosenWhileOneIsEntered() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(model_->canEnter());
    QSignalSpy entered(model_, &ImportModel::entered);
    model_->enter();
    QVERIFY(!child<QPushButton>("importTable")->isEnabled());
    model_->setSource(table("number\r\n"));
    model_->openProject(&sample_->session());  // the dialog was closed and opened again
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(entered.count(), 1);
    QVERIFY(child<QPushButton>("importTable")->isEnabled());
  }

  void anotherProjectBeginsWithoutTheColumnsOfTheLastTable() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(!model_->columns().isEmpty());
    model_->openProject(nullptr);
    QVERIFY(model_->columns().isEmpty());
    model_->openProject(&sample_->session());
    QVERIFY(model_->columns().isEmpty());
  }

  void aTableThatIsNoneIsRefusedInWords() {
    open();
    model_->setSource(table("colour,size\r\nred,3\r\n"));
    QTRY_VERIFY(
        child<QLabel>("importProblem")->text().contains("needs a column for the sherds' numbers"));
    QVERIFY(!model_->canEnter());
  }

  void theColumnOfNumbersIsChosenWhereNoNameSaysIt() {
    open();
    model_->setSource(
        table("Inv;Fundort;Schnitt;Befund;Teil\r\nARM1-T3-0012-0001;ARM1;T3;0012;Boden\r\n"));
    QTRY_VERIFY(
        child<QLabel>("importProblem")->text().contains("but 'Teil' is a column of sherds"));
    QVERIFY2(!model_->canEnter(), "not as bags");
    QCOMPARE(summary(), QString());
    auto* field = child<QComboBox>("columnField0");
    field->setCurrentIndex(field->findData(QString("number")));
    emit field->activated(field->currentIndex());
    QTRY_COMPARE(summary(), QString("0 new, 1 updated, 0 unchanged, 0 rejected."));
    QVERIFY(child<QLabel>("importSource")->text().contains("the column 'Inv' identifies them"));
  }

  void refusalsGoIntoATable() {
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(child<QPushButton>("importRefusals")->isVisible());
    const QString path = sample_->folder() + "/refused 27.11";
    QCOMPARE(*model_->saveRefusals(path), path + ".csv");
    QFile file(path + ".csv");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray rows = file.readAll();
    QVERIFY2(rows.contains(",ARM1-T3-0012-0002,ARM1,T3,0012,grey,rimm\r\n") &&
                 rows.contains("part: 'rimm' is not a term"),
             rows.constData());
    QVERIFY2(!model_->saveRefusals(path), "nobody was asked whether it is overwritten");
    QVERIFY2(!model_->saveRefusals(model_->source()), "the table itself is still needed");
  }

  void anExportIsReadBack() {
    exchange::ExportOptions options;
    options.target = (sample_->folder() + "/out").toStdString();
    options.forms = {exchange::Form::Json};
    QuietProgress quiet;
    QVERIFY(exchange::exportFolder(sample_->catalogue(), sample_->session().folder(),
                                   sample_->sherds(), options, quiet, {})
                .has_value());
    SampleProject other(0);
    screen_->openProject(other.session());
    open();
    model_->setSource(sample_->folder() + "/out");
    QTRY_COMPARE(summary(), QString("10 new, 0 updated, 0 unchanged, 0 rejected."));
    QVERIFY(model_->canEnter());
    std::optional<Result<FolderLock>> another = FolderLock::take(other.session().folder());
    model_->enter();
    QTRY_VERIFY(child<QLabel>("importProblem")->text().startsWith("Another import"));
    another.reset();
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QVERIFY(!child<QLabel>("importProblem")->text().contains("Another import"));
    QCOMPARE(child<QLabel>("count")->text(), QString("10 sherd(s)"));
    screen_->closeProject();
  }

  // Both laptops described the same sherds, and no new one.
  void anotherLaptopsVersionsCanBeEntered() {
    exchange::ExportOptions options;
    options.target = (sample_->folder() + "/b").toStdString();
    options.forms = {exchange::Form::Json};
    QuietProgress quiet;
    QVERIFY(exchange::exportFolder(sample_->catalogue(), sample_->session().folder(),
                                   sample_->sherds(), options, quiet, {})
                .has_value());
    const records::FieldChange ours{sample_->sherds()[0], "ware", "black"};
    QVERIFY(sherds::SherdChanges(sample_->catalogue()).apply(std::span(&ours, 1), {}).has_value());
    open();
    model_->setSource(sample_->folder() + "/b");
    QTRY_COMPARE(summary(), QString("0 new, 0 updated, 9 unchanged, 1 rejected."));
    QVERIFY(model_->canEnter());
    model_->enter();
    QTRY_COMPARE(model_->state(), ImportModel::State::Done);
    QCOMPARE(sample_->value(0, "extra.ware_in_b"), QString("grey"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "extra.ware_in_b"), QString());
    sample_->session().undo().redo();
    QCOMPARE(sample_->value(0, "extra.ware_in_b"), QString("grey"));
    model_->setSource(sample_->folder() + "/b");
    QTRY_COMPARE(model_->state(), ImportModel::State::Ready);
    QVERIFY2(!model_->canEnter(), "there is nothing more to keep");
  }

  void theButtonsAreOnTheScreenWhereLettersAreLarge() {
    applyLook(*qApp, Theme::Light, 250);
    open();
    auto* dialog = child<ImportDialog>("importDialog");
    const int room = dialog->screen()->availableSize().height();
    QVERIFY2(32 * dialog->fontMetrics().height() > room, "else it fits anyway");
    QVERIFY2(dialog->height() < room, qPrintable(QString::number(dialog->height())));
    applyLook(*qApp, Theme::Light, 100);
  }

  void looksRightInEveryTheme() {
    const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    open();
    model_->setSource(sherds());
    QTRY_VERIFY(child<QPushButton>("importRefusals")->isVisible());
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
      applyLook(*qApp, theme, 100);
      auto* dialog = child<ImportDialog>("importDialog");
      QTRY_COMPARE(dialog->palette().color(QPalette::Window),
                   qApp->palette().color(QPalette::Window));
      if (!folder.isEmpty()) dialog->grab().save(folder + "/import-" + themeName(theme) + ".png");
      QVERIFY(child<QLabel>("importSummary")->isVisible());
    }
  }
};

OSTRAKA_UI_TEST(ImportTest)
#include "import_test.moc"
