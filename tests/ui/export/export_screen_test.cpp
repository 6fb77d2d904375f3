#include "ui/export/export_screen.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTest>

#include "../named.h"
#include "catalogue/batches.h"
#include "sample_project.h"
#include "tests/ui/program.h"
#include "ui/look/look.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class ExportScreenTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<SampleProject> sample_;
  std::unique_ptr<ExportScreen> screen_;

  template <class T>
  T* child(const char* name) {
    return named<T>(*screen_, name);
  }
  void toFolder(const QString& name) {
    auto* target = child<QLineEdit>("target");
    target->setFocus();
    target->selectAll();
    QTest::keyClicks(target, sample_->folder() + "/" + name);
  }

 private slots:
  void init() {
    sample_ = std::make_unique<SampleProject>(40);
    screen_ = std::make_unique<ExportScreen>();
    screen_->resize(1280, 720);
    screen_->openProject(sample_->session());
    activate(*screen_);
  }
  void cleanup() {
    screen_.reset();
    sample_.reset();
  }

  void theSizeIsShownBeforeItStarts() {
    QTRY_VERIFY(child<QLabel>("size")->text().startsWith("40 sherd(s), 83 files"));
    screen_->showItem("filter:rim");
    QVERIFY(child<QRadioButton>("filtered")->isChecked());
    QTRY_VERIFY(child<QLabel>("size")->text().startsWith("14 sherd(s)"));
    screen_->showItem(
        QString("rows:%1,%2").arg(sample_->sherds()[0].value).arg(sample_->sherds()[1].value));
    QTRY_VERIFY(child<QLabel>("size")->text().startsWith("2 sherd(s)"));
    QVERIFY(child<QRadioButton>("chosen")->isChecked());
  }

  void eachProjectIsProposedAFolderOfItsOwn() {
    const auto proposed = [](SampleProject& of) {
      return QDir::home().filePath(
          QString::fromStdString(of.session().folder().filename().string()) + "-export");
    };
    QCOMPARE(child<QLineEdit>("target")->text(), proposed(*sample_));
    toFolder("typed");
    SampleProject other(1, "other");
    screen_->closeProject();
    QCOMPARE(child<QLineEdit>("target")->text(), QString());
    screen_->openProject(other.session());
    QCOMPARE(child<QLineEdit>("target")->text(), proposed(other));
  }

  void aProjectRemembersWhatItsExportsWereMadeOf() {
    const auto form = [this](exchange::Form kind) {
      return child<QCheckBox>(qPrintable("form" + QString::number(static_cast<int>(kind))));
    };
    form(exchange::Form::Drawings)->click();
    form(exchange::Form::Csv)->click();
    for (const char* box : {"exportScale", "exportSurface", "exportDetail"}) {
      child<QComboBox>(box)->setFocus();
      QTest::keyClick(child<QComboBox>(box), Qt::Key_End);
    }
    toFolder("Hill");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QVERIFY2(screen_->model().state() == ExportModel::State::Done,
             qPrintable(screen_->model().problem()));
    SampleProject other(1, "other");  // has choices of its own
    screen_->openProject(other.session());
    QVERIFY(!form(exchange::Form::Drawings)->isChecked());
    QVERIFY(form(exchange::Form::Csv)->isChecked());
    screen_->openProject(sample_->session());
    QVERIFY(form(exchange::Form::Drawings)->isChecked());
    QVERIFY(!form(exchange::Form::Csv)->isChecked());
    QCOMPARE(child<QComboBox>("exportScale")->currentText(), QString("fit to A4"));
    QCOMPARE(child<QComboBox>("exportSurface")->currentText(), QString("Orthophoto, 600 dpi"));
    QVERIFY(child<QComboBox>("exportDetail")->currentText().contains("1 MB"));
    QVERIFY2(child<QLineEdit>("target")->text().startsWith(sample_->folder() + "/"),
             qPrintable(child<QLineEdit>("target")->text()));
  }

  void theSizeFollowsHowSurfacesAreDrawn() {
    sample_->giveModel(1);
    exchange::ExportOptions options = screen_->model().options();
    options.forms = {exchange::Form::Drawings};
    screen_->model().setOptions(options);
    screen_->takeChosen(QString("rows:%1").arg(sample_->sherds()[1].value));
    const auto counted = [this] {
      const QString text = child<QLabel>("size")->text();
      return text.startsWith("1 sherd(s)") ? text : QString();
    };
    QTRY_VERIFY_WITH_TIMEOUT(!counted().isEmpty(), 60000);
    const QString shaded = counted();
    auto* surface = child<QComboBox>("exportSurface");
    surface->setFocus();
    QTest::keyClick(surface, Qt::Key_End);
    QVERIFY(screen_->model().options().drawing_surface == drawing::Surface::Orthophoto);
    QVERIFY(screen_->model().options().drawing_dpi == drawing::Dpi::Fine);
    QTRY_VERIFY_WITH_TIMEOUT(!counted().isEmpty() && counted() != shaded, 60000);
  }

  void theNextExportIsProposedANameThatIsFree() {
    toFolder("out");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    child<QLineEdit>("target")->clearFocus();
    child<QRadioButton>("filtered")->click();
    QCOMPARE(child<QLineEdit>("target")->text(), sample_->folder() + "/out-2");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
  }

  void whatWasChosenInTheCatalogueComesAlong() {
    screen_->takeChosen({});
    QVERIFY(!child<QRadioButton>("chosen")->isEnabled());
    QVERIFY(child<QRadioButton>("all")->isChecked());
    screen_->takeChosen(QString("rows:%1").arg(sample_->sherds()[0].value));
    QVERIFY(child<QRadioButton>("chosen")->isChecked());
    QVERIFY(child<QRadioButton>("chosen")->text().startsWith("1 "));
    screen_->takeChosen(
        QString("rows:%1,%2").arg(sample_->sherds()[0].value).arg(sample_->sherds()[1].value));
    QVERIFY(child<QRadioButton>("chosen")->isChecked());
    QTRY_VERIFY(child<QLabel>("size")->text().startsWith("2 sherd(s)"));
  }

  void whichSherdsHaveNoModelIsSaidBeforeAndAfter() {
    sample_->giveModel(1);
    screen_->takeChosen(
        QString("rows:%1,%2").arg(sample_->sherds()[0].value).arg(sample_->sherds()[1].value));
    const QString words = "1 of them without a model: ARM1-T3-0012-0001";
    QTRY_VERIFY(child<QLabel>("size")->text().endsWith("\n" + words));
    toFolder("out");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QCOMPARE(screen_->model().warnings(), QStringList(words));
  }

  void escStopsAnExportAndTheFootTellsOfIt() {
    toFolder("stopped");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    const QSignalSpy working(screen_.get(), &Screen::working);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QVERIFY(screen_->model().state() == ExportModel::State::Running);
    QVERIFY(screen_->losesByClosing().contains("Close once more"));
    QVERIFY(working.count() > 0 && working.back().front().toString().startsWith("Export: "));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QVERIFY(screen_->model().state() == ExportModel::State::Failed);
    QVERIFY(screen_->losesByClosing().isEmpty());
    QVERIFY(working.back().front().toString().isEmpty());
  }

  void theSizeIsNotCountedWhileNobodyLooks() {
    auto* size = child<QLabel>("size");
    QTRY_VERIFY(size->text().startsWith("40 sherd(s)"));
    screen_->hide();
    sample_->addDraft();
    sample_->session().tellSherdsChanged();
    QTest::qWait(0);
    QVERIFY(!screen_->model().canStart());
    QCOMPARE(screen_->model().sizeText(), QString("Counting…"));
    QVERIFY(screen_->model().findChildren<JobHandle*>().isEmpty());
    screen_->show();
    QTRY_VERIFY(size->text().startsWith("41 sherd(s)"));
  }

  void anExportEndsWithAClosingLineAndAFolder() {
    toFolder("out");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    const QSignalSpy said(screen_.get(), &Screen::said);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QVERIFY2(screen_->model().state() == ExportModel::State::Done,
             qPrintable(screen_->model().problem()));
    QVERIFY(child<QLabel>("closing")->text().startsWith("40 sherd(s), "));
    QVERIFY(child<QLabel>("closing")->text().endsWith("manifest checked"));
    QVERIFY(child<QPushButton>("open")->isVisible());
    QVERIFY(!child<QLabel>("size")->text().contains("already"));  // it is the one just written
    QVERIFY(QFileInfo::exists(sample_->folder() + "/out/data/sherds.csv"));
    QVERIFY(QFileInfo::exists(sample_->folder() + "/out/data/images/ARM1-T3-0012-0001.png"));
    QCOMPARE(said.count(), 1);
    QVERIFY2(!child<QPushButton>("start")->isEnabled(), "never over a folder that is there");
    // Edits since do not take back that it is there; another wish does.
    sample_->addDraft();
    sample_->session().tellSherdsChanged();
    QTRY_VERIFY(child<QLabel>("size")->text().startsWith("41 sherd(s)"));
    QVERIFY(child<QLabel>("closing")->isVisible());
    QVERIFY(child<QLabel>("closing")->text().startsWith("40 sherd(s), "));
    QVERIFY(child<QPushButton>("open")->isVisible());
    toFolder("next");
    QVERIFY(!child<QLabel>("closing")->isVisible());
    QVERIFY(!child<QPushButton>("open")->isVisible());
  }

  void drawingsGoBesideTheModels() {
    sample_->giveModel(1);  // a body sherd
    screen_->showItem(QString("rows:%1").arg(sample_->sherds()[1].value));
    auto* drawings = child<QCheckBox>(
        qPrintable("form" + QString::number(static_cast<int>(exchange::Form::Drawings))));
    QVERIFY(!drawings->isChecked());
    QTest::mouseClick(drawings, Qt::LeftButton, {}, QPoint(8, drawings->height() / 2));
    auto* scale = child<QComboBox>("exportScale");
    QCOMPARE(scale->currentText(), QString("1 : 1"));
    scale->setFocus();
    QTest::keyClick(scale, Qt::Key_Down);
    toFolder("drawn");
    QTRY_VERIFY(child<QLabel>("size")->text().startsWith("1 sherd(s), 19 files"));
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QCOMPARE(screen_->model().warnings(), QStringList());
    QVERIFY(child<QLabel>("closing")->text().endsWith("manifest checked"));
    const QString base = sample_->folder() + "/drawn/data/drawings/ARM1-T3-0013-0001.";
    QVERIFY(QFileInfo(base + "svg").size() > 10000);
    QVERIFY(QFileInfo(base + "pdf").size() > 10000);
    QFile svg(base + "svg");
    QVERIFY(svg.open(QIODevice::ReadOnly));
    QVERIFY(svg.readAll().contains("1 : 2"));
  }

  void smallerModelsStateHowFarTheyAreOff() {
    sample_->giveModel(1, exchange::closedShell(160, 384));  // more than 1 MB
    screen_->showItem(QString("rows:%1").arg(sample_->sherds()[1].value));
    auto* detail = child<QComboBox>("exportDetail");
    QCOMPARE(detail->currentText(), QString("Full detail"));
    detail->setFocus();
    QTest::keyClick(detail, Qt::Key_Down);
    QTest::keyClick(detail, Qt::Key_Down);
    QVERIFY(detail->currentText().contains("1 MB"));
    toFolder("lighter");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QCOMPARE(screen_->model().problem(), QString());
    QFile ply(sample_->folder() + "/lighter/data/models/ARM1-T3-0013-0001.ply");
    QVERIFY(ply.open(QIODevice::ReadOnly));
    QVERIFY(
        ply.readAll().contains("comment simplified from the full-detail model: 99.9 % within 0"));
  }

  void stoppingLeavesNothingBehind() {
    toFolder("stopped");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    screen_->model().cancel();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QVERIFY(child<QLabel>("problem")->text().contains("Nothing was left behind"));
    QVERIFY(!QFileInfo::exists(sample_->folder() + "/stopped"));
    QVERIFY(!QFileInfo::exists(sample_->folder() + "/stopped.partial"));
  }

  void aFilterThatIsNotUnderstoodIsNamed() {
    screen_->showItem("filter:colour:red");
    QTRY_VERIFY(child<QLabel>("problem")->text().contains("colour"));
    QVERIFY(!child<QPushButton>("start")->isEnabled());
  }

  // A click while the size is counted is not lost.
  void anExportNeedNotWaitForItsSize() {
    toFolder("at-once");
    child<QCheckBox>(qPrintable("form" + QString::number(static_cast<int>(exchange::Form::Csv))))
        ->click();
    QCOMPARE(child<QLabel>("size")->text(), QString("Counting…"));
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QVERIFY2(screen_->model().state() == ExportModel::State::Done,
             qPrintable(screen_->model().problem()));
  }

  void theWholeProjectIsArchived() {
    auto* archive = child<QRadioButton>("archive");
    archive->click();
    QVERIFY(child<QLineEdit>("target")->text().endsWith("sample-archive"));
    QVERIFY2(!child<QCheckBox>("form0")->isEnabled(), "all of it, in no other form");
    QVERIFY(child<QLabel>("size")->text().contains("Restore an archive"));
    QVERIFY(!child<QLabel>("size")->text().contains("queue"));
    records::BatchRecord queued;
    queued.state = records::BatchState::Queued;
    QVERIFY(catalogue::Batches(sample_->session().project().catalogue()).add(queued, {}));
    sample_->session().tellBatchChanged("B0002");
    QVERIFY2(child<QLabel>("size")->text().contains("1 batch(es) in the queue"),
             qPrintable(child<QLabel>("size")->text()));
    toFolder("kept");
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QVERIFY2(screen_->model().state() == ExportModel::State::Done,
             qPrintable(screen_->model().problem()));
    QVERIFY(child<QLabel>("closing")->text().startsWith("The whole project, "));
    QVERIFY(child<QPushButton>("open")->isVisible());
    QVERIFY(child<QPushButton>("open")->hasFocus());
    for (const char* file : {"README.txt", "manifest-sha256.txt", "data/catalogue.sqlite"})
      QVERIFY2(QFileInfo::exists(sample_->folder() + "/kept/" + file), file);
    child<QRadioButton>("all")->click();
    QVERIFY(child<QCheckBox>("form0")->isEnabled());
  }

  void anArchiveWithDamageSaysSo() {
    QVERIFY(QFile::link("/etc/hostname", sample_->folder() + "/sample/batches/elsewhere"));
    child<QRadioButton>("archive")->click();
    toFolder("damaged");
    const QSignalSpy finished(&screen_->model(), &ExportModel::finished);
    QTest::mouseClick(child<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30000);
    QCOMPARE(screen_->model().warnings(),
             QStringList("1 file(s) of the project are missing, changed or links; damage.txt in "
                         "the archive lists them."));
  }

  void withoutAFormThereIsNothingToDo() {
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    for (QCheckBox* form : screen_->findChildren<QCheckBox*>())
      if (form->isChecked())
        QTest::mouseClick(form, Qt::LeftButton, {}, QPoint(8, form->height() / 2));
    QTRY_VERIFY(!child<QPushButton>("start")->isEnabled());
  }

  void looksRightInEveryTheme() {
    const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    toFolder("shown");
    QTRY_VERIFY(child<QPushButton>("start")->isEnabled());
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
      applyLook(*qApp, theme, 100);
      QTRY_COMPARE(screen_->palette().color(QPalette::Window),
                   qApp->palette().color(QPalette::Window));
      if (!folder.isEmpty()) screen_->grab().save(folder + "/export-" + themeName(theme) + ".png");
      QVERIFY(child<QLabel>("size")->isVisible());
    }
  }
};

OSTRAKA_UI_TEST(ExportScreenTest)
#include "export_screen_test.moc"
