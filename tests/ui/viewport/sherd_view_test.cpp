// The 3D view in a real window: pictures are counted, not compared.
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "ui/frame/state_colours.h"
#include "ui/viewport/gl_canvas.h"
#include "ui/viewport/sherd_view.h"

Q_DECLARE_METATYPE(Eigen::Vector3d)

namespace ostraka::ui {
namespace {

// A disc of 20 mm radius at a height, its edge marked as rim.
ShownScan disc(float z, float up) {
  ShownScan scan;
  for (float x = -20; x <= 20; x += 0.4f)
    for (float y = -20; y <= 20; y += 0.4f) {
      const float r = std::hypot(x, y);
      if (r > 20) continue;
      scan.cloud.points.emplace_back(x, y, z);
      scan.cloud.normals.emplace_back(0.0f, 0.0f, up);
      scan.cloud.colors.push_back({150, 150, 150});
      scan.rim.push_back(r > 15 ? 1 : 0);
    }
  return scan;
}

}  // namespace

class SherdViewTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void cleanup();
  void bothSidesStandInTheirColours();
  void apartTheBackIsSeenToo();
  void theRimIsColouredByItsGap();
  void whatIsNoLongerShownTakesNoRoom();
  void aMeasuredLineIsSeenThroughTheSherd();
  void theSectionCutsHalfAway();
  void twoClicksGiveTwoPointsOfTheSherd();
  void controlDragTurnsTheBackAboutTheViewersAxis();
  void itSurvivesANewParent();
  void itIsReadyBeforeItIsShown();

 private:
  // Pixels of the picture near a colour's hue and strong enough not to be grey.
  int count(const QColor& colour);
  int notBackground();
  QImage picture();
  QOpenGLWidget* canvas() { return view_->findChild<QOpenGLWidget*>("canvas"); }
  QColor of(State state) { return StateColours(view_->palette()).of(state); }

  std::unique_ptr<SherdView> view_;
};

void SherdViewTest::init() {
  view_ = std::make_unique<SherdView>();
  view_->resize(500, 400);
  view_->show();
  QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  QVERIFY2(view_->hasOpenGl(), "this test needs the virtual screen with GLX");
  view_->showScans(disc(5, 1), disc(0, -1), Eigen::Isometry3d::Identity());
}

void SherdViewTest::cleanup() {
  view_.reset();
}

QImage SherdViewTest::picture() {
  canvas()->update();
  return canvas()->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

int SherdViewTest::count(const QColor& colour) {
  const QImage image = picture();
  int found = 0;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2) {
      const QColor c = image.pixelColor(x, y);
      const int apart = std::abs(c.hue() - colour.hue());
      found += 4 * (c.saturation() > 90 && c.hue() >= 0 && std::min(apart, 360 - apart) < 14);
    }
  return found;
}

int SherdViewTest::notBackground() {
  const QImage image = picture();
  const QRgb ground = image.pixel(2, 2);
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) found += image.pixel(x, y) != ground;
  return found;
}

void SherdViewTest::bothSidesStandInTheirColours() {
  QTRY_VERIFY(count(of(State::Front)) > 3000);
  const int back = count(of(State::Back));
  QVERIFY2(back > 100, "from obliquely above the back's rim shows below the front");
}

void SherdViewTest::apartTheBackIsSeenToo() {
  QTRY_VERIFY(notBackground() > 10000);
  const auto shareOfBack = [this] { return double(count(of(State::Back))) / notBackground(); };
  const double together = shareOfBack();
  view_->setApart(true);  // the view is fitted anew, so only shares compare
  QTRY_VERIFY(shareOfBack() > 1.05 * together);
}

void SherdViewTest::theRimIsColouredByItsGap() {
  ShownRim rim;
  for (int i = 0; i < 2000; ++i) {
    const float a = 0.003141f * static_cast<float>(i);
    rim.points.emplace_back(19 * std::cos(a), 19 * std::sin(a), 5.5f);
    rim.distance_mm.push_back(0.9f);
  }
  rim.reach_mm = 0.5;
  view_->setRim(rim);
  const QColor far = StateColours(view_->palette()).alongRim(1);
  QTRY_VERIFY(count(far) > 500);
  view_->setRim({});
  QTRY_COMPARE(count(far), 0);
}

// The next sherd fills the view, wherever the one before it lay on the plate.
void SherdViewTest::whatIsNoLongerShownTakesNoRoom() {
  QTRY_VERIFY(notBackground() > 10000);
  const int alone = notBackground();
  ShownRim rim;
  rim.points = {{200, 0, 5}, {200, 10, 5}};
  rim.distance_mm = {0.1f, 0.2f};
  view_->setRim(rim);
  view_->setRim({});
  TriangleMesh mesh;
  mesh.vertices = {{-200, 0, 0}, {-190, 0, 0}, {-190, 10, 0}};
  mesh.triangles = {{0, 1, 2}};
  view_->showModel(mesh);
  QTRY_VERIFY(notBackground() > 0);
  view_->showScans(disc(5, 1), disc(0, -1), Eigen::Isometry3d::Identity());
  QTRY_VERIFY(notBackground() > 0.98 * alone);
}

void SherdViewTest::aMeasuredLineIsSeenThroughTheSherd() {
  QTRY_VERIFY(notBackground() > 10000);
  // The ink of the palette's text stands nowhere in the scans, which are shaded.
  const auto ink = [this] {
    const QImage image = picture();
    const QRgb text = view_->palette().color(QPalette::Text).rgb();
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) found += image.pixel(x, y) == text;
    return found;
  };
  const int before = ink();
  view_->setMeasure({-15, 0, 2}, {15, 0, 2}, "30 mm");  // between the faces, hidden by the front
  QTRY_VERIFY(ink() > before + 100);
  view_->setMeasure({}, {}, {});
  QTRY_COMPARE(ink(), before);
}

void SherdViewTest::theSectionCutsHalfAway() {
  QTRY_VERIFY(notBackground() > 10000);
  const int whole = notBackground();
  view_->setSection(true);
  QTRY_VERIFY(notBackground() < 0.7 * whole);
  // One looks at the cut: 40 mm long and 5 mm thick.
  const auto shape = [this] {
    const QImage image = picture();
    QRect ink;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixel(x, y) != image.pixel(2, 2)) ink |= QRect(x, y, 1, 1);
    return ink;
  };
  QVERIFY(shape().width() > 4 * shape().height());
  QVERIFY(shape().height() > 10);
  view_->setSection(false);
  QTRY_VERIFY(notBackground() > 0.95 * whole);
}

void SherdViewTest::twoClicksGiveTwoPointsOfTheSherd() {
  QTRY_VERIFY(notBackground() > 10000);
  QSignalSpy picked(view_.get(), &SherdView::pointPicked);
  const QPoint middle = canvas()->rect().center();
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, middle);
  QCOMPARE(picked.count(), 0);  // only while measuring
  view_->setMeasuring(true);
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, middle);
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, middle + QPoint(60, 0));
  QCOMPARE(picked.count(), 2);
  for (const QList<QVariant>& arguments : picked) {
    const auto p = arguments.at(0).value<Eigen::Vector3d>();
    QVERIFY2(p.head<2>().norm() <= 20.5, "on the disc");
    QVERIFY(std::abs(p.z() - 5) < 0.5 || std::abs(p.z()) < 0.5);
  }
}

void SherdViewTest::controlDragTurnsTheBackAboutTheViewersAxis() {
  QTRY_VERIFY(notBackground() > 10000);
  Eigen::Vector3d turned = Eigen::Vector3d::Zero(), moved = turned;
  connect(view_.get(), &SherdView::backMoved, this,
          [&](const Eigen::Vector3d& turn, const Eigen::Vector3d& move) {
            turned += turn;
            moved += move;
          });
  // A quarter of a circle around the middle, clockwise on the screen.
  const QPoint middle = canvas()->rect().center();
  QTest::mousePress(canvas(), Qt::LeftButton, Qt::ControlModifier, middle + QPoint(100, 0));
  for (int i = 1; i <= 10; ++i) {
    const double a = i * 1.570796 / 10;
    QMouseEvent move(QEvent::MouseMove, middle + QPointF(100 * std::cos(a), 100 * std::sin(a)),
                     canvas()->mapToGlobal(middle), Qt::NoButton, Qt::LeftButton,
                     Qt::ControlModifier);
    QCoreApplication::sendEvent(canvas(), &move);
  }
  QTest::mouseRelease(canvas(), Qt::LeftButton, Qt::ControlModifier, middle + QPoint(0, 100));
  QVERIFY2(std::abs(turned.norm() - 1.570796) < 0.05, qPrintable(QString::number(turned.norm())));
  QCOMPARE(moved.norm(), 0.0);
  // The viewer looks down: clockwise for him is a turn about what points away from him.
  QVERIFY(turned.z() < 0);
}

void SherdViewTest::itSurvivesANewParent() {
  QTRY_VERIFY(notBackground() > 10000);
  QWidget other;
  other.resize(420, 320);
  view_->setParent(&other);
  view_->show();
  other.show();
  QVERIFY(QTest::qWaitForWindowExposed(&other));
  QTRY_VERIFY(notBackground() > 5000);
  view_->setParent(nullptr);
  view_->hide();
}

// Hidden in a window that is shown: by the time somebody asks, the driver's context is there and a
// first picture was drawn.
void SherdViewTest::itIsReadyBeforeItIsShown() {
  QWidget window;
  window.resize(500, 400);
  reserveOpenGl(window);
  auto* hidden = new SherdView(&window);
  hidden->resize(500, 400);
  hidden->showScans(disc(5, 1), disc(0, -1), Eigen::Isometry3d::Identity());
  hidden->hide();
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  auto* canvas = hidden->findChild<QOpenGLWidget*>("canvas");
  QSignalSpy drawn(static_cast<GlCanvas*>(canvas), &GlCanvas::rendered);
  QVERIFY(!canvas->isValid());
  QTRY_COMPARE(drawn.count(), 1);
  QVERIFY(canvas->isValid());
  QVERIFY(!canvas->isVisible());
  const QOpenGLContext* context = canvas->context();
  hidden->show();
  QTRY_VERIFY(drawn.count() > 1);
  QCOMPARE(canvas->context(), context);
  const QImage shown = canvas->grabFramebuffer();
  QVERIFY(shown.pixel(2, 2) != shown.pixel(shown.rect().center()));
}

}  // namespace ostraka::ui

int main(int argc, char** argv) {
  ostraka::ui::prepareOpenGl();
  QApplication application(argc, argv);
  qRegisterMetaType<Eigen::Vector3d>("Eigen::Vector3d");
  ostraka::ui::SherdViewTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "sherd_view_test.moc"
