// The pair in three dimensions: its closed model, and lengths on it.
#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <nlohmann/json.hpp>

#include "cloud/ply.h"
#include "files/json.h"
#include "review_window.h"
#include "tests/ui/program.h"
#include "ui/review/picture_pair.h"
#include "ui/viewport/sherd_view.h"
#include "ui/viewport/view_overlay.h"

namespace ostraka::ui {

class ReviewPictureTest : public ReviewWindow {
  Q_OBJECT

 private slots:
  void cleanup() { close(); }
  void theClosedModelIsShownOfItsOwnPairOnly();
  void aLengthIsForgottenWhenWhatWasMeasuredMoves();
  void aPairIsNotDecidedBeforeItIsSeen();
  void whatIsOnItsWayIsCalledByItsOwnName();
  void aBatchWithoutAnyLengthIsNotMeasuredInMillimetres();
};

// Sherd 01 was computed from f001 and b002, as the program has them.
void ReviewPictureTest::theClosedModelIsShownOfItsOwnPairOnly() {
  open(4);
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {0, 0, 5}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  QVERIFY(writePly(out_.output / "sherds/01/model.ply", mesh, "plate_front").has_value());
  QSignalSpy fetched(&review()->hand(), &CardInHand::modelFetched);
  QSignalSpy scenes(&review()->hand(), &CardInHand::sceneChanged);
  review()->select(0);
  QTRY_VERIFY(!scenes.isEmpty());
  const auto hasModel = [&] { return fetched.takeLast().at(0).value<MeshPtr>() != nullptr; };
  const auto* closed = screen_->findChild<QAction*>("closed");
  key(Qt::Key_V);
  QTRY_COMPARE(fetched.count(), 1);
  QVERIFY(hasModel());
  QVERIFY(closed->isChecked());
  emit screen_->findChild<SherdView*>("sherd")->backMoved({0.1, 0, 0}, {0, 0, 0});
  QVERIFY2(review()->hand().trial().made == Made::Program, "a back that is not seen is not turned");
  scenes.clear();
  key(Qt::Key_2);
  QTRY_COMPARE(review()->hand().trial().back, 0);
  QTRY_VERIFY(!scenes.isEmpty());
  QVERIFY(!closed->isChecked());
  fetched.clear();
  key(Qt::Key_V);
  QTRY_COMPARE(fetched.count(), 1);
  QVERIFY2(!hasModel(), "of f001 and b001 there is none");
  QVERIFY(!closed->isChecked());
  const QString said = screen_->findChild<QLabel*>("message")->text();
  QVERIFY2(said.contains("no closed model yet"), qPrintable(said));
}

void ReviewPictureTest::aLengthIsForgottenWhenWhatWasMeasuredMoves() {
  open(4);
  auto& view = *screen_->findChild<SherdView*>("sherd");
  const auto length = [&] { return view.findChild<ViewOverlay*>()->measure(); };
  const auto measure = [&] {
    emit view.pointPicked({0, 0, 0});
    emit view.pointPicked({0, 12, 0});
  };
  key(Qt::Key_D);
  measure();
  QVERIFY2(length().contains("12"), qPrintable(length()));
  key(Qt::Key_Right, Qt::ShiftModifier);
  QTRY_COMPARE(review()->hand().trial().made, Made::StartPoint);
  QVERIFY2(length().isEmpty(), "the back has moved");
  measure();
  QVERIFY(!length().isEmpty());
  key(Qt::Key_A);
  QVERIFY(view.isApart());
  QVERIFY2(!view.isMeasuring(), "sides that lie apart are not measured across");
  QVERIFY(length().isEmpty());
}

void ReviewPictureTest::aPairIsNotDecidedBeforeItIsSeen() {
  open(4);
  QTRY_VERIFY(screen_->primary()->isEnabled());
  review()->select(review()->hand().front() == 0 ? 1 : 0);
  QVERIFY(!screen_->primary()->isEnabled());
  QCOMPARE(screen_->findChild<QLabel*>("figures")->text(), QStringLiteral("Loading…"));
  for (const Qt::Key decides : {Qt::Key_Return, Qt::Key_S, Qt::Key_N})
    QTest::keyClick(QApplication::focusWidget(), decides);
  QVERIFY(!std::filesystem::exists(out_.output / "decisions.json"));
  QTRY_VERIFY(screen_->primary()->isEnabled());
  key(Qt::Key_Return);
  QTRY_VERIFY(std::filesystem::exists(out_.output / "decisions.json"));
}

// On a machine that takes its time.
void ReviewPictureTest::whatIsOnItsWayIsCalledByItsOwnName() {
  open(4);
  const int first = review()->hand().front();
  auto& pictures = *screen_->findChild<PicturePair*>("pictures");
  QVERIFY(pictures.accessibleDescription().contains(QStringLiteral("Front %1").arg(first + 1)));
  const auto live = review()->batch().live();
  review()->close();
  QVERIFY(!pictures.accessibleDescription().contains(QString::number(first + 1)));
  decisions::Decisions none;
  review()->open({live, none, none});
  QVERIFY(review()->hand().isLoading());
  QCOMPARE(pictures.missingWords(), QStringLiteral("Loading…"));
  review()->select(3);  // and on to the next before that one came
  QVERIFY(pictures.accessibleDescription().contains("Front 4"));
  QCOMPARE(pictures.missingWords(), QStringLiteral("Loading…"));
  QTRY_VERIFY(!review()->hand().isLoading());
  QVERIFY(pictures.accessibleDescription().contains("Front 4"));
}

void ReviewPictureTest::aBatchWithoutAnyLengthIsNotMeasuredInMillimetres() {
  open(3);
  const auto* bar = screen_->findChild<QWidget*>("scaleInDoubt");
  QVERIFY(!bar->isVisible());
  decisions::CandidateTable table = out_.table;
  table.has_scale = false;
  QVERIFY(writeJson(out_.output / "work/pairs/candidates.json", toJson(table)).has_value());
  QSignalSpy scenes(&review()->hand(), &CardInHand::sceneChanged);
  screen_->showItem("B0001");
  QTRY_VERIFY(!scenes.isEmpty());
  QVERIFY(bar->isVisible());
  const QString words = screen_->findChild<QLabel*>("scaleWords")->text();
  QVERIFY2(words.startsWith("B0001 has no scale"), qPrintable(words));
  auto& view = *screen_->findChild<SherdView*>("sherd");
  key(Qt::Key_D);
  emit view.pointPicked({0, 0, 0});
  emit view.pointPicked({0, 12, 0});
  QCOMPARE(view.findChild<ViewOverlay*>()->measure(), QLocale().toString(12.0, 'f', 1));
}

OSTRAKA_UI_TEST(ReviewPictureTest)

}  // namespace ostraka::ui

#include "review_picture_test.moc"
