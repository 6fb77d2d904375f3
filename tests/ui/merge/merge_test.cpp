// Another project comes into the open one: looked at, settled by a person, entered whole or not at
// all; in a real window.
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <memory>
#include <optional>

#include "../named.h"
#include "../names.h"
#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "sample_project.h"
#include "sherds/filter.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/look/look.h"
#include "ui/merge/merge_dialog.h"

using namespace ostraka;
using namespace ostraka::ui;

class MergeTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<SampleProject> sample_;  ///< the open one
  std::optional<upkeep::Project> b_;       ///< a copy that went its own way
  std::unique_ptr<CatalogueScreen> screen_;
  MergeModel* model_ = nullptr;

  template <class T>
  T* child(const char* name) {
    return named<T>(*screen_, name);
  }
  QTableWidget* table() { return child<QTableWidget>("mergeConflicts"); }
  QString cell(int row, int column) { return table()->item(row, column)->text(); }
  QPushButton* enter() { return child<QPushButton>("mergeEnter"); }
  QString b() const { return sample_->folder() + "/b"; }
  std::int64_t history() { return catalogue::History(sample_->catalogue()).length(); }

  void say(catalogue::Catalogue& catalogue, const std::string& field, const std::string& value) {
    const records::FieldChange change{sample_->row(0), field, value};
    SampleProject::must(sherds::SherdChanges(catalogue).apply(std::span(&change, 1),
                                                              sample_->session().provenance()));
  }
  /// In the context of the first sherd, with its next number.
  void numberedSherd(catalogue::Catalogue& catalogue, const std::string& ware) {
    records::SherdRecord sherd;
    sherd.context = SampleProject::must(sherds::Sherds(catalogue).get(sample_->row(0))).context;
    sherd.ware = ware;
    const store::SherdRow row = SampleProject::must(sherds::Sherds(catalogue).add(sherd, {}));
    SampleProject::must(sherds::Numbers(catalogue).assign(std::span(&row, 1), {}));
  }
  void bothSayAWare() {
    say(sample_->catalogue(), "ware", "black");
    say(b_->catalogue(), "ware", "red slipped");
  }
  void compare() {
    QTest::mouseClick(child<QPushButton>("import"), Qt::LeftButton);
    QTest::mouseClick(child<QPushButton>("importMerge"), Qt::LeftButton);
    QVERIFY(QTest::qWaitForWindowActive(child<MergeDialog>("mergeDialog")));
    model_ = screen_->findChild<MergeModel*>();
    model_->setFolder(b());
    QTRY_COMPARE(model_->state(), MergeModel::State::Settling);
    // A window manager may have taken the keys elsewhere meanwhile.
    auto* dialog = child<MergeDialog>("mergeDialog");
    dialog->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(dialog));
  }

 private slots:
  void init() {
    sample_ = std::make_unique<SampleProject>(4);
    QVERIFY(QDir().mkpath(b()));
    const std::filesystem::path there = b().toStdString();
    SampleProject::must(sample_->catalogue().backup(there / "catalogue.sqlite"));
    b_ = SampleProject::must(upkeep::Project::open(there));
    screen_ = std::make_unique<CatalogueScreen>();
    screen_->resize(1280, 720);
    screen_->openProject(sample_->session());
    activate(*screen_);
  }
  void cleanup() {
    screen_.reset();
    b_.reset();
    sample_.reset();
  }

  void aConflictStandsSideBySideAndIsSettledByKey() {
    bothSayAWare();
    compare();
    QCOMPARE(table()->rowCount(), 1);
    QVERIFY2(cell(0, 0).contains("ARM1-T3-0012-0001"), qPrintable(cell(0, 0)));
    QCOMPARE(cell(0, 1), QString("ware"));
    QVERIFY2(cell(0, 2).startsWith("black\nAP, "), qPrintable(cell(0, 2)));
    QVERIFY2(cell(0, 3).startsWith("red slipped\nAP, "), qPrintable(cell(0, 3)));
    QVERIFY(!enter()->isEnabled());
    QCOMPARE(enter()->text(), QString("1 conflict(s) to settle"));
    QTest::keyClick(table(), Qt::Key_2);
    QCOMPARE(cell(0, 4), QString("Other project"));
    QVERIFY(enter()->isEnabled());
    QTest::mouseClick(enter(), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), MergeModel::State::Done);
    QCOMPARE(sample_->value(0, "ware"), QString("red slipped"));
    QVERIFY(child<QLabel>("mergeSummary")->text().startsWith("Merged b."));
  }

  // As a merge leaves it that was killed, and whose batch was processed again since.
  void whatAnEarlierMergeLeftAsItIsHereIsNamed() {
    const std::filesystem::path folder = sample_->session().folder();
    SampleProject::must(writeFileAtomically(folder / "results/B0009/report.json", "made anew"));
    SampleProject::must(writeFileAtomically(folder / "merge.partial/1", "report of B"));
    SampleProject::must(catalogue::Settings(sample_->catalogue())
                            .setValue("merge.files", R"({"results/B0009/report.json":["1",")" +
                                                         sha256("of before") + R"("]})"));
    compare();
    QVERIFY2(model_->notes().contains("What lies there is kept"), qPrintable(model_->notes()));
    QVERIFY2(model_->notes().contains("results/B0009"), qPrintable(model_->notes()));
  }

  void whatIsSettledCanBeUndoneUntilItIsEntered() {
    bothSayAWare();
    say(sample_->catalogue(), "note", "a handle");
    say(b_->catalogue(), "note", "a foot");
    compare();
    QCOMPARE(model_->unsettled(), 2);
    QTest::keyClick(table(), Qt::Key_2);
    QTest::mouseClick(child<QPushButton>("mergeRest"), Qt::LeftButton);
    QCOMPARE(cell(0, 4), QString("Other project"));
    QCOMPARE(cell(1, 4), QString("This project"));
    QVERIFY(enter()->isEnabled());
    QTest::keyClick(table(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(cell(1, 4), QString("Open"));
    QCOMPARE(enter()->text(), QString("1 conflict(s) to settle"));
    QTest::keyClick(table(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(model_->unsettled(), 2);
    QVERIFY(!model_->canUndo());
  }

  void closingWithoutEnteringChangesNothing() {
    bothSayAWare();
    numberedSherd(b_->catalogue(), "grey");
    const std::int64_t before = history();
    compare();
    QVERIFY2(child<QLabel>("mergeSummary")->text().startsWith("Sherds: 1. Batches: 0."),
             qPrintable(child<QLabel>("mergeSummary")->text()));
    QTest::mouseClick(child<QPushButton>("mergeRest"), Qt::LeftButton);
    QVERIFY(enter()->isEnabled());
    QTest::mouseClick(child<QPushButton>("mergeCancel"), Qt::LeftButton);
    QTRY_VERIFY(screen_->findChild<MergeDialog*>() == nullptr);
    QCOMPARE(sample_->value(0, "ware"), QString("black"));
    QCOMPARE(history(), before);
  }

  void aNumberThatBothGaveIsProposedANewOneWhichMayBeTyped() {
    numberedSherd(sample_->catalogue(), "black");
    numberedSherd(b_->catalogue(), "grey");
    compare();
    QCOMPARE(table()->rowCount(), 1);
    QCOMPARE(cell(0, 1), QString("number"));
    QVERIFY(cell(0, 2).contains("ware: black"));
    QVERIFY(cell(0, 3).contains("ware: grey"));
    const QString proposed = QString::fromStdString(model_->conflicts().front().new_b);
    QVERIFY2(proposed.startsWith("ARM1-T3-0012-"), qPrintable(proposed));
    QCOMPARE(cell(0, 4), "Open; new number: " + proposed);
    auto* number = child<QLineEdit>("mergeNewNumber");
    QCOMPARE(number->text(), proposed);
    QVERIFY(child<QPushButton>("mergeThisButton")->text().contains("the other's gets " + proposed));
    QVERIFY(
        child<QPushButton>("mergeOtherButton")->text().contains("this project's gets " + proposed));
    QTest::keyClick(table(), Qt::Key_1);
    QCOMPARE(cell(0, 4), "This project; the other sherd: " + proposed);
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, "ARM1-T3-0012-0123");  // its digits settle nothing
    QTest::keyClick(number, Qt::Key_Return);
    QCOMPARE(cell(0, 4), QString("This project; the other sherd: ARM1-T3-0012-0123"));
    QTest::mouseClick(enter(), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), MergeModel::State::Done);
    QVERIFY(*sherds::Sherds(sample_->catalogue()).byNumber("ARM1-T3-0012-0123"));
    auto* list = child<QPlainTextEdit>("mergeNewNumbers");
    QVERIFY(list->isVisible());
    QVERIFY2(list->toPlainText().endsWith("→ ARM1-T3-0012-0123"), qPrintable(list->toPlainText()));
    QTest::mouseClick(child<QPushButton>("mergeCopy"), Qt::LeftButton);
    QCOMPARE(QApplication::clipboard()->text(), list->toPlainText());
  }

  void twoRecordsOfOneSherdBecomeOne() {
    numberedSherd(sample_->catalogue(), "black");
    numberedSherd(b_->catalogue(), "black");
    compare();
    const auto count = [this] { return sherds::Sherds(sample_->catalogue()).rows({}, {})->size(); };
    const std::size_t before = count();
    QVERIFY(child<QPushButton>("mergeNumberButton")->text().startsWith("One sherd"));
    QTest::keyClick(table(), Qt::Key_3);
    QCOMPARE(cell(0, 4), QString("One sherd"));
    QTest::mouseClick(enter(), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), MergeModel::State::Done);
    QCOMPARE(count(), before);
    QVERIFY(child<QPlainTextEdit>("mergeNewNumbers")->isHidden());
  }

  void everySherdWithANewNumberIsListedInTheEnd() {
    for (int i = 0; i < 6; ++i) {
      numberedSherd(sample_->catalogue(), "black");
      numberedSherd(b_->catalogue(), "grey");
    }
    compare();
    QTest::mouseClick(child<QPushButton>("mergeRest"), Qt::LeftButton);
    QTest::mouseClick(enter(), Qt::LeftButton);
    QTRY_COMPARE(model_->state(), MergeModel::State::Done);
    QCOMPARE(model_->newNumbers().size(), 6);
    QCOMPARE(child<QPlainTextEdit>("mergeNewNumbers")->toPlainText().split('\n').size(), 6);
  }

  void theCatalogueShowsWhatCame() {
    numberedSherd(b_->catalogue(), "grey");
    compare();
    QVERIFY(table()->isHidden());
    QSignalSpy said(screen_.get(), &Screen::said);
    const int rows = child<QTableView>("sherds")->model()->rowCount();
    QTest::mouseClick(enter(), Qt::LeftButton);
    QTRY_COMPARE(said.count(), 1);
    QVERIFY(said.at(0).at(0).toString().startsWith("Merged b. Sherds: 1."));
    QCOMPARE(child<QTableView>("sherds")->model()->rowCount(), rows + 1);
    model_->setFolder(b());
    QTRY_COMPARE(model_->state(), MergeModel::State::Settling);
    QVERIFY2(!model_->canEnter(), "there is nothing more to merge");
  }

  void aFolderThatIsNoProjectAndTheProjectItselfAreRefused() {
    compare();
    for (const QString& folder :
         {sample_->folder(), QString::fromStdString(sample_->session().folder().string())}) {
      model_->setFolder(folder);
      QTRY_COMPARE(model_->state(), MergeModel::State::Choosing);
      QVERIFY(!child<QLabel>("mergeNotes")->text().isEmpty());
      QVERIFY(!enter()->isEnabled());
    }
  }

  void looksRightInEveryThemeAndNamesItsControls() {
    const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    bothSayAWare();
    numberedSherd(sample_->catalogue(), "black");
    numberedSherd(b_->catalogue(), "grey");
    compare();
    auto* dialog = child<MergeDialog>("mergeDialog");
    const QStringList nameless = namelessIn(*dialog);
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join('\n')));
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Sunlight}) {
      applyLook(*qApp, theme, 100);
      QTRY_COMPARE(dialog->palette().color(QPalette::Window),
                   qApp->palette().color(QPalette::Window));
      if (!folder.isEmpty()) dialog->grab().save(folder + "/merge-" + themeName(theme) + ".png");
    }
    applyLook(*qApp, Theme::Light, 100);
  }
};

OSTRAKA_UI_TEST(MergeTest)
#include "merge_test.moc"
