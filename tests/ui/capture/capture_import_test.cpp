// Photographs by hand that are dropped onto the screen.
#include <QCheckBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QUrl>
#include <QtTest>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "capture_bench.h"
#include "catalogue/batches.h"
#include "tests/ui/program.h"
#include "ui/capture/capture_screen.h"
#include "ui/capture/rig_page.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "ui/import/import_ask.h"
#include "ui/import/place_edit.h"
#include "ui/widgets/message_panel.h"
#include "ui/wizard/capture_wizard.h"
#include "upkeep/project.h"
#include "virtualrig/batch_files.h"
#include "virtualrig/simulate.h"

using namespace ostraka;
using namespace ostraka::ui;

class CaptureImportTest : public CaptureBench {
  Q_OBJECT

 private slots:
  void init() {
    open();
    disk_ = std::make_unique<QTemporaryDir>();
  }
  void cleanup() { close(); }

  // The two drops and the button: nothing else is needed.
  void twoDroppedFoldersAreImportedWithOneButton() {
    photographs("fronts", 4);
    photographs("backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(disk_->path().toStdString()).has_value());
    drop({disk_->filePath("fronts"), disk_->filePath("backs")});
    auto* ask = screen_->findChild<ImportAsk*>();
    QTRY_VERIFY(ask->isVisible());
    QVERIFY(child<QLabel>("importFront")->text().contains("IMG_0.jpg to IMG_3.jpg"));
    QVERIFY(child<QLabel>("importBack")->text().contains("IMG_0.jpg to IMG_2.jpg"));
    QVERIFY(!child<QSlider>("importDivide")->isVisible());
    QVERIFY(child<QLabel>("importSheet")->text().contains("plate.json"));
    QTest::mouseClick(child<QPushButton>("importSwap"), Qt::LeftButton);
    QVERIFY(child<QLabel>("importFront")->text().contains("IMG_0.jpg to IMG_2.jpg"));
    QTest::mouseClick(child<QPushButton>("importSwap"), Qt::LeftButton);
    QSignalSpy imported(screen_->importer(), &BatchImporter::imported);
    QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
    QTest::mouseClick(child<QPushButton>("importStart"), Qt::LeftButton);
    QTRY_COMPARE(imported.count(), 1);
    QCOMPARE(wanted.count(), 1);
    const auto batch = catalogue::Batches(session_->project().catalogue()).byNumber("B0001");
    QVERIFY(batch.has_value());
    QCOMPARE(batch->state, records::BatchState::Queued);
  }

  void whoDoesSomethingElseMeanwhileIsNotTakenToTheQueue() {
    QVERIFY(virtualrig::writePlateAndBoard(disk_->path().toStdString()).has_value());
    QSignalSpy imported(screen_->importer(), &BatchImporter::imported);
    QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
    auto* ask = screen_->findChild<ImportAsk*>();
    const auto start = [&](const QString& front, const QString& back) {
      photographs(front, 4);
      photographs(back, 3);
      drop({disk_->filePath(front), disk_->filePath(back)});
      QTRY_VERIFY(ask->isVisible());
      QTest::mouseClick(child<QPushButton>("importStart"), Qt::LeftButton);
    };
    start("f", "bb");
    ask->ask("another", ImportKind::Scans);
    QTRY_COMPARE(imported.count(), 1);
    QVERIFY(ask->isVisible());
    ask->leave();
    start("ffff", "bbbbbb");
    screen_->hide();
    QTRY_COMPARE(imported.count(), 2);
    QCOMPARE(wanted.count(), 0);
  }

  void aSeriesWithoutAPauseIsDividedByAPersonOrImportedAsOneSide() {
    photographs("series", 8);
    drop({disk_->filePath("series")});
    auto* ask = screen_->findChild<ImportAsk*>();
    QTRY_VERIFY(ask->isVisible());
    auto* start = child<QPushButton>("importStart");
    auto* where = child<QSlider>("importDivide");
    QVERIFY(!start->isEnabled());
    QVERIFY(child<QLabel>("importReason")->isVisible());
    QCOMPARE(screen_->primary(), start);
    QVERIFY2(!screen_->findChild<QAction*>("captureNext")->isEnabled(), "Space starts the rig");
    QVERIFY(child<QLabel>("importFlip")->text().contains("No pause"));
    QVERIFY(child<QLabel>("importSheet")->text().contains("no scale"));
    QCOMPARE(where->minimum(), 3);
    QCOMPARE(where->maximum(), 5);
    where->setFocus();
    QTest::keyClick(where, Qt::Key_Right);
    QVERIFY(start->isEnabled());
    QVERIFY(!child<QLabel>("importReason")->isVisible());
    QVERIFY(child<QLabel>("importFront")->text().contains("IMG_0.jpg to IMG_4.jpg"));
    QVERIFY(child<QLabel>("importBack")->text().contains("IMG_5.jpg to IMG_7.jpg"));
    child<QCheckBox>("importOneSide")->click();
    QVERIFY(child<QLabel>("importFront")->text().contains("IMG_0.jpg to IMG_7.jpg"));
    QVERIFY(!child<QPushButton>("importSwap")->isVisible());
    QTest::keyClick(ask, Qt::Key_Escape);
    QVERIFY(!ask->isVisible());
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
  }

  // It lies in the middle, and the person turned the sherds over there.
  void aDivisionThatIsRightIsConfirmedWithOneButton() {
    photographs("series", 8);
    drop({disk_->filePath("series")});
    QTRY_VERIFY(screen_->findChild<ImportAsk*>()->isVisible());
    auto* start = child<QPushButton>("importStart");
    auto* divided = child<QPushButton>("importDivided");
    QVERIFY(divided->isVisible() && !start->isEnabled());
    QTest::mouseClick(divided, Qt::LeftButton);
    QVERIFY(start->isEnabled());
    QVERIFY(!divided->isVisible());
    QVERIFY(child<QLabel>("importFront")->text().contains("IMG_0.jpg to IMG_3.jpg"));
    QVERIFY(child<QLabel>("importBack")->text().contains("IMG_4.jpg to IMG_7.jpg"));
  }

  void theFolderOfTheFrontIsRefusedForTheBackAtOnce() {
    photographs("series", 8);
    drop({disk_->filePath("series")});
    QTRY_VERIFY(screen_->findChild<ImportAsk*>()->isVisible());
    QTest::mouseClick(child<QPushButton>("importBackFolder"), Qt::LeftButton);
    auto* dialog = screen_->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->close();
    emit dialog->fileSelected(disk_->filePath("series"));
    QVERIFY(shownMessage() != nullptr);
    QVERIFY(shownMessage()->words().contains("those of the front already"));
    QVERIFY(child<QLabel>("importFront")->text().contains("IMG_0.jpg to IMG_3.jpg"));
  }

  void theLineAtTheHeadIsOfTheImportsOwnBag() {
    photographs("series", 8);
    auto* ask = screen_->findChild<ImportAsk*>();
    drop({disk_->filePath("series")});
    QTRY_VERIFY(ask->isVisible());
    QCOMPARE(screen_->whereWords(), QString());
    QSignalSpy changed(screen_.get(), &CaptureScreen::lineChanged);
    QTest::keyClicks(ask->place()->findChild<QLineEdit*>(), "ARM1-T3-0012-6");
    QVERIFY(changed.count() > 0);
    QCOMPARE(screen_->whereWords(), QStringLiteral("ARM1 / T3 / 0012 bag 6"));
  }

  void theBagIsReadFromItsLabelInThePhotographs() {
    photographs("fronts", 4);
    photographs("backs", 4);
    label("fronts/IMG_1.jpg", "OST1:B:ARM1-T3-0012-4:7F3K9Q2M");
    label("backs/IMG_2.jpg", "OST1:B:ARM1-T3-0012-4:7F3K9Q2M");
    label("backs/IMG_3.jpg", "https://example.org/ARM1-T3-0012-9");
    drop({disk_->filePath("fronts"), disk_->filePath("backs")});
    auto* ask = screen_->findChild<ImportAsk*>();
    QTRY_COMPARE(ask->place()->text(), QStringLiteral("ARM1-T3-0012-4"));
    QVERIFY(child<QLabel>("importLabels")->text().contains("names ARM1 / T3 / 0012 bag 4"));
    QCOMPARE(screen_->whereWords(), QStringLiteral("ARM1 / T3 / 0012 bag 4"));
    QVERIFY(ask->import()->isEnabled());
    // A person who types another is told.
    auto* edit = ask->place()->findChild<QLineEdit*>();
    edit->selectAll();
    QTest::keyClicks(edit, "ARM1-T3-0012-5");
    auto* doubt = child<MessagePanel>("importLabelDoubt");
    QVERIFY(doubt->isVisible());
    QVERIFY(doubt->words().contains("check the bag"));
    QVERIFY(!child<QLabel>("importLabels")->isVisible());
    // The next import's photographs have no label.
    photographs("series", 8);
    drop({disk_->filePath("series")});
    QTRY_VERIFY(ask->place()->text().isEmpty());
    QVERIFY(!child<QLabel>("importLabels")->isVisible());
    QVERIFY(!doubt->isVisible());
  }

  // Labels are read for seconds: what a person types meanwhile does not land in the bag.
  void aLabelThatIsReadLeavesTheCursorWhereItIs() {
    photographs("series", 8);
    drop({disk_->filePath("series")});
    auto* ask = screen_->findChild<ImportAsk*>();
    auto* marker = child<QDoubleSpinBox>("importMarker");
    QTRY_VERIFY(marker->isVisible());
    marker->setFocus();
    QVERIFY(marker->hasFocus());
    ask->takeCodes(
        {{disk_->filePath("series/IMG_0.jpg").toStdString(), {"OST1:B:ARM1-T3-0012-4:7F3K9Q2M"}}});
    QCOMPARE(ask->place()->text(), QStringLiteral("ARM1-T3-0012-4"));
    QVERIFY(marker->hasFocus());
  }

  void labelsOfTwoBagsOnTheTwoSidesAreADoubt() {
    photographs("fronts", 4);
    photographs("backs", 4);
    label("fronts/IMG_0.jpg", "OST1:B:ARM1-T3-0012-4:7F3K9Q2M");
    label("backs/IMG_0.jpg", "OST1:B:ARM1-T3-0012-5:8G4L0R3N");
    drop({disk_->filePath("fronts"), disk_->filePath("backs")});
    auto* doubt = child<MessagePanel>("importLabelDoubt");
    QTRY_VERIFY(doubt->isVisible());
    QVERIFY(doubt->words().contains("fronts names ARM1 / T3 / 0012 bag 4"));
    QVERIFY(doubt->words().contains("backs ARM1 / T3 / 0012 bag 5"));
    QVERIFY(screen_->findChild<ImportAsk*>()->place()->text().isEmpty());
  }

  void anImportThatIsRefusedComesBackToTheFilledPage() {
    photographs("up", 4);
    photographs("dn", 4);  // the same pictures
    QVERIFY(virtualrig::writePlateAndBoard(disk_->path().toStdString()).has_value());
    drop({disk_->filePath("up"), disk_->filePath("dn")});
    auto* ask = screen_->findChild<ImportAsk*>();
    QTRY_VERIFY(ask->isVisible());
    QTest::keyClicks(ask->place()->findChild<QLineEdit*>(), "ARM1-T3-0012-6");
    QTest::mouseClick(child<QPushButton>("importStart"), Qt::LeftButton);
    QTRY_VERIFY(shownMessage() != nullptr);
    QVERIFY(shownMessage()->words().contains("identical"));
    QVERIFY(ask->isVisible());
    QCOMPARE(ask->place()->text(), QStringLiteral("ARM1-T3-0012-6"));
    QVERIFY(child<QLabel>("importBack")->text().contains("4 photograph"));
    ask->leave();
    QVERIFY(shownMessage() == nullptr);
  }

  void whatImportsIsInSightOnASmallScreen() {
    photographs("series", 8);
    screen_->resize(900, 420);
    drop({disk_->filePath("series")});
    QTRY_VERIFY(screen_->findChild<ImportAsk*>()->isVisible());
    QTRY_VERIFY(screen_->findChild<RigPage*>()->isHidden());
    for (const char* name : {"importStart", "importReason"}) {
      auto* widget = child<QWidget>(name);
      QTRY_VERIFY2(
          screen_->rect().contains(QRect(widget->mapTo(screen_.get(), QPoint()), widget->size())),
          name);
    }
    screen_->findChild<ImportAsk*>()->leave();
    QVERIFY(!screen_->findChild<RigPage*>()->isHidden());
  }

  // A sheet that nobody described: its size is all that a person has to say of it.
  void theSheetIsFoundInThePhotographsWhenAMarkersSizeIsSaid() {
    virtualrig::SimulateOptions simulate;
    simulate.sherds = 1;
    simulate.width = 800;
    simulate.hand_held.emplace().photographs = 6;
    simulate.output = disk_->filePath("batch").toStdString();
    QuietProgress quiet;
    QVERIFY(virtualrig::simulateBatch(simulate, quiet, {}).has_value());
    const auto described = batch::readPlate(simulate.output / "plate.json");
    QVERIFY(described.has_value());
    const auto side = [](const batch::Plate& plate) {
      const auto& corners = plate.markers.front().corners;
      return (corners[1] - corners[0]).norm();
    };
    QVERIFY(std::filesystem::remove(simulate.output / "plate.json"));
    drop({disk_->filePath("batch/front"), disk_->filePath("batch/back")});
    auto* ask = screen_->findChild<ImportAsk*>();
    QTRY_VERIFY(ask->isVisible());
    auto* marker = child<QDoubleSpinBox>("importMarker");
    QVERIFY(marker->isVisible());
    QVERIFY(child<QLabel>("importSheet")->text().contains("no scale"));
    marker->setValue(side(*described));
    QVERIFY(child<QLabel>("importSheet")->text().contains("will be found"));
    QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
    QSignalSpy imported(screen_->importer(), &BatchImporter::imported);
    QTest::mouseClick(child<QPushButton>("importStart"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(imported.count(), 1, 60'000);
    QVERIFY(!imported[0][2].toStringList().join(' ').contains("plate.json"));  // all is well
    QVERIFY(imported[0][3].toString().contains("with a ruler"));
    QVERIFY(shownMessage() != nullptr && shownMessage()->words().contains("Sheet recognised"));
    QCOMPARE(wanted.count(), 0);  // it is to be read
    const auto found = batch::readPlate(session_->project().batchFolder("B0001") / "plate.json");
    QVERIFY(found.has_value());
    QVERIFY(found->markers.size() >= described->markers.size() / 2);
    QVERIFY(std::abs(side(*found) - side(*described)) < 0.02 * side(*described));
    // The next import proposes the size, and says so.
    drop({disk_->filePath("batch/front"), disk_->filePath("batch/back")});
    QTRY_VERIFY(ask->isVisible());
    QCOMPARE(marker->value(), side(*described));
    QVERIFY(child<QLabel>("importSheet")->text().contains("last import"));
    marker->setValue(marker->value() + 1);
    QVERIFY(!child<QLabel>("importSheet")->text().contains("last import"));
  }

  void aSheetFileThatWasUsedLastCanBeLeftOut() {
    photographs("fronts", 4);
    photographs("backs", 4);
    QVERIFY(virtualrig::writePlateAndBoard(disk_->path().toStdString()).has_value());
    drop({disk_->filePath("fronts"), disk_->filePath("backs")});
    QTRY_VERIFY(screen_->findChild<ImportAsk*>()->isVisible());
    QVERIFY(!child<QDoubleSpinBox>("importMarker")->isVisible());
    QTest::mouseClick(child<QPushButton>("importClearSheet"), Qt::LeftButton);
    QVERIFY(child<QDoubleSpinBox>("importMarker")->isVisible());
    QVERIFY(!child<QPushButton>("importClearSheet")->isVisible());
    QVERIFY(child<QLabel>("importSheet")->text().contains("no scale"));
  }

  void whatHoldsNoPhotographsIsSaidWhenItIsDropped() {
    QVERIFY(QDir(disk_->path()).mkdir("nothing"));
    drop({disk_->filePath("nothing")});
    QTRY_VERIFY(shownMessage() != nullptr);
    QVERIFY(shownMessage()->words().contains("no photographs") ||
            shownMessage()->headline().contains("no photographs"));
    QVERIFY(!screen_->findChild<ImportAsk*>()->isVisible());
  }

  void whatWasSaidOfOneImportGoesWithTheNext() {
    QVERIFY(QDir(disk_->path()).mkdir("nothing"));
    photographs("series", 8);
    drop({disk_->filePath("nothing")});
    QTRY_VERIFY(shownMessage() != nullptr);
    drop({disk_->filePath("series")});
    auto* ask = screen_->findChild<ImportAsk*>();
    QTRY_VERIFY(ask->isVisible());
    QVERIFY(shownMessage() == nullptr);
    drop({disk_->filePath("nothing")});
    QTRY_VERIFY(shownMessage() != nullptr);
    ask->leave();
    QVERIFY(shownMessage() == nullptr);
  }

 private:
  void photographs(const QString& folder, int count) {
    QVERIFY(QDir(disk_->path()).mkdir(folder));
    QImage image(800, 600, QImage::Format_RGB32);
    for (int i = 0; i < count; ++i) {
      image.fill(QColor::fromHsv(i * 40, 20 * static_cast<int>(folder.size()), 200));
      QVERIFY(image.save(disk_->filePath(QString("%1/IMG_%2.jpg").arg(folder).arg(i))));
    }
  }

  // A label with this code lies in a photograph.
  void label(const QString& photograph, const std::string& text) {
    cv::Mat code;
    cv::QRCodeEncoder::create()->encode(text, code);
    cv::resize(code, code, {}, 5, 5, cv::INTER_NEAREST);
    cv::copyMakeBorder(code, code, 30, 30, 30, 30, cv::BORDER_CONSTANT, 255);
    const std::string file = disk_->filePath(photograph).toStdString();
    cv::Mat picture = cv::imread(file, cv::IMREAD_GRAYSCALE);
    code.copyTo(picture(cv::Rect(100, 100, code.cols, code.rows)));
    QVERIFY(cv::imwrite(file, picture));
  }

  void drop(const QStringList& folders) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& folder : folders) urls << QUrl::fromLocalFile(folder);
    data.setUrls(urls);
    QVERIFY(screen_->acceptDrops());
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(screen_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(screen_.get(), &event);
  }

  std::unique_ptr<QTemporaryDir> disk_;
};

OSTRAKA_UI_TEST(CaptureImportTest)
#include "capture_import_test.moc"
