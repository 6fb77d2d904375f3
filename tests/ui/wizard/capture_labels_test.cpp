// The bag by its label, laid under the camera.
#include <QSignalSpy>
#include <QtTest>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "bench.h"
#include "records/records.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;
using records::BatchState;

namespace {

std::string pictureOfLabels(const std::vector<std::string>& texts) {
  cv::Mat picture;
  for (const std::string& text : texts) {
    cv::Mat code, label;
    cv::QRCodeEncoder::create()->encode(text, code);
    cv::resize(code, label, {}, 6, 6, cv::INTER_NEAREST);
    cv::copyMakeBorder(label, label, 80, 200, 90, 300, cv::BORDER_CONSTANT, 255);
    if (picture.empty())
      picture = label;
    else
      cv::hconcat(picture, label, picture);
  }
  std::vector<uchar> bytes;
  cv::imencode(".jpg", picture, bytes);
  return {bytes.begin(), bytes.end()};
}

std::string pictureOfLabel(const std::string& text) {
  return pictureOfLabels({text});
}

const char* const kLabel4 = "OST1:B:ARM1-T3-0012-4:7F3K9Q2M";
const char* const kLabel5 = "OST1:B:ARM1-T3-0012-5:8G4L0R3N";

}  // namespace

class CaptureLabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void aBagsLabelUnderTheCameraGivesThePlace() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.preview = pictureOfLabel(kLabel4);
    QSignalSpy read(bench.wizard.description(), &BatchDescription::placeRead);
    bench.wizard.pictures()->setLive(true);
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(read.count(), 1);
    QCOMPARE(bench.wizard.description()->place(), (PlaceText{"ARM1", "T3", "0012", "4"}));
    QCOMPARE(bench.wizard.description()->place().typed(), QStringLiteral("ARM1-T3-0012-4"));
    // What is typed now stays, though the label still lies there.
    bench.wizard.description()->setPlace(*readPlaceText("ARM1-T3-0013-1"));
    QSignalSpy looked(bench.wizard.pictures(), &PlatePictures::changed);
    QTRY_VERIFY(looked.count() >= 2);
    QCOMPARE(bench.wizard.description()->place().context, QStringLiteral("0013"));
    QCOMPARE(read.count(), 1);
    bench.wizard.pictures()->setLive(false);
  }

  // That of the bag before still lies at the edge of the plate.
  void ofTwoBagsLabelsNoneIsTaken() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.preview = pictureOfLabels({kLabel4, kLabel5});
    QSignalSpy read(bench.wizard.description(), &BatchDescription::placeRead);
    QSignalSpy said(bench.wizard.description(), &BatchDescription::said);
    bench.wizard.pictures()->setLive(true);
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_VERIFY(bench.wizard.pictures()->live().has_value());
    QCOMPARE(bench.wizard.pictures()->live()->codes.size(), 2);
    QSignalSpy looked(bench.wizard.pictures(), &PlatePictures::changed);
    QTRY_VERIFY(looked.count() >= 2);
    QCOMPARE(read.count(), 0);
    QVERIFY(bench.wizard.description()->place().isEmpty());
    QCOMPARE(said.count(), 1);
    QVERIFY(said[0][0].toString().contains("ARM1 / T3 / 0012 bag 4, ARM1 / T3 / 0012 bag 5"));
    bench.rig.preview = pictureOfLabel(kLabel5);
    QTRY_COMPARE(read.count(), 1);
    QCOMPARE(bench.wizard.description()->place().bag, QStringLiteral("5"));
  }

  void aLabelThatWasTakenAwayIsReadAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.preview = pictureOfLabel(kLabel4);
    bench.wizard.pictures()->setLive(true);
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    const auto photographAPlate = [&] {
      bench.goOn(CapturePhase::Flip);
      bench.wizard.next();
      QTRY_COMPARE(bench.batch().state, BatchState::Queued);
      bench.goOn(CapturePhase::Place);
    };
    const auto look = [&](int times) {
      const QSignalSpy looked(bench.wizard.pictures(), &PlatePictures::changed);
      QTRY_VERIFY(looked.count() >= times);
    };
    QTRY_COMPARE(bench.wizard.description()->place().bag, QStringLiteral("4"));
    bench.wizard.description()->setPlace(*readPlaceText("ARM1-T3-0099-1"));
    photographAPlate();
    look(2);  // it lies there all the time: nobody laid it there for this plate
    QCOMPARE(bench.wizard.description()->place().context, QStringLiteral("0099"));
    bench.rig.preview = pictureOfLabel("no label");
    look(6);
    photographAPlate();
    QCOMPARE(bench.wizard.description()->place().context, QStringLiteral("0099"));
    bench.rig.preview = pictureOfLabel(kLabel4);
    QTRY_COMPARE(bench.wizard.description()->place().context, QStringLiteral("0012"));
  }

  // The sherds of another bag were laid down where those of this batch should have been turned
  // over.
  void anotherBagsLabelBesideTheBacksIsADoubt() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.preview = pictureOfLabel(kLabel4);
    bench.wizard.pictures()->setLive(true);
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(bench.wizard.description()->place().bag, QStringLiteral("4"));
    bench.goOn(CapturePhase::Flip);
    QVERIFY(bench.wizard.doubts().isEmpty());
    bench.rig.preview = pictureOfLabel(kLabel5);
    QTRY_COMPARE(bench.wizard.doubts().size(), 1);
    QVERIFY(bench.wizard.doubts()[0].contains("names ARM1 / T3 / 0012 bag 5"));
    QVERIFY(bench.wizard.doubts()[0].contains("of ARM1 / T3 / 0012 bag 4"));
    QCOMPARE(bench.wizard.description()->place().bag, QStringLiteral("4"));
    // Nor is another bag's sherd photographed as a front by one key.
    bench.wizard.again();
    QVERIFY(bench.wizard.asksToRepeat());
    QCOMPARE(bench.wizard.phase(), CapturePhase::Flip);
    bench.wizard.keepPhotographs();
    QCOMPARE(bench.wizard.doubts().size(), 1);
    // Both lie there: the bag's own is one of them.
    bench.rig.preview = pictureOfLabels({kLabel4, kLabel5});
    QTRY_VERIFY(bench.wizard.doubts().isEmpty());
    bench.rig.preview = pictureOfLabel(kLabel5);
    QTRY_COMPARE(bench.wizard.doubts().size(), 1);
    // Who goes on all the same is asked before the batch goes into the queue.
    bench.goOn(CapturePhase::Done);
    QCOMPARE(bench.wizard.doubts().size(), 1);
    QVERIFY(!bench.wizard.isQueued());
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QVERIFY(bench.wizard.doubts().isEmpty());
  }

  void aDoubtAboutTheLabelGoesWithTheLabelOrWithTheBag() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.wizard.description()->setPlace(*readPlaceText("ARM1-T3-0012-4"));
    bench.rig.preview = pictureOfLabel("no label");
    bench.wizard.pictures()->setLive(true);
    bench.toFlip();
    const auto layDown = [&](const std::string& picture) { bench.rig.preview = picture; };
    layDown(pictureOfLabel(kLabel5));
    QTRY_COMPARE(bench.wizard.doubts().size(), 1);
    layDown(pictureOfLabel("no label"));  // it was the wrong bag's, and was taken away
    QTRY_VERIFY(bench.wizard.doubts().isEmpty());
    layDown(pictureOfLabel(kLabel5));
    QTRY_COMPARE(bench.wizard.doubts().size(), 1);
    bench.wizard.description()->setPlace(*readPlaceText("arm1-T3-0012-5"));  // the bag was wrong
    QVERIFY(bench.wizard.doubts().isEmpty());
  }

  void aBatchWithoutABagTakesTheLabelBesideItsBacks() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.preview = pictureOfLabel("no label");
    bench.wizard.pictures()->setLive(true);
    bench.toFlip();
    QVERIFY(bench.wizard.description()->place().isEmpty());
    bench.rig.preview = pictureOfLabel(kLabel5);
    QTRY_COMPARE(bench.wizard.description()->place().bag, QStringLiteral("5"));
    QVERIFY(bench.wizard.doubts().isEmpty());
  }

  void anyOtherCodeIsNoPlace() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.preview = pictureOfLabel("https://example.org/ARM1-T3-0012-4");
    bench.wizard.pictures()->setLive(true);
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_VERIFY(bench.wizard.pictures()->live().has_value());
    QCOMPARE(bench.wizard.pictures()->live()->codes.size(), 1);
    QVERIFY(bench.wizard.description()->place().isEmpty());
    bench.wizard.pictures()->setLive(false);
  }

 private:
  std::filesystem::path folder() const {
    return std::filesystem::path(folder_->path().toStdString()) / "project";
  }
  std::unique_ptr<QTemporaryDir> folder_;
};

OSTRAKA_UI_TEST(CaptureLabelsTest)
#include "capture_labels_test.moc"
