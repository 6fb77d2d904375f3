// The plate map without a screen: marks, keys, mouse, and the printed pages.
#include <QAbstractButton>
#include <QDateTime>
#include <QLabel>
#include <QPainter>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "../project_in.h"
#include "catalogue/batches.h"
#include "files/files.h"
#include "synthetic_out.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/map/map_screen.h"
#include "ui/map/map_view.h"
#include "ui/map/qr_code.h"
#include "ui/widgets/message_panel.h"

namespace ostraka::ui {

class MapTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void everySherdHasItsNumberOnBothSides();
  void aDoubtfulPairShowsBothNumbers();
  void arrowKeysAndMouseLightTheSameSherdOnBothSides();
  void whatWasDecidedIsSeenAtOnce();
  void theQrCodeIsAsSmallAsTheStandardSays();
  void mapAndLabelsAreWrittenAsPdf();
  void whatWasTakenOutKeepsItsNumberOnBothSides();
  void whatIsOnItsWaySaysSoAndIsNotPrinted();
  void whatNobodyLooksAtIsNotRead();
  void theLabelSaysTheDayOfTheShooting();
  void itFollowsTheBatchOfTheScreenBefore();
  void aPrintedFileIsNamedAfterItsBatch();
  void aMissingPhotographIsSaid();
  void aBatchOfScansSaysThatItHasNoPicture();
  void theFirstBatchTakesTheMessageAway();
  void whileABatchIsProcessedTheEmptyMapLeadsToTheQueue();
  void noNumberCoversAnother();
  void noNumberHidesASmallSherd();

 private:
  const review::PlateMap& map() { return view()->picture().map; }
  MapView* view() { return screen_->findChild<MapView*>("plate"); }

  QTemporaryDir folder_;
  pipeline::SyntheticOut out_;
  class CountingRunner final : public JobRunner {
   public:
    int started = 0;

   private:
    void run(JobPriority, std::function<void()> body, std::stop_source,
             JobHandle* handle) override {
      ++started;
      QMetaObject::invokeMethod(handle, std::move(body), Qt::QueuedConnection);
    }
  } runner_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<MapScreen> screen_;
};

void MapTest::initTestCase() {
  out_ = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/results/B0007", {});
}

void MapTest::init() {
  session_ = std::make_unique<ProjectSession>(nullptr, folder_.path().toStdString(), runner_);
  screen_ = std::make_unique<MapScreen>();
  screen_->resize(1000, 500);
  screen_->show();
  screen_->openProject(*session_);
  QTRY_VERIFY(map().front.width > 0);
}

void MapTest::cleanup() {
  screen_.reset();
  session_.reset();
  std::filesystem::remove(out_.output / "decisions.json");
}

void MapTest::everySherdHasItsNumberOnBothSides() {
  QCOMPARE(map().front.marks.size(), std::size_t{4});
  QCOMPARE(map().back.marks.size(), std::size_t{4});
  QCOMPARE(map().front.marks[2].number, std::string("03"));
  QCOMPARE(map().back.marks[2].number, std::string("03"));
  // Seen from 600 mm above with f = 3000 px: the third sherd lies at x = 0, y = 60 mm.
  QVERIFY(std::abs(map().front.marks[2].at.x() - 600) < 10);
  QVERIFY(std::abs(map().front.marks[2].at.y() - (500 - 60 * 5)) < 10);
}

void MapTest::whatIsOnItsWaySaysSoAndIsNotPrinted() {
  QVERIFY(screen_->primary()->isEnabled());
  QVERIFY(screen_->primary()->toolTip().isEmpty());
  screen_->openProject(*session_);
  QCOMPARE(map().front.width, 0);
  QCOMPARE(view()->accessibleDescription(), QStringLiteral("Loading…"));
  QVERIFY(!screen_->primary()->isEnabled());
  QVERIFY(screen_->primary()->toolTip().contains("loading"));
  QTRY_VERIFY(map().front.width > 0);
  QVERIFY(view()->accessibleDescription().isEmpty());
  QVERIFY(screen_->primary()->isEnabled());
}

void MapTest::aDoubtfulPairShowsBothNumbers() {
  const review::MapMark& back = map().back.marks[0];  // the program gives it to f002
  QCOMPARE(back.number, std::string("02"));
  QCOMPARE(back.other_number, std::string("01"));
  QVERIFY(map().back.marks[3].other_number.empty());
}

void MapTest::arrowKeysAndMouseLightTheSameSherdOnBothSides() {
  QSignalSpy lit(view(), &MapView::highlightedChanged);
  QTest::keyClick(view(), Qt::Key_Right);
  QCOMPARE(view()->highlighted(), QStringLiteral("01"));
  QTest::keyClick(view(), Qt::Key_Left);
  QCOMPARE(view()->highlighted(), QStringLiteral("04"));
  const QImage with = view()->grab().toImage();
  view()->highlight({});
  const QImage without = view()->grab().toImage();
  int left = 0, right = 0;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x)
      (x < with.width() / 2 ? left : right) += with.pixel(x, y) != without.pixel(x, y);
  QVERIFY(left > 300 && right > 300);
  // The mouse over the third sherd: the photograph of 1200 x 1000 fills the height of its half.
  const double line = 1.4 * view()->fontMetrics().height();
  const QRectF half(0, line, view()->width() / 2.0 - 2, view()->height() - line);
  const QRectF place = mapPlace(half, map().front);
  const QPointF at =
      place.topLeft() +
      place.width() / 1200 * QPointF(map().front.marks[2].at.x(), map().front.marks[2].at.y());
  QTest::mouseMove(view(), at.toPoint());
  QTRY_COMPARE(view()->highlighted(), QStringLiteral("03"));
  QVERIFY(lit.count() >= 4);
}

void MapTest::whatWasDecidedIsSeenAtOnce() {
  decisions::PairDecision decision;
  decision.kind = decisions::DecisionKind::Pair;
  decision.by = "AP";
  decision.scans = {out_.table.fronts[0], out_.table.backs[0]};
  QVERIFY(decisions::appendDecision(out_.output, decision).has_value());
  session_->tellBatchChanged("B0007");
  QTRY_COMPARE(map().back.marks[0].number, std::string("01"));
}

void MapTest::whatWasTakenOutKeepsItsNumberOnBothSides() {
  decisions::PairDecision decision;
  decision.kind = decisions::DecisionKind::Reshoot;
  decision.by = "AP";
  decision.scans = {out_.table.fronts[2], out_.table.backs[2]};
  QVERIFY(decisions::appendDecision(out_.output, decision).has_value());
  session_->tellBatchChanged("B0007");
  QTRY_COMPARE(map().front.marks[2].state, review::CardState::Reshoot);
  QCOMPARE(map().front.marks[2].number, std::string("03"));
  QCOMPARE(map().back.marks[2].number, std::string("03"));
  MapNumbers numbers;
  QCOMPARE(wordsOf(map().back.marks[2], numbers), QStringLiteral("shoot again"));
  numbers.endings = {{"03", "0007"}};
  QCOMPARE(wordsOf(map().back.marks[2], numbers), QStringLiteral("0007, shoot again"));
  QCOMPARE(screen_->labels().size(), 3);  // no number outside this batch
}

void MapTest::whatNobodyLooksAtIsNotRead() {
  decisions::PairDecision decision;
  decision.kind = decisions::DecisionKind::Pair;
  decision.by = "AP";
  decision.scans = {out_.table.fronts[0], out_.table.backs[0]};
  screen_->hide();
  const int before = runner_.started;
  QVERIFY(decisions::appendDecision(out_.output, decision).has_value());
  for (int i = 0; i < 3; ++i) session_->tellBatchChanged("B0007");
  QCOMPARE(runner_.started, before);
  screen_->show();
  QCOMPARE(runner_.started, before + 1);
  QTRY_COMPARE(map().back.marks[0].number, std::string("01"));
}

void MapTest::theLabelSaysTheDayOfTheShooting() {
  const auto project = projectIn(folder_.filePath("p").toStdString(), "ARM");
  records::BatchRecord batch;
  batch.number = "B0007";
  batch.state = records::BatchState::Review;
  batch.started_ms = QDateTime(QDate(2019, 7, 14), QTime(12, 0)).toMSecsSinceEpoch();
  QVERIFY(catalogue::Batches(project->catalogue()).add(batch, {}).has_value());
  ProjectSession dated(project, folder_.path().toStdString(), runner_);
  screen_->openProject(dated);
  QTRY_VERIFY(!screen_->labels().isEmpty());
  QCOMPARE(screen_->labels()[2].date, QStringLiteral("2019-07-14"));
  screen_->closeProject();
}

void MapTest::theQrCodeIsAsSmallAsTheStandardSays() {
  // 30 characters of the alphanumeric set at level M: version 2, 25 modules.
  const QImage code = qrCode("OST1:S:ARM1-T3-0012-0007:7F3K9Q2M");
  QCOMPARE(code.size(), QSize(25, 25));
  // The three finders are dark rings of seven modules.
  for (const QPoint& corner : {QPoint(0, 0), QPoint(18, 0), QPoint(0, 18)})
    for (int i = 0; i < 7; ++i) {
      QCOMPARE(qGray(code.pixel(corner + QPoint(i, 0))), 0);
      QCOMPARE(qGray(code.pixel(corner + QPoint(0, i))), 0);
    }
  QCOMPARE(qGray(code.pixel(1, 1)), 255);
  QVERIFY(qrCode(QString(5000, 'A')).isNull());
}

void MapTest::mapAndLabelsAreWrittenAsPdf() {
  const QVector<SherdLabel> labels = screen_->labels();
  QCOMPARE(labels.size(), 4);
  QCOMPARE(labels[2].number, QStringLiteral("sherd 3 of B0007"));
  QCOMPARE(labels[2].code, QStringLiteral("OST1:S:B0007-03"));
  QString why;
  const auto write = [&](const QString& file) {
    QPdfWriter device(file);
    device.setResolution(300);
    return printMap(device, view()->picture(), labels, "Batch B0007", &why);
  };
  const QString file = folder_.filePath("map.pdf");
  QVERIFY(write(file));
  QFile pdf(file);
  QVERIFY(pdf.open(QIODevice::ReadOnly));
  const QByteArray bytes = pdf.readAll();
  QVERIFY(bytes.startsWith("%PDF"));
  QVERIFY(bytes.size() > 20000);
  QCOMPARE(bytes.count("/Type /Page\n"), 2);
  QVERIFY(!write(folder_.filePath("no such folder/map.pdf")));
  QVERIFY(!why.isEmpty());
}

void MapTest::itFollowsTheBatchOfTheScreenBefore() {
  const std::filesystem::path results = out_.output.parent_path();
  std::filesystem::copy(out_.output, results / "B0006", std::filesystem::copy_options::recursive);
  session_->tellBatchChanged("B0006");
  QCOMPARE(screen_->chosen(), QStringLiteral("plate:B0007"));
  screen_->takeChosen("plate:B0006");
  QCOMPARE(screen_->chosen(), QStringLiteral("plate:B0006"));
  QTRY_VERIFY(!screen_->labels().isEmpty() && screen_->labels()[0].number.endsWith("B0006"));
  screen_->takeChosen("plate:B0099");  // is not computed
  screen_->takeChosen("context:0012");
  QCOMPARE(screen_->chosen(), QStringLiteral("plate:B0006"));
  std::filesystem::remove_all(results / "B0006");
}

// Or the map would go over the labels of the bags.
void MapTest::aPrintedFileIsNamedAfterItsBatch() {
  screen_->findChild<QAbstractButton*>("printMap")->click();
  auto* dialog = screen_->findChild<QPrintDialog*>();
  QVERIFY(dialog != nullptr);
  QVERIFY2(dialog->printer()->docName().startsWith("B0007"),
           qPrintable(dialog->printer()->docName()));
  dialog->close();
}

void MapTest::aMissingPhotographIsSaid() {
  const auto photograph = out_.output / "photographs" / "back.png";
  std::filesystem::rename(photograph, photograph.string() + ".away");
  session_->tellBatchChanged("B0007");
  QTRY_VERIFY(view()->picture().back.isNull());
  QVERIFY(!view()->grab().isNull());
  QCOMPARE(map().back.marks.size(), std::size_t{4});
  std::filesystem::rename(photograph.string() + ".away", photograph);
}

void MapTest::aBatchOfScansSaysThatItHasNoPicture() {
  const std::filesystem::path folder = folder_.path().toStdString();
  const auto scans = folder / "results" / "B0009";
  std::filesystem::copy(out_.output, scans, std::filesystem::copy_options::recursive);
  QVERIFY(std::filesystem::remove(scans / "work" / "rig" / "cameras.json"));
  QVERIFY(writeFileAtomically(folder / "batches" / "B0009" / "front" / "a.ply", "ply").has_value());
  session_->tellBatchChanged("B0009");
  screen_->showItem("B0009");
  const auto* message = screen_->findChild<QLabel*>("message");
  QTRY_VERIFY2(message->text().startsWith("This batch was scanned"), qPrintable(message->text()));
  std::filesystem::remove_all(scans);
}

void MapTest::theFirstBatchTakesTheMessageAway() {
  const QTemporaryDir empty;
  const std::filesystem::path folder = empty.path().toStdString();
  ProjectSession fresh(nullptr, folder, runner_);
  QSignalSpy said(screen_.get(), &Screen::said);
  screen_->openProject(fresh);
  auto* message = screen_->findChild<QLabel*>("message");
  const auto* no_map = screen_->findChild<EmptyState*>();
  QVERIFY(!no_map->isHidden());
  QCOMPARE(said.count(), 0);  // the window's foot is for the screen in front
  pipeline::writeSyntheticOut(folder / "results" / "B0001", {});
  fresh.tellBatchChanged("B0001");
  QTRY_VERIFY(map().front.width > 0);
  QVERIFY(no_map->isHidden());
  QVERIFY2(message->text().isEmpty(), qPrintable(message->text()));
  screen_->closeProject();
}

void MapTest::whileABatchIsProcessedTheEmptyMapLeadsToTheQueue() {
  const QTemporaryDir empty;
  const std::filesystem::path folder = empty.path().toStdString() + "/project";
  const auto project = projectIn(folder);
  ProjectSession fresh(project, folder, runner_);
  QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
  screen_->openProject(fresh);
  QAbstractButton* act = screen_->primary();
  act->click();
  QCOMPARE(wanted.takeLast().first().toString(), QString("capture"));
  const auto said = [&](records::BatchState state) {
    catalogue::Batches batches(project->catalogue());
    if (auto batch = batches.byNumber("B0001")) {
      batch->state = state;
      (void)batches.save(*batch, {});
    } else {
      records::BatchRecord added;
      added.number = "B0001";
      added.state = state;
      (void)batches.add(added, {});
    }
    fresh.tellBatchChanged("B0001");
    act->click();
    QStringList words;
    for (const auto* label : screen_->findChild<EmptyState*>()->findChildren<QLabel*>())
      words << label->text();
    return wanted.takeLast().first().toString() + ": " + words.join(' ');
  };
  QVERIFY(said(records::BatchState::Front).startsWith("capture"));
  const QString queued = said(records::BatchState::Queued);
  QVERIFY2(queued.startsWith("queue") && queued.contains("B0001 is in the queue"),
           qPrintable(queued));
  const QString failed = said(records::BatchState::Failed);
  QVERIFY2(failed.startsWith("queue") && failed.contains("B0001 could not be processed"),
           qPrintable(failed));
  screen_->closeProject();
}

void MapTest::noNumberHidesASmallSherd() {
  const QRectF within(0, 0, 400, 300);
  std::vector<NumberToPlace> numbers;
  for (const double y : {140., 175.}) {  // one above the other
    const QRectF box(185, y, 30, 25);
    numbers.push_back({{150, 20}, box.center(), QPolygonF(box)});
  }
  const std::vector<QRectF> grounds = placeNumbers(numbers, within);
  for (const QRectF& ground : grounds)
    for (const NumberToPlace& number : numbers)
      QVERIFY(!ground.intersects(number.outline.boundingRect()));
}

void MapTest::noNumberCoversAnother() {
  const QRectF within(0, 0, 400, 300);
  std::vector<NumberToPlace> numbers;
  const auto add = [&](double x, double y, double wide, double length) {
    const QRectF box(x - wide / 2, y - wide / 2, wide, wide);
    numbers.push_back({{length, 20}, {x, y}, QPolygonF(box)});
  };
  add(300, 200, 120, 50);                                            // with room on the sherd
  for (int i = 0; i < 6; ++i) add(100 + i % 3, 80 + i / 3, 30, 90);  // scans that overlap
  add(395, 5, 10, 80);                                               // in the corner
  const std::vector<QRectF> grounds = placeNumbers(numbers, within);
  QCOMPARE(grounds.size(), numbers.size());
  QCOMPARE(grounds[0].center(), QPointF(300, 200));
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    QCOMPARE(grounds[i].size(), numbers[i].size);
    QVERIFY(within.contains(grounds[i]));
    for (std::size_t j = 0; j < i; ++j) QVERIFY(!grounds[i].intersects(grounds[j]));
  }
}

OSTRAKA_UI_TEST(MapTest)

}  // namespace ostraka::ui

#include "map_test.moc"
