// What a person does in the review, in a real window with real jobs.
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "synthetic_out.h"
#include "ui/frame/project_session.h"
#include "ui/review/card_delegate.h"
#include "ui/review/pair_review_model.h"
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
  void everyControlHasAName();

 private:
  void open(int sherds);
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
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

void ReviewWindowTest::open(int sherds) {
  folder_ = std::make_unique<QTemporaryDir>();
  const std::filesystem::path project = folder_->path().toStdString();
  pipeline::SyntheticOptions options;
  options.sherds = sherds;
  out_ = pipeline::writeSyntheticOut(project / "results" / "B0001", options);
  runner_ = std::make_unique<ThreadedJobRunner>();
  session_ = std::make_unique<ProjectSession>(nullptr, project, *runner_);
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
  QTest::mouseClick(initials, Qt::LeftButton);
  QTest::keyClicks(initials, "AP");
  key(Qt::Key_Return);
  QTRY_COMPARE(model()->person(), QStringLiteral("AP"));
  QTRY_VERIFY(model()->fit().rim_rms_mm > 0);
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
  auto* cards = station_->findChild<QListView*>("cards");
  const auto rowRect = [&](int front) {
    return cards->visualRect(model()->index(model()->rowOf(front)));
  };
  // The back of f001's card is dragged onto f002.
  const QPoint from = CardDelegate::backPicture(rowRect(0), cards->fontMetrics()).center();
  const QPoint to = rowRect(1).center();
  QTest::mousePress(cards->viewport(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i) {
    const QPoint at = from + (to - from) * i / 8;
    QMouseEvent move(QEvent::MouseMove, at, cards->viewport()->mapToGlobal(at), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(cards->viewport(), &move);
  }
  QTest::mouseRelease(cards->viewport(), Qt::LeftButton, {}, to);
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

void ReviewWindowTest::everyControlHasAName() {
  open(4);
  for (const QWidget* widget : station_->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible() || widget == station_)
      continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool named = !widget->accessibleName().isEmpty() ||
                       (button != nullptr && !button->text().isEmpty()) ||
                       qobject_cast<const ReviewPane*>(widget) != nullptr;
    QVERIFY2(named, qPrintable(QString("%1 %2").arg(widget->metaObject()->className(),
                                                    widget->objectName())));
  }
}

}  // namespace ostraka::ui

int main(int argc, char** argv) {
  ostraka::ui::prepareOpenGl();
  QApplication application(argc, argv);
  ostraka::ui::ReviewWindowTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "review_window_test.moc"
