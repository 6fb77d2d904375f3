// What a person does in the review, in a real window with real jobs.
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <fstream>

#include "../names.h"
#include "catalogue/piece_decisions.h"
#include "catalogue/project.h"
#include "synthetic_out.h"
#include "ui/frame/look.h"
#include "ui/frame/project_session.h"
#include "ui/queue/batch_queue.h"
#include "ui/review/card_delegate.h"
#include "ui/review/pair_review_model.h"
#include "ui/review/picture_pair.h"
#include "ui/review/review_pane.h"
#include "ui/review/review_station.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

using pipeline::CardState;

class ReviewWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup();
  void swappedLookAlikesAreFixedByKeyboard();
  void swappedLookAlikesAreFixedByMouse();
  void twentyPairsAreReviewedByKeyboardAlone();
  void theKeysOfThePictureWork();
  void aPieceIsCutByKeyboard();
  void aBackThatNoFrontHoldsHasACardOfItsOwn();
  void aLoneBackIsDraggedOntoItsFront();
  void piecesOfTheBackAreJoinedByKeyboardAndByMouse();
  void theQueueFollowsWhatIsDecided();
  void whatIsOnlyConfirmedNeedsNoComputing();
  void aBatchOfDoubtfulScaleSaysSoAboveItsPairs();
  void nothingIsDecidedWhileAnotherBatchOpens();
  void aBatchThatDoesNotOpenLeavesNoPairsToDecideOn();
  void whatDecidesIsInSightHoweverLargeTheLetters();
  void everyControlHasAName();

 private:
  void open(int sherds, bool with_project = false);
  void enterBatch(catalogue::Project& project, int sherds, const std::string& number = "B0001");
  pipeline::SyntheticOut addBatch(const std::string& number);
  std::size_t entered(const std::string& number);
  QString shown() {
    if (!model()->isOpen()) return {};
    return QString::fromStdString(model()->live()->output().filename().string());
  }
  void click(int row, bool on_back = false);
  void drag(int from_row, int to_row);
  catalogue::BatchState batchState() {
    return session_->project().catalogue().batchByNumber("B0001")->state;
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    // For a moment nothing has it: the window manager is still busy with the window.
    QTRY_VERIFY(QApplication::focusWidget() != nullptr);
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }
  const pipeline::ReviewCard& cardOf(int front) { return *model()->review().ofFront(front); }
  PairReviewModel* model() { return station_->model(); }
  pipeline::Decisions standingOnDisk() {
    return pipeline::standing(*pipeline::readDecisions(out_.output));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  pipeline::SyntheticOut out_;
  std::unique_ptr<ThreadedJobRunner> runner_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<QMainWindow> window_;
  ReviewStation* station_ = nullptr;
};

void ReviewWindowTest::open(int sherds, bool with_project) {
  folder_ = std::make_unique<QTemporaryDir>();
  const std::filesystem::path project = folder_->path().toStdString();
  pipeline::SyntheticOptions options;
  options.sherds = sherds;
  out_ = pipeline::writeSyntheticOut(project / "results" / "B0001", options);
  runner_ = std::make_unique<ThreadedJobRunner>();
  std::shared_ptr<catalogue::Project> catalogue;
  if (with_project) {
    catalogue::ProjectRecord record;
    record.code = "ARM";
    record.title = "Trial";
    auto made = catalogue::Project::create(project / "rows", record);
    QVERIFY2(made.has_value(), made ? "" : made.error().sentence().c_str());
    catalogue = std::make_shared<catalogue::Project>(std::move(*made));
    enterBatch(*catalogue, sherds);
  }
  session_ = std::make_unique<ProjectSession>(catalogue, project, *runner_);
  window_ = std::make_unique<QMainWindow>();
  station_ = new ReviewStation(window_.get());
  window_->setCentralWidget(station_);
  QAction* undo = session_->undo().createUndoAction(window_.get());
  undo->setShortcut(QKeySequence::Undo);
  window_->addAction(undo);
  window_->resize(1280, 720);
  window_->show();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  station_->openProject(*session_);
  QTRY_VERIFY(model()->isOpen());
  auto* initials = station_->findChild<QLineEdit*>("initials");
  QTRY_VERIFY(model()->whyNotAccept().contains("initials"));
  key(Qt::Key_Return);  // without a name nothing is decided, and the name is what is typed next
  QTRY_VERIFY(initials->hasFocus());
  QVERIFY(standingOnDisk().empty());
  QTest::keyClicks(QApplication::focusWidget(), "AP");
  key(Qt::Key_Return);
  QTRY_COMPARE(model()->person(), QStringLiteral("AP"));
  QTRY_VERIFY(model()->fit().rim_rms_mm > 0);
}

void ReviewWindowTest::enterBatch(catalogue::Project& project, int sherds,
                                  const std::string& number) {
  catalogue::Catalogue& rows = project.catalogue();
  catalogue::BatchRecord batch;
  batch.number = number;
  batch.state = catalogue::BatchState::Review;
  const auto row = rows.addBatch(batch, {});
  QVERIFY2(row.has_value(), row ? "" : row.error().sentence().c_str());
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    for (int i = 0; i < sherds; ++i) {
      catalogue::ScanRecord scan;
      scan.batch = *row;
      scan.side = side;
      scan.index = i + 1;
      scan.name = (side == batch::Side::Front ? out_.table.fronts : out_.table.backs)
                      .at(static_cast<std::size_t>(i))
                      .id;
      scan.path = "results/" + number + "/scans/" + scan.name + ".ply";
      QVERIFY(rows.save(scan, {}).has_value());
    }
}

pipeline::SyntheticOut ReviewWindowTest::addBatch(const std::string& number) {
  auto out = pipeline::writeSyntheticOut(session_->folder() / "results" / number, {});
  enterBatch(session_->project(), 4, number);
  session_->tellBatchChanged(QString::fromStdString(number));
  return out;
}

// Decisions on pairs that the catalogue holds of a batch.
std::size_t ReviewWindowTest::entered(const std::string& number) {
  catalogue::Catalogue& rows = session_->project().catalogue();
  return rows.decisions(rows.batchByNumber(number)->row)->size();
}

void ReviewWindowTest::click(int row, bool on_back) {
  auto* cards = station_->findChild<QListView*>("cards");
  const QRect card = cards->visualRect(model()->index(row));
  const QRect back = CardDelegate::backPicture(card, cards->fontMetrics());
  QTest::mouseClick(cards->viewport(), Qt::LeftButton, {},
                    on_back ? back.center() : QPoint(back.right() + 20, back.top() + 4));
}

void ReviewWindowTest::drag(int from_row, int to_row) {
  auto* cards = station_->findChild<QListView*>("cards");
  const auto rect = [&](int row) { return cards->visualRect(model()->index(row)); };
  const QPoint from = CardDelegate::backPicture(rect(from_row), cards->fontMetrics()).center();
  const QPoint to = rect(to_row).center();
  QTest::mousePress(cards->viewport(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i) {
    const QPoint at = from + (to - from) * i / 8;
    QMouseEvent move(QEvent::MouseMove, at, cards->viewport()->mapToGlobal(at), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(cards->viewport(), &move);
  }
  QTest::mouseRelease(cards->viewport(), Qt::LeftButton, {}, to);
}

void ReviewWindowTest::cleanup() {
  window_.reset();
  session_.reset();
  runner_.reset();
}

void ReviewWindowTest::swappedLookAlikesAreFixedByKeyboard() {
  open(4);
  QCOMPARE(cardOf(0).back, 1);
  const int first = model()->front();
  QVERIFY(first < 2);
  key(Qt::Key_2);
  QTRY_COMPARE(model()->trial().back, first);
  key(Qt::Key_Return);
  QTRY_COMPARE(cardOf(first).state, CardState::Decided);
  QCOMPARE(model()->front(), 1 - first);
  QVERIFY(station_->findChild<QLabel*>("reason")->text().contains("given to another front"));
  key(Qt::Key_Return);
  QTRY_COMPARE(model()->waiting(), 0);
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(cardOf(1).back, 1);
  QCOMPARE(standingOnDisk().size(), std::size_t{2});

  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(model()->waiting(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(cardOf(0).back, 1);
  QVERIFY(standingOnDisk().empty());
  QCOMPARE(pipeline::readDecisions(out_.output)->size(), std::size_t{4});
}

void ReviewWindowTest::swappedLookAlikesAreFixedByMouse() {
  open(4);
  drag(model()->rowOf(0), model()->rowOf(1));  // the back of f001's card onto f002
  QTRY_COMPARE(cardOf(1).back, 1);
  QCOMPARE(cardOf(1).state, CardState::Decided);
  QCOMPARE(model()->front(), 0);
  QCOMPARE(cardOf(0).back, 0);
  QTest::mouseClick(station_->findChild<QPushButton*>("acceptButton"), Qt::LeftButton);
  QTRY_COMPARE(model()->waiting(), 0);
  QCOMPARE(cardOf(0).back, 0);
}

void ReviewWindowTest::twentyPairsAreReviewedByKeyboardAlone() {
  open(20);
  for (int i = 0; i < 20; ++i) {
    const int before = static_cast<int>(standingOnDisk().size());
    QCOMPARE(before, i);
    key(Qt::Key_Return);
    QTRY_COMPARE(static_cast<int>(standingOnDisk().size()), i + 1);
  }
  for (int front = 0; front < 20; ++front) QCOMPARE(cardOf(front).state, CardState::Decided);
  QCOMPARE(station_->waiting(), 0);
}

void ReviewWindowTest::theKeysOfThePictureWork() {
  open(4);
  auto& view = *station_->findChild<SherdView*>("sherd");
  QVERIFY(view.hasOpenGl());
  key(Qt::Key_A);
  QVERIFY(view.isApart());
  key(Qt::Key_D);
  QVERIFY(view.isMeasuring());
  QVERIFY2(!view.isApart(), "across sides that lie apart a length would be false");
  key(Qt::Key_D);
  key(Qt::Key_X);
  QVERIFY(view.hasSection());
  key(Qt::Key_X);
  QVERIFY(!view.hasSection());
  const int front = model()->front();
  key(Qt::Key_Down);
  QVERIFY(model()->front() != front);
  key(Qt::Key_Up);
  QCOMPARE(model()->front(), front);
  const int shift = model()->trial().shift;
  key(Qt::Key_Right, Qt::ShiftModifier);
  QTRY_COMPARE(model()->trial().shift, shift + 1);
  key(Qt::Key_B);
  QTRY_COMPARE(model()->trial().made, Made::Settled);
  key(Qt::Key_S);
  QTRY_COMPARE(cardOf(front).state, CardState::Aside);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(cardOf(front).state, CardState::Ask);
}

void ReviewWindowTest::aPieceIsCutByKeyboard() {
  open(4);
  const int front = model()->front(), back = model()->trial().back;
  const auto& table = model()->live()->table();
  key(Qt::Key_K);
  auto* pictures = station_->findChild<PicturePair*>();
  QVERIFY(pictures->isCutting());
  key(Qt::Key_Escape);
  QVERIFY(!pictures->isCutting());
  key(Qt::Key_K);
  key(Qt::Key_J);  // another thing altogether
  QVERIFY(!pictures->isCutting());
  QVERIFY(station_->findChild<QLabel*>("reason")->text().contains("Which front"));
  key(Qt::Key_K);
  QVERIFY(pictures->isCutting());
  // Four steps to the right, turned from upright by three times five degrees.
  for (int i = 0; i < 4; ++i) key(Qt::Key_Right);
  for (int i = 0; i < 3; ++i) key(Qt::Key_Right, Qt::ShiftModifier);
  QCOMPARE(model()->front(), front);
  key(Qt::Key_Return);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  pipeline::PairDecision cut = standingOnDisk()[0];
  QCOMPARE(cut.kind, pipeline::DecisionKind::Split);
  QCOMPARE(cut.scans[0].id, table.fronts[static_cast<std::size_t>(front)].id);
  const Eigen::Vector2d along = (cut.cut_mm[1] - cut.cut_mm[0]).normalized();
  QVERIFY(std::abs(std::abs(along.y()) - std::cos(15 * M_PI / 180)) < 1e-6);
  QVERIFY(std::abs(std::abs(along.x()) - std::sin(15 * M_PI / 180)) < 1e-6);
  QVERIFY(!pictures->isCutting());
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(standingOnDisk().empty());
  // The other side.
  model()->select(front);
  QTRY_VERIFY(model()->fit().rim_rms_mm > 0);
  key(Qt::Key_K);
  key(Qt::Key_Down);
  QVERIFY(pictures->accessibleDescription().contains("back"));
  key(Qt::Key_Enter);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  cut = standingOnDisk()[0];
  QCOMPARE(cut.scans[0].id, table.backs[static_cast<std::size_t>(back)].id);
}

void ReviewWindowTest::aBackThatNoFrontHoldsHasACardOfItsOwn() {
  open(4);
  click(model()->rowOf(2));
  QTRY_COMPARE(model()->front(), 2);
  key(Qt::Key_S);
  QTRY_COMPARE(cardOf(2).state, CardState::Aside);
  QCOMPARE(model()->waiting(), 3);
  QCOMPARE(model()->rowCount(), 5);
  const int lone = model()->rowOfLoneBack(2);
  QCOMPARE(lone, 2);  // behind the two doubtful pairs
  click(lone);
  QTRY_COMPARE(model()->rowInHand(), lone);
  QCOMPARE(model()->front(), -1);
  QVERIFY(station_->findChild<QLabel*>("reason")->text().contains("No front holds this back"));
  QVERIFY(!station_->findChild<QPushButton*>("acceptButton")->isEnabled());
  key(Qt::Key_B);  // nothing to settle: nothing happens
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_S);
  QTRY_COMPARE(model()->waiting(), 2);
  QCOMPARE(model()->review().aside_backs, std::vector<int>{2});
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(model()->waiting(), 3);
  QCOMPARE(model()->rowInHand(), model()->rowOfLoneBack(2));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(cardOf(2).state, CardState::Sure);
  QCOMPARE(model()->rowCount(), 4);
}

void ReviewWindowTest::aLoneBackIsDraggedOntoItsFront() {
  open(4);
  click(model()->rowOf(2));
  key(Qt::Key_S);
  QTRY_COMPARE(model()->rowCount(), 5);
  drag(model()->rowOfLoneBack(2), model()->rowOf(2));
  QTRY_COMPARE(cardOf(2).state, CardState::Decided);
  QCOMPARE(cardOf(2).back, 2);
  QCOMPARE(model()->rowCount(), 4);
}

void ReviewWindowTest::piecesOfTheBackAreJoinedByKeyboardAndByMouse() {
  open(4, true);
  const auto backs = [this](int a, int b) {
    const pipeline::PairDecision join = standingOnDisk().back();
    return join.kind == pipeline::DecisionKind::Join && join.scans.size() == 2 &&
           join.scans[0].side == batch::Side::Back && join.scans[1].side == batch::Side::Back &&
           join.scans[0].id == out_.table.backs.at(static_cast<std::size_t>(a)).id &&
           join.scans[1].id == out_.table.backs.at(static_cast<std::size_t>(b)).id;
  };
  const int held = model()->trial().back;
  key(Qt::Key_J, Qt::ShiftModifier);
  QVERIFY(station_->findChild<QLabel*>("reason")->text().startsWith("Which back belongs"));
  key(Qt::Key_Down);
  key(Qt::Key_Down);
  QCOMPARE(model()->rowInHand(), 0);  // only marked
  key(Qt::Key_Return);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  QVERIFY(backs(held, 2));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(standingOnDisk().empty());

  key(Qt::Key_J);
  click(model()->rowOf(3), true);  // on the picture of its back
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  QVERIFY(backs(held, 3));
  key(Qt::Key_J);
  key(Qt::Key_Escape);
  key(Qt::Key_Down);
  QCOMPARE(standingOnDisk().size(), std::size_t{1});

  // Both joins and the withdrawal stand in the catalogue, with who took them.
  catalogue::Catalogue& rows = session_->project().catalogue();
  const auto kept = catalogue::pieceDecisions(rows, rows.batchByNumber("B0001")->row);
  QVERIFY(kept.has_value());
  QCOMPARE(kept->size(), std::size_t{3});
  QCOMPARE(kept->at(1).verdict, catalogue::PieceVerdict::Withdraw);
  QCOMPARE(kept->at(2).pieces.at(1).name, out_.table.backs.at(3).id);
  QCOMPARE(rows.persons()->at(0).initials, std::string("AP"));
  QCOMPARE(kept->at(2).by, rows.persons()->at(0).row);
}

void ReviewWindowTest::theQueueFollowsWhatIsDecided() {
  open(4, true);
  BatchQueue queue;
  queue.setSession(session_.get());
  QCOMPARE(queue.row(0).state, QueueState::Review);
  const int first = model()->front();
  key(Qt::Key_2);
  QTRY_COMPARE(model()->trial().back, first);
  key(Qt::Key_Return);
  QTRY_VERIFY(queue.row(0).figures.has_value());
  QCOMPARE(queue.row(0).figures->sherds, 4);
  QCOMPARE(queue.row(0).figures->decided, 1);
  QCOMPARE(queue.row(0).figures->sure, 2);
  QCOMPARE(queue.row(0).figures->ask, 1);
  key(Qt::Key_Return);
  QTRY_COMPARE(queue.row(0).figures->ask, 0);
  QCOMPARE(queue.row(0).figures->decided, 2);
  // The pairs are others than before: their models are still to be made.
  QCOMPARE(batchState(), catalogue::BatchState::Review);
  QVERIFY(stateWords(queue.row(0)).contains("to be computed"));
  QVERIFY(station_->findChild<QPushButton*>("compute")->isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(queue.row(0).figures->ask, 1);
  queue.setSession(nullptr);
}

void ReviewWindowTest::whatIsOnlyConfirmedNeedsNoComputing() {
  open(4, true);
  key(Qt::Key_Return);
  key(Qt::Key_Return);
  QTRY_COMPARE(model()->waiting(), 0);
  QTRY_COMPARE(batchState(), catalogue::BatchState::Done);
  QVERIFY(!station_->findChild<QPushButton*>("compute")->isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(model()->waiting(), 2);
  QCOMPARE(batchState(), catalogue::BatchState::Review);
}

void ReviewWindowTest::aBatchOfDoubtfulScaleSaysSoAboveItsPairs() {
  open(3, true);
  auto* bar = station_->findChild<QWidget*>("scaleInDoubt");
  QVERIFY(!bar->isVisible());
  catalogue::Catalogue& rows = session_->project().catalogue();
  catalogue::BatchRecord held = *rows.batchByNumber("B0001");
  held.scale_doubts = "The scale is not right: 50 mm measure 49.5 mm.";
  QVERIFY(rows.saveBatch(held, {}).has_value());
  session_->tellBatchChanged("B0001");
  QTRY_VERIFY(bar->isVisible());
  const QString words = station_->findChild<QLabel*>("scaleWords")->text();
  QVERIFY2(words.contains("50 mm measure 49.5 mm") && words.contains("B0001"), qPrintable(words));
  QSignalSpy asked(station_, &Station::wantsStation);
  QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
  QCOMPARE(asked.count(), 1);
  QCOMPARE(asked.at(0).at(0).toString(), QStringLiteral("queue"));
  held.scale_doubts.clear();
  QVERIFY(rows.saveBatch(held, {}).has_value());
  session_->tellBatchChanged("B0001");
  QTRY_VERIFY(!bar->isVisible());
}

void ReviewWindowTest::nothingIsDecidedWhileAnotherBatchOpens() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  QCOMPARE(shown(), QStringLiteral("B0001"));
  station_->showItem("B0002");
  key(Qt::Key_Return);  // the card that was there a moment ago
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
  QVERIFY(standingOnDisk().empty());
  QVERIFY(pipeline::readDecisions(second.output)->empty());
  QCOMPARE(entered("B0001") + entered("B0002"), std::size_t{0});
  key(Qt::Key_Return);
  QTRY_COMPARE(pipeline::readDecisions(second.output)->size(), std::size_t{1});
  QCOMPARE(entered("B0002"), std::size_t{1});
  QCOMPARE(entered("B0001"), std::size_t{0});
}

void ReviewWindowTest::aBatchThatDoesNotOpenLeavesNoPairsToDecideOn() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  std::ofstream(second.output / "work" / "pairs" / "candidates.json") << "{ half";
  station_->showItem("B0002");
  auto* message = station_->findChild<QLabel*>("message");
  QTRY_VERIFY2(message->text().contains("candidates.json"), qPrintable(message->text()));
  QVERIFY(!model()->isOpen());
  key(Qt::Key_Return);
  QVERIFY(standingOnDisk().empty());
  QCOMPARE(entered("B0001") + entered("B0002"), std::size_t{0});
}

void ReviewWindowTest::whatDecidesIsInSightHoweverLargeTheLetters() {
  for (const int percent : {100, 150, 200}) {
    applyLook(*qApp, Theme::Light, percent);
    open(4);
    window_->centralWidget()->setMinimumSize(0, 0);
    window_->resize(980, 590);  // what the rail and the lines leave of 1280 x 690 at 200 %
    QTRY_COMPARE(window_->size(), QSize(980, 590));
    for (const char* name : {"acceptButton", "reason", "candidate1", "otherBacks"}) {
      const auto* widget = station_->findChild<QWidget*>(name);
      QVERIFY2(widget != nullptr, name);
      QTRY_VERIFY2(widget->visibleRegion().boundingRect() == widget->rect(),
                   qPrintable(QStringLiteral("%1 at %2 %").arg(name).arg(percent)));
    }
    cleanup();
  }
  applyLook(*qApp, Theme::Light, 100);
}

void ReviewWindowTest::everyControlHasAName() {
  open(4);
  QTRY_VERIFY(station_->findChild<QWidget*>("candidate1") != nullptr);
  const QStringList nameless = namelessIn(*window_);
  QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
}

}  // namespace ostraka::ui

int main(int argc, char** argv) {
  ostraka::ui::prepareOpenGl();
  QApplication application(argc, argv);
  ostraka::ui::ReviewWindowTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "review_window_test.moc"
