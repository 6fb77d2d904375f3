// What is sherd on a photograph is shown and edited with a brush, by mouse and by keys.
#include "ui/masks/mask_page.h"

#include <sys/resource.h>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUndoStack>

#include <QtTest>
#include <csignal>
#include <filesystem>

#include "../names.h"
#include "../project_in.h"
#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "decisions/mask_strokes.h"
#include "files/files.h"
#include "review/review.h"
#include "synthetic_out.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/job.h"
#include "ui/masks/mask_model.h"
#include "ui/masks/mask_view.h"

using namespace ostraka;
using namespace ostraka::ui;
namespace fs = std::filesystem;

// A limit on file sizes fails a write as a full disk does.
class NoRoom {
 public:
  NoRoom() {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    struct rlimit full = before_;
    full.rlim_cur = 16;
    setrlimit(RLIMIT_FSIZE, &full);
  }
  ~NoRoom() { setrlimit(RLIMIT_FSIZE, &before_); }
  NoRoom(const NoRoom&) = delete;
  NoRoom& operator=(const NoRoom&) = delete;

 private:
  struct rlimit before_ {};
};

class MaskPageTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    const fs::path project = folder_->path().toStdString();
    out_ = project / "results" / "B0001";
    const pipeline::SyntheticOut made = pipeline::writeSyntheticOut(out_, {});
    // As in a project the photographs lie in the batch's own folder.
    fs::create_directories(project / "batches" / "B0001");
    fs::copy(out_ / "photographs", project / "batches" / "B0001" / "photographs");
    session_ = std::make_unique<ProjectSession>(nullptr, project, jobs_);
    session_->setInitials("AP");
    page_ = std::make_unique<MaskPage>();
    page_->resize(1000, 700);
    page_->show();
    page_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(page_.get()));
    page_->openBatch(*session_, "B0001");
    model_ = page_->findChild<MaskModel*>();
    view_ = page_->findChild<MaskView*>("maskView");
    QTRY_VERIFY_WITH_TIMEOUT(!model_->overlay().isNull(), 20000);
  }
  void cleanup() {
    page_.reset();
    session_.reset();
  }

  void eachControlHasANameForScreenReaders() {
    const QStringList nameless = namelessIn(*page_);
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join('\n')));
  }

  void aStrokeOfTheMouseIsSavedAtOnceAndUndone() {
    const QPoint plate = outsideOfSherds();
    QCOMPARE(qAlpha(model_->overlay().pixel(plate)), 0);
    const QPoint at = view_->placeOf(plate).toPoint();
    QTest::mousePress(view_, Qt::LeftButton, {}, at);
    QTest::mouseMove(view_, at + QPoint(12, 0));
    QTest::mouseRelease(view_, Qt::LeftButton, {}, at + QPoint(12, 0));
    const auto saved = decisions::readMaskStrokes(out_);
    QVERIFY(saved.has_value());
    QCOMPARE(saved->size(), std::size_t{1});
    QCOMPARE(saved->front().by, std::string("AP"));
    QCOMPARE(saved->front().side, batch::Side::Front);
    QVERIFY(saved->front().paint == decisions::MaskPaint::Sherd);
    QVERIFY(qAlpha(model_->overlay().pixel(plate)) > 0);
    QCOMPARE(model_->edited(), 1);
    session_->undo().undo();
    QVERIFY(decisions::readMaskStrokes(out_)->empty());
    QCOMPARE(qAlpha(model_->overlay().pixel(plate)), 0);
    session_->undo().redo();
    QCOMPARE(decisions::readMaskStrokes(out_)->size(), std::size_t{1});
    QVERIFY(qAlpha(model_->overlay().pixel(plate)) > 0);
  }

  void aBatchThatWasDoneWantsComputingUntilTheStrokeIsTakenBack() {
    const fs::path project = fs::path(folder_->path().toStdString()) / "project";
    const auto made = projectIn(project);
    fs::create_directories(project / "results");
    fs::copy(out_, project / "results" / "B0001", fs::copy_options::recursive);
    // A run that has followed what was painted and decided so far: nothing.
    QVERIFY(writeFileAtomically(project / "results/B0001/report.json",
                                R"({"decisions":[],"stages":[]})")
                .has_value());
    records::BatchRecord batch;
    batch.number = "B0001";
    batch.state = records::BatchState::Done;
    QVERIFY(catalogue::Batches(made->catalogue()).add(batch, {}).has_value());
    ProjectSession session(made, project, jobs_);
    session.setInitials("AP");
    const auto state = [&] {
      return catalogue::Batches(session.project().catalogue()).byNumber("B0001")->state;
    };
    const bool asks = review::loadReview(project / "results" / "B0001")->waiting() > 0;
    const auto settled = asks ? records::BatchState::Review : records::BatchState::Done;
    QSignalSpy told(&session, &ProjectSession::batchChanged);
    page_->openBatch(session, "B0001");
    QTRY_VERIFY_WITH_TIMEOUT(!model_->overlay().isNull(), 20000);
    model_->paint(decisions::MaskPaint::Plate, QPolygonF{{10, 10}, {30, 30}}, 8);
    QTRY_COMPARE(state(), records::BatchState::Review);
    QVERIFY(decisions::masksWantComputing(project / "results" / "B0001"));
    QTRY_VERIFY(told.count() > 0);
    page_->closeBatch();  // and an undo from another page reaches the file, too
    session.undo().undo();
    QVERIFY(!decisions::masksWantComputing(project / "results" / "B0001"));
    QTRY_COMPARE(state(), settled);
    // A merge reads there that nobody wants the stroke any more.
    const catalogue::Catalogue& rows = session.project().catalogue();
    const auto told_of =
        catalogue::History(rows).of("batch", catalogue::Batches(rows).byNumber("B0001")->row.value);
    QVERIFY(told_of.has_value());
    QVERIFY(std::any_of(told_of->begin(), told_of->end(), [](const auto& entry) {
      return entry.field.starts_with(decisions::kStrokesField);
    }));
  }

  void theKeysMoveTheBrushAndPaintPlate() {
    const QPoint sherd = onASherd();
    QTest::mouseMove(view_, view_->placeOf(sherd).toPoint());
    QTest::keyClick(page_.get(), Qt::Key_P);
    QTRY_VERIFY(page_->findChild<QAction*>("masksPlate")->isChecked());
    QTest::keyClick(view_, Qt::Key_Space);
    const auto saved = decisions::readMaskStrokes(out_);
    QCOMPARE(saved->size(), std::size_t{1});
    QVERIFY(saved->front().paint == decisions::MaskPaint::Plate);
    const Eigen::Vector2d first = saved->front().path_px.front();
    QCOMPARE(qAlpha(model_->overlay().pixel(qRound(first.x()), qRound(first.y()))), 0);
    QTest::keyClick(view_, Qt::Key_Right);
    QTest::keyClick(view_, Qt::Key_Space);
    const Eigen::Vector2d second = decisions::readMaskStrokes(out_)->back().path_px.front();
    QVERIFY(second.x() > first.x());
    QCOMPARE(second.y(), first.y());
  }

  void aStrokeOnAPhotographThatWasTakenAgainHoldsNoMore() {
    const QPoint plate = outsideOfSherds();
    model_->paint(decisions::MaskPaint::Sherd, QPolygonF{{plate}}, 8);
    QVERIFY(qAlpha(model_->overlay().pixel(plate)) > 0);
    QCOMPARE(model_->edited(), 1);
    const fs::path now = fs::path(folder_->path().toStdString()) / "batches/B0001/photographs";
    const auto again = readFile(now / "back.png");
    QVERIFY(again.has_value());
    QVERIFY(writeFileAtomically(now / "front.png", *again).has_value());
    page_->openBatch(*session_, "B0001");
    QTRY_VERIFY_WITH_TIMEOUT(!model_->overlay().isNull(), 20000);
    QCOMPARE(qAlpha(model_->overlay().pixel(plate)), 0);
    QCOMPARE(model_->edited(), 0);
    QCOMPARE(decisions::readMaskStrokes(out_)->size(), std::size_t{1});
  }

  // As when the file of strokes cannot be written at one act, and can at the next.
  void aStrokeThatCouldNotBeTakenBackCanBeTakenBackLater() {
    const QSignalSpy failed(model_, &MaskModel::failed);
    for (const double x : {20.0, 60.0})
      model_->paint(decisions::MaskPaint::Sherd, QPolygonF{{x, 20.0}}, 8);
    {
      const NoRoom no_room;
      session_->undo().undo();
      QCOMPARE(failed.count(), 1);
      QCOMPARE(decisions::readMaskStrokes(out_)->size(), std::size_t{2});
      QTRY_COMPARE(session_->undo().index(), 2);
    }
    const auto at = [&](std::size_t i) {
      return decisions::readMaskStrokes(out_)->at(i).path_px.front().x();
    };
    QCOMPARE(decisions::readMaskStrokes(out_)->size(), std::size_t{2});
    session_->undo().undo();
    QCOMPARE(decisions::readMaskStrokes(out_)->size(), std::size_t{1});
    QCOMPARE(at(0), 20.0);
    session_->undo().undo();
    QVERIFY(decisions::readMaskStrokes(out_)->empty());
  }

  void theNextPhotographIsOneKeyAway() {
    QVERIFY(model_->count() >= 2);
    auto* which = page_->findChild<QComboBox*>("masksWhich");
    QCOMPARE(which->currentText(), QStringLiteral("front, front.png"));
    QTest::keyClick(page_.get(), Qt::Key_PageDown);
    QTRY_VERIFY_WITH_TIMEOUT(model_->index() == 1 && !model_->overlay().isNull(), 20000);
    QCOMPARE(which->currentText(), QStringLiteral("back, back.png"));
    QTest::keyClick(page_.get(), Qt::Key_PageUp);
    QTRY_COMPARE(model_->index(), 0);
  }

  void computingIsOfferedWhenThereIsAStroke() {
    const QSignalSpy wanted(page_.get(), &MaskPage::computeWanted);
    auto* compute = page_->findChild<QAction*>("masksCompute");
    QVERIFY(!compute->isEnabled());
    QTest::keyClick(view_, Qt::Key_Space);
    QVERIFY(compute->isEnabled());
    QTest::mouseClick(page_->findChild<QPushButton*>("masksComputeButton"), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().toString(), QStringLiteral("B0001"));
    session_->undo().undo();
    QVERIFY2(!compute->isEnabled(), "the masks are those that were computed");
  }

  void inANarrowWindowTheArrowsAndTheWayBackStayInSight() {
    page_->resize(700, 500);
    for (const char* name : {"masksPreviousButton", "masksNextButton", "masksBackButton"}) {
      const auto* button = page_->findChild<QToolButton*>(name);
      QVERIFY2(button != nullptr && button->isVisible(), name);
      QVERIFY2(page_->rect().contains(QRect(button->mapTo(page_.get(), QPoint()), button->size())),
               name);
    }
  }

  void theWheelEnlargesAboutThePointer() {
    const QPoint at = view_->placeOf(onASherd()).toPoint();
    const QPointF before = view_->placeOf({0, 0});
    QWheelEvent wheel(at, view_->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view_, &wheel);
    QVERIFY(QLineF(view_->placeOf({0, 0}), at).length() > QLineF(before, at).length());
    QVERIFY(QLineF(view_->placeOf(onASherd()), at).length() < 2);
  }

  void aBatchWithoutMasksSaysSo() {
    page_->openBatch(*session_, "B0002");
    auto* told = page_->findChild<QLabel*>("masksTold");
    QTRY_VERIFY_WITH_TIMEOUT(!told->text().isEmpty(), 20000);
    QCOMPARE(model_->count(), 0);
    QTest::keyClick(view_, Qt::Key_Space);  // nothing to paint on
    QVERIFY(!fs::exists(folder_->path().toStdString() + "/results/B0002/mask_strokes.json"));
  }

 private:
  QPoint pixelWith(bool overlaid) {
    const QImage& overlay = model_->overlay();
    for (int y = 40; y < overlay.height() - 40; y += 4)
      for (int x = 40; x < overlay.width() - 40; x += 4) {
        bool all = true;
        for (int dy = -20; dy <= 20; dy += 10)
          for (int dx = -20; dx <= 20; dx += 10)
            all = all && (qAlpha(overlay.pixel(x + dx, y + dy)) > 0) == overlaid;
        if (all) return {x, y};
      }
    qFatal("there is no such place");
  }
  QPoint onASherd() { return pixelWith(true); }
  QPoint outsideOfSherds() { return pixelWith(false); }

  ThreadedJobRunner jobs_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<MaskPage> page_;
  MaskModel* model_ = nullptr;
  MaskView* view_ = nullptr;
  fs::path out_;
};

OSTRAKA_UI_TEST(MaskPageTest)
#include "mask_page_test.moc"
