// What a person does in the review, in a real window with real jobs.
#include <QApplication>
#include <QLabel>
#include <QListView>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "../names.h"
#include "catalogue/batches.h"
#include "catalogue/places.h"
#include "files/files.h"
#include "intake/piece_decisions.h"
#include "review_window.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/look/look.h"
#include "ui/queue/batch_queue.h"
#include "ui/review/card_delegate.h"
#include "ui/review/picture_pair.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

using review::CardState;

class ReviewWindowTest : public ReviewWindow {
  Q_OBJECT

 private slots:
  void cleanup() { close(); }
  void swappedLookAlikesAreFixedByKeyboard();
  void swappedLookAlikesAreFixedByMouse();
  void twentyPairsAreReviewedByKeyboardAlone();
  void aKeyThatIsHeldDownDecidesOnePair();
  void theKeysOfThePictureWork();
  void aPieceIsCutByKeyboard();
  void aBackThatNoFrontHoldsHasACardOfItsOwn();
  void aLoneBackIsDraggedOntoItsFront();
  void piecesOfTheBackAreJoinedByKeyboardAndByMouse();
  void theQueueFollowsWhatIsDecided();
  void whatIsOnlyConfirmedNeedsNoComputing();
  void aJoinThatWasComputedAndIsTakenBackWantsComputing();
  void joinsAndCutsOfNumberedSherdsNameTheirNumbers();
  void aBatchOfDoubtfulScaleSaysSoAboveItsPairs();
  void whatDecidesIsInSightHoweverLargeTheLetters();
  void everyControlHasAName();

 private:
  void click(int row, bool on_back = false);
  void drag(int from_row, int to_row);
};

void ReviewWindowTest::click(int row, bool on_back) {
  auto* cards = screen_->findChild<QListView*>("cards");
  const QRect card = cards->visualRect(review()->cards().index(row));
  const QRect back = CardDelegate::backPicture(card, cards->fontMetrics());
  QTest::mouseClick(cards->viewport(), Qt::LeftButton, {},
                    on_back ? back.center() : QPoint(back.right() + 20, back.top() + 4));
}

void ReviewWindowTest::drag(int from_row, int to_row) {
  auto* cards = screen_->findChild<QListView*>("cards");
  const auto rect = [&](int row) { return cards->visualRect(review()->cards().index(row)); };
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

void ReviewWindowTest::swappedLookAlikesAreFixedByKeyboard() {
  open(4);
  QCOMPARE(cardOf(0).back, 1);
  const int first = review()->hand().front();
  QVERIFY(first < 2);
  key(Qt::Key_2);
  QTRY_COMPARE(review()->hand().trial().back, first);
  key(Qt::Key_Return);
  QTRY_COMPARE(cardOf(first).state, CardState::Decided);
  QCOMPARE(review()->hand().front(), 1 - first);
  QVERIFY(screen_->findChild<QLabel*>("reason")->text().contains("was given to front "));
  key(Qt::Key_Return);
  QTRY_COMPARE(review()->waiting(), 0);
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(cardOf(1).back, 1);
  QCOMPARE(standingOnDisk().size(), std::size_t{2});

  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(review()->waiting(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(cardOf(0).back, 1);
  QVERIFY(standingOnDisk().empty());
  QCOMPARE(decisions::readDecisions(out_.output)->size(), std::size_t{4});
}

void ReviewWindowTest::swappedLookAlikesAreFixedByMouse() {
  open(4);
  drag(review()->cards().rowOf(0),
       review()->cards().rowOf(1));  // the back of f001's card onto f002
  QTRY_COMPARE(review()->hand().front(), 1);
  QTRY_COMPARE(review()->hand().trial().back, 1);
  QVERIFY(standingOnDisk().empty());
  key(Qt::Key_Return);
  QTRY_COMPARE(cardOf(1).back, 1);
  QCOMPARE(cardOf(1).state, CardState::Decided);
  QCOMPARE(review()->hand().front(), 0);
  QCOMPARE(cardOf(0).back, 0);
  auto* accept = screen_->findChild<QPushButton*>("acceptButton");
  QTRY_VERIFY(accept->isEnabled());
  QTest::mouseClick(accept, Qt::LeftButton);
  QTRY_COMPARE(review()->waiting(), 0);
  QCOMPARE(cardOf(0).back, 0);
}

void ReviewWindowTest::twentyPairsAreReviewedByKeyboardAlone() {
  open(20);
  int decided = 0;
  for (; review()->waiting() > 0; ++decided) {
    QCOMPARE(static_cast<int>(standingOnDisk().size()), decided);
    key(Qt::Key_Return);
    QTRY_COMPARE(static_cast<int>(standingOnDisk().size()), decided + 1);
  }
  QVERIFY(decided > 0 && decided < 20);
  QCOMPARE(screen_->waiting(), 0);
  // Nothing is left to accept, and what comes next is said.
  auto* accept = screen_->findChild<QPushButton*>("acceptButton");
  const auto* message = screen_->findChild<QLabel*>("message");
  QTRY_VERIFY(!review()->hand().isLoading());
  QVERIFY(!accept->isEnabled());
  QVERIFY(message->text().startsWith("Saved. All pairs of B0001 are decided. Next: "));
  key(Qt::Key_Return);
  QCOMPARE(static_cast<int>(standingOnDisk().size()), decided);
  QCOMPARE(message->text(), QStringLiteral("All pairs of this batch are decided."));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(review()->waiting() > 0 && accept->isEnabled());
}

// A glove, or something that lies on the key.
void ReviewWindowTest::aKeyThatIsHeldDownDecidesOnePair() {
  open(4);
  const auto hold = [this](Qt::Key held, const QString& text) {
    QTRY_VERIFY(!review()->hand().isLoading());
    QWidget* widget = QApplication::focusWidget();
    QTest::simulateEvent(widget, true, held, Qt::NoModifier, text, false);
    for (int i = 0; i < 5; ++i)
      QTest::simulateEvent(widget, true, held, Qt::NoModifier, text, true);
    QTest::simulateEvent(widget, false, held, Qt::NoModifier, text, false);
    QApplication::processEvents();
  };
  hold(Qt::Key_Return, "\r");
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  hold(Qt::Key_S, "s");
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{2});
  screen_->findChild<QListView*>("cards")->setFocus();
  hold(Qt::Key_S, "s");
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{3});
  review()->selectRow(0);
  hold(Qt::Key_Down, {});
  QTRY_COMPARE(review()->hand().row(), review()->cards().rowCount() - 1);
}

void ReviewWindowTest::theKeysOfThePictureWork() {
  open(4);
  auto& view = *screen_->findChild<SherdView*>("sherd");
  QVERIFY(view.hasOpenGl());
  key(Qt::Key_A);
  QVERIFY(view.isApart());
  key(Qt::Key_D);
  QVERIFY(view.isMeasuring());
  QVERIFY2(!view.isApart(), "across sides that lie apart a length would be false");
  const auto* reason = screen_->findChild<QLabel*>("reason");
  QVERIFY2(reason->text().startsWith("Click on one end"), qPrintable(reason->text()));
  key(Qt::Key_D);
  QCOMPARE(reason->text(), review()->hand().reason());
  key(Qt::Key_X);
  QVERIFY(view.hasSection());
  key(Qt::Key_X);
  QVERIFY(!view.hasSection());
  const int front = review()->hand().front();
  key(Qt::Key_Down);
  QVERIFY(review()->hand().front() != front);
  key(Qt::Key_Up);
  QCOMPARE(review()->hand().front(), front);
  const int shift = review()->hand().trial().shift;
  key(Qt::Key_Right, Qt::ShiftModifier);
  QTRY_COMPARE(review()->hand().trial().shift, shift + 1);
  key(Qt::Key_B);
  QTRY_COMPARE(review()->hand().trial().made, Made::Settled);
  key(Qt::Key_S);
  QTRY_COMPARE(cardOf(front).state, CardState::Aside);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(cardOf(front).state, CardState::Ask);
}

void ReviewWindowTest::aPieceIsCutByKeyboard() {
  open(4);
  const int front = review()->hand().front(), back = review()->hand().trial().back;
  const auto& table = review()->batch().table();
  key(Qt::Key_K);
  auto* pictures = screen_->findChild<PicturePair*>();
  QVERIFY(pictures->isCutting());
  const auto* reason = screen_->findChild<QLabel*>("reason");
  QVERIFY2(reason->text().contains("Enter cuts"), qPrintable(reason->text()));
  key(Qt::Key_Escape);
  QCOMPARE(reason->text(), review()->hand().reason());
  QVERIFY(!pictures->isCutting());
  key(Qt::Key_K);
  key(Qt::Key_J);  // another thing altogether
  QVERIFY(!pictures->isCutting());
  QVERIFY(screen_->findChild<QLabel*>("reason")->text().contains("Which front"));
  key(Qt::Key_K);
  QVERIFY(pictures->isCutting());
  // Four steps to the right, turned from upright by three times five degrees.
  for (int i = 0; i < 4; ++i) key(Qt::Key_Right);
  for (int i = 0; i < 3; ++i) key(Qt::Key_Right, Qt::ShiftModifier);
  QCOMPARE(review()->hand().front(), front);
  key(Qt::Key_Return);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  decisions::PairDecision cut = standingOnDisk()[0];
  QCOMPARE(cut.kind, decisions::DecisionKind::Split);
  QCOMPARE(cut.scans[0].id, table.fronts[static_cast<std::size_t>(front)].id);
  const Eigen::Vector2d along = (cut.cut_mm[1] - cut.cut_mm[0]).normalized();
  QVERIFY(std::abs(std::abs(along.y()) - std::cos(15 * M_PI / 180)) < 1e-6);
  QVERIFY(std::abs(std::abs(along.x()) - std::sin(15 * M_PI / 180)) < 1e-6);
  QVERIFY(!pictures->isCutting());
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(standingOnDisk().empty());
  // The other side.
  review()->select(front);
  QTRY_VERIFY(review()->hand().fit().fracture_rms_mm > 0);
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
  click(review()->cards().rowOf(2));
  QTRY_COMPARE(review()->hand().front(), 2);
  key(Qt::Key_S);
  QTRY_COMPARE(cardOf(2).state, CardState::Aside);
  QCOMPARE(review()->waiting(), 3);
  QCOMPARE(review()->cards().rowCount(), 5);
  const int lone = review()->cards().rowOfLoneBack(2);
  QCOMPARE(lone, 2);  // behind the two doubtful pairs
  click(lone);
  QTRY_COMPARE(review()->hand().row(), lone);
  QCOMPARE(review()->hand().front(), -1);
  QVERIFY(screen_->findChild<QLabel*>("reason")->text().contains("No front holds this back"));
  QVERIFY(!screen_->findChild<QPushButton*>("acceptButton")->isEnabled());
  key(Qt::Key_B);  // nothing to settle: nothing happens
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_S);
  QTRY_COMPARE(review()->waiting(), 2);
  QCOMPARE(review()->batch().review().aside_backs, std::vector<int>{2});
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(review()->waiting(), 3);
  QCOMPARE(review()->hand().row(), review()->cards().rowOfLoneBack(2));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(cardOf(2).state, CardState::Sure);
  QCOMPARE(review()->cards().rowCount(), 4);
}

void ReviewWindowTest::aLoneBackIsDraggedOntoItsFront() {
  open(4);
  click(review()->cards().rowOf(2));
  key(Qt::Key_S);
  QTRY_COMPARE(review()->cards().rowCount(), 5);
  drag(review()->cards().rowOfLoneBack(2), review()->cards().rowOf(2));
  QTRY_COMPARE(review()->hand().front(), 2);
  QTRY_COMPARE(review()->hand().trial().back, 2);
  key(Qt::Key_Return);
  QTRY_COMPARE(cardOf(2).state, CardState::Decided);
  QCOMPARE(cardOf(2).back, 2);
  QCOMPARE(review()->cards().rowCount(), 4);
}

void ReviewWindowTest::joinsAndCutsOfNumberedSherdsNameTheirNumbers() {
  open(4, true);
  catalogue::Catalogue& rows = session_->project().catalogue();
  records::SiteRecord site;
  site.code = site.name = "ARM1";
  records::ContextRecord context;
  context.site = *catalogue::Places(rows).save(site, {});
  context.number = "0012";
  records::SherdRecord sherd;
  sherd.context = *catalogue::Places(rows).save(context, {});
  sherd.batch = catalogue::Batches(rows).byNumber("B0001")->row;
  const auto scans = *catalogue::Batches(rows).scans(sherd.batch);
  for (const int i : {2, 3}) {
    sherd.front = scans.at(static_cast<std::size_t>(i)).row;
    sherd.number = "ARM1-0012-" + std::to_string(i);
    QVERIFY(sherds::Sherds(rows).add(sherd, {}).has_value());
  }
  session_->tellSherdsChanged();
  const auto numberOf = [this](int front) { return review()->cards().number(front); };
  QCOMPARE(numberOf(2), QStringLiteral("ARM1-0012-2"));
  QVERIFY(numberOf(0).isEmpty());
  review()->select(2);
  QTRY_VERIFY(!review()->hand().isLoading());
  review()->joinWith(batch::Side::Front, review()->cards().rowOf(3));
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  const QString said = screen_->findChild<QLabel*>("message")->text();
  QVERIFY2(said.contains("keeps the number ARM1-0012-2, and ARM1-0012-3 has no fragment"),
           qPrintable(said));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(standingOnDisk().empty());
  QVERIFY(screen_->findChild<QLabel*>("message")->text().startsWith("Undone"));
  review()->select(2);
  QTRY_VERIFY(review()->hand().fit().fracture_rms_mm > 0);
  key(Qt::Key_K);
  key(Qt::Key_Return);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  const QString cut = screen_->findChild<QLabel*>("message")->text();
  QVERIFY2(cut.contains("number ARM1-0012-2 goes to the half"), qPrintable(cut));
}

void ReviewWindowTest::piecesOfTheBackAreJoinedByKeyboardAndByMouse() {
  open(4, true);
  const auto backs = [this](int a, int b) {
    const decisions::PairDecision join = standingOnDisk().back();
    return join.kind == decisions::DecisionKind::Join && join.scans.size() == 2 &&
           join.scans[0].side == batch::Side::Back && join.scans[1].side == batch::Side::Back &&
           join.scans[0].id == out_.table.backs.at(static_cast<std::size_t>(a)).id &&
           join.scans[1].id == out_.table.backs.at(static_cast<std::size_t>(b)).id;
  };
  const int held = review()->hand().trial().back;
  key(Qt::Key_J, Qt::ShiftModifier);
  QVERIFY(screen_->findChild<QLabel*>("reason")->text().startsWith("Which back belongs"));
  key(Qt::Key_Down);
  key(Qt::Key_Down);
  QCOMPARE(review()->hand().row(), 0);  // only marked
  key(Qt::Key_Return);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  QVERIFY(backs(held, 2));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(standingOnDisk().empty());

  key(Qt::Key_J);
  click(review()->cards().rowOf(3), true);  // on the picture of its back
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  QVERIFY(backs(held, 3));
  // What is marked is what the keys act on.
  auto* cards = screen_->findChild<QListView*>("cards");
  const auto marked = [&] {
    const QModelIndexList rows = cards->selectionModel()->selectedIndexes();
    return rows.size() == 1 ? rows[0].row() : -1;
  };
  QTRY_COMPARE(marked(), review()->hand().row());
  QCOMPARE(cards->currentIndex().row(), review()->hand().row());
  key(Qt::Key_J);
  key(Qt::Key_Escape);
  key(Qt::Key_Down);
  QCOMPARE(standingOnDisk().size(), std::size_t{1});

  // Both joins and the withdrawal stand in the catalogue, with who took them.
  catalogue::Catalogue& rows = session_->project().catalogue();
  const auto kept = intake::pieceDecisions(rows, catalogue::Batches(rows).byNumber("B0001")->row);
  QVERIFY(kept.has_value());
  QCOMPARE(kept->size(), std::size_t{3});
  QCOMPARE(kept->at(1).verdict, intake::PieceVerdict::Withdraw);
  QCOMPARE(kept->at(2).pieces.at(1).name, out_.table.backs.at(3).id);
  QCOMPARE(catalogue::People(rows).all()->at(0).initials, std::string("AP"));
  QCOMPARE(kept->at(2).by, catalogue::People(rows).all()->at(0).row);
}

void ReviewWindowTest::theQueueFollowsWhatIsDecided() {
  open(4, true);
  BatchQueue queue;
  queue.setSession(session_.get());
  QCOMPARE(queue.row(0).state, QueueState::Review);
  const int first = review()->hand().front();
  key(Qt::Key_2);
  QTRY_COMPARE(review()->hand().trial().back, first);
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
  QCOMPARE(batchState(), records::BatchState::Review);
  QVERIFY(stateWords(queue.row(0)).startsWith("Decided: reprocess"));
  QVERIFY(screen_->findChild<QPushButton*>("compute")->isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(queue.row(0).figures->ask, 1);
  queue.setSession(nullptr);
}

void ReviewWindowTest::whatIsOnlyConfirmedNeedsNoComputing() {
  open(4, true);
  key(Qt::Key_Return);
  key(Qt::Key_Return);
  QTRY_COMPARE(review()->waiting(), 0);
  QTRY_COMPARE(batchState(), records::BatchState::Done);
  QVERIFY(!screen_->findChild<QPushButton*>("compute")->isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(review()->waiting(), 2);
  QCOMPARE(batchState(), records::BatchState::Review);
}

void ReviewWindowTest::aJoinThatWasComputedAndIsTakenBackWantsComputing() {
  open(4, true);
  const auto* compute = screen_->findChild<QPushButton*>("compute");
  key(Qt::Key_J, Qt::ShiftModifier);
  key(Qt::Key_Down);
  key(Qt::Key_Down);
  key(Qt::Key_Return);
  QTRY_VERIFY(compute->isVisible());
  // As the computation leaves it that followed the join.
  const std::string computed = R"({"decisions": [")" + standingOnDisk().at(0).id + R"("]})";
  QVERIFY(writeFileAtomically(out_.output / "report.json", computed));
  session_->tellBatchChanged("B0001");
  QTRY_VERIFY(!compute->isVisible());
  QTRY_VERIFY(review()->batch().isOpen());
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY(standingOnDisk().empty());
  QTRY_VERIFY(compute->isVisible());
  QCOMPARE(batchState(), records::BatchState::Review);
}

void ReviewWindowTest::aBatchOfDoubtfulScaleSaysSoAboveItsPairs() {
  open(3, true);
  auto* bar = screen_->findChild<QWidget*>("scaleInDoubt");
  QVERIFY(!bar->isVisible());
  catalogue::Catalogue& rows = session_->project().catalogue();
  records::BatchRecord held = *catalogue::Batches(rows).byNumber("B0001");
  held.scale_doubts = {"The scale is wrong: 50 mm measure 49.5 mm."};
  QVERIFY(catalogue::Batches(rows).save(held, {}).has_value());
  session_->tellBatchChanged("B0001");
  QTRY_VERIFY(bar->isVisible());
  const QString words = screen_->findChild<QLabel*>("scaleWords")->text();
  QVERIFY2(words.contains("50 mm measure 49.5 mm") && words.contains("B0001"), qPrintable(words));
  QSignalSpy asked(screen_, &Screen::wantsScreen);
  QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
  QCOMPARE(asked.count(), 1);
  QCOMPARE(asked.at(0).at(0).toString(), QStringLiteral("queue"));
  held.scale_doubts.clear();
  QVERIFY(catalogue::Batches(rows).save(held, {}).has_value());
  session_->tellBatchChanged("B0001");
  QTRY_VERIFY(!bar->isVisible());
}

void ReviewWindowTest::whatDecidesIsInSightHoweverLargeTheLetters() {
  for (const int percent : {100, 150, 200}) {
    applyLook(*qApp, Theme::Light, percent);
    open(4);
    window_->centralWidget()->setMinimumSize(0, 0);
    screen_->setCompact(690 * 100 / percent < Look::kCompactBelow);  // as the window does
    window_->resize(980, 590);  // what the sidebar and the lines leave of 1280 x 690 at 200 %
    QTRY_COMPARE(window_->size(), QSize(980, 590));
    for (const char* name : {"acceptButton", "reason", "candidate1", "otherBacks"}) {
      const auto* widget = screen_->findChild<QWidget*>(name);
      QVERIFY2(widget != nullptr, name);
      QTRY_VERIFY2(widget->visibleRegion().boundingRect() == widget->rect(),
                   qPrintable(QStringLiteral("%1 at %2 %").arg(name).arg(percent)));
    }
    close();
  }
  applyLook(*qApp, Theme::Light, 100);
}

void ReviewWindowTest::everyControlHasAName() {
  open(4);
  QTRY_VERIFY(screen_->findChild<QWidget*>("candidate1") != nullptr);
  const QStringList nameless = namelessIn(*window_);
  QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
}

OSTRAKA_UI_TEST(ReviewWindowTest)

}  // namespace ostraka::ui

#include "records/records.h"
#include "records/sherd.h"
#include "review_window_test.moc"
