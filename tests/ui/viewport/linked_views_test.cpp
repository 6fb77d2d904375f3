// Two sherds beside each other, in a real window.
#include "ui/viewport/linked_views.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QTest>

#include "tests/core/model/shapes.h"
#include "tests/ui/program.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

class LinkedViewsTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { prepareOpenGl(); }

 private slots:
  void init() {
    window_ = std::make_unique<QWidget>();
    window_->resize(700, 300);
    auto* row = new QHBoxLayout(window_.get());
    links_ = new LinkedViews(window_.get());
    for (std::size_t i = 0; i < 2; ++i) {
      views_[i] = new SherdView(window_.get());
      row->addWidget(views_[i]);
    }
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QVERIFY2(views_[0]->hasOpenGl(), "this test needs the virtual screen with GLX");
    views_[0]->showModel(model::boxMesh({40, 30, 6}));
    views_[1]->showModel(model::boxMesh({20, 15, 6}));
    for (std::size_t i = 0; i < 2; ++i) links_->setView(i, views_[i]);
    links_->reset();
  }
  void cleanup() { window_.reset(); }

  void bothHaveTheScaleOfTheLarger() {
    const double half_height_mm = pose(0).half_height_mm;
    QVERIFY2(half_height_mm > 10 && half_height_mm < 60, "as high as the larger one needs");
    QCOMPARE(pose(1).half_height_mm, half_height_mm);
    QVERIFY(views_[1]->turnByKey(Qt::Key_Plus));
    QCOMPARE(pose(0).half_height_mm, half_height_mm / 1.2);
    links_->setTogether(false);
    QVERIFY(views_[0]->turnByKey(Qt::Key_Minus));
    QVERIFY(std::abs(pose(1).half_height_mm - half_height_mm) < 1e-9);
  }

  void whatTurnsOneTurnsTheOther() {
    const Eigen::Matrix3d before = pose(1).view_from_front;
    QVERIFY(views_[0]->turnByKey(Qt::Key_Right));
    QVERIFY(views_[0]->turnByKey(Qt::Key_Up));
    QVERIFY(!pose(1).view_from_front.isApprox(before, 0.01));
    QVERIFY(pose(1).view_from_front.isApprox(pose(0).view_from_front, 1e-6));
    QVERIFY2(!views_[0]->turnByKey(Qt::Key_X), "no key of the view");
  }

  void oneThatWasTurnedAloneKeepsItsPlaceAgainstTheOther() {
    const Eigen::Matrix3d before = pose(0).view_from_front;
    links_->setTogether(false);
    for (int i = 0; i < 9; ++i) QVERIFY(views_[1]->turnByKey(Qt::Key_Left));  // a quarter turn
    QVERIFY(pose(0).view_from_front.isApprox(before, 1e-9));
    const Eigen::Matrix3d second_from_first =
        pose(1).view_from_front * pose(0).view_from_front.transpose();
    links_->setTogether(true);
    // About one axis the order of turns does not count.
    for (int i = 0; i < 3; ++i) QVERIFY(views_[0]->turnByKey(Qt::Key_Right));
    QVERIFY(!pose(0).view_from_front.isApprox(before, 0.01));
    const Eigen::Matrix3d now = pose(1).view_from_front * pose(0).view_from_front.transpose();
    QVERIFY(now.isApprox(second_from_first, 1e-6));
    links_->reset();
    QVERIFY(pose(1).view_from_front.isApprox(pose(0).view_from_front, 1e-6));
  }

  void bothAreCutAtOnce() {
    const Eigen::Matrix3d before = pose(0).view_from_front;
    links_->setSection(true);
    QVERIFY(views_[0]->hasSection() && views_[1]->hasSection());
    QVERIFY(pose(1).view_from_front.isApprox(pose(0).view_from_front, 1e-6));
    links_->setSection(false);
    QVERIFY(!views_[0]->hasSection() && !views_[1]->hasSection());
    QVERIFY(pose(0).view_from_front.isApprox(before, 1e-6));
    QVERIFY(pose(1).view_from_front.isApprox(before, 1e-6));
  }

  void aResizedWindowKeepsTheScale() {
    const double half_height_mm = pose(0).half_height_mm;
    window_->resize(700, 500);
    QTRY_VERIFY(views_[1]->height() > 400);
    QTest::qWait(50);
    QCOMPARE(pose(0).half_height_mm, half_height_mm);
    QCOMPARE(pose(1).half_height_mm, half_height_mm);
  }

 private:
  ViewPose pose(std::size_t i) const { return views_[i]->viewPose(); }

  std::unique_ptr<QWidget> window_;
  std::array<SherdView*, 2> views_{};
  LinkedViews* links_ = nullptr;
};

OSTRAKA_UI_TEST(LinkedViewsTest)

}  // namespace ostraka::ui

#include "linked_views_test.moc"
