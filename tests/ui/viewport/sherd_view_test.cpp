// The 3D view in a real window: pictures are counted, not compared.
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/core/model/shapes.h"
#include "tests/ui/program.h"
#include "ui/look/distance_scale.h"
#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/viewport/gl_canvas.h"
#include "ui/viewport/shading.h"
#include "ui/viewport/sherd_view.h"
#include "ui/viewport/view_overlay.h"

Q_DECLARE_METATYPE(Eigen::Vector3d)

namespace ostraka::ui {
namespace {

// A disc of 20 mm radius at a height, its edge marked as fracture.
ShownScan disc(float z, float up, float step = 0.4f) {
  ShownScan scan;
  for (float x = -20; x <= 20; x += step)
    for (float y = -20; y <= 20; y += step) {
      const float r = std::hypot(x, y);
      if (r > 20) continue;
      scan.cloud.points.emplace_back(x, y, z);
      scan.cloud.normals.emplace_back(0.0f, 0.0f, up);
      scan.cloud.colors.push_back({150, 150, 150});
      scan.fracture.push_back(r > 15 ? 1 : 0);
      scan.strip_point.push_back(r > 17 ? 0 : r > 16 ? 1 : -1);
    }
  return scan;
}

}  // namespace

class SherdViewTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { prepareOpenGl(); }

 private slots:
  void initTestCase() { qRegisterMetaType<Eigen::Vector3d>("Eigen::Vector3d"); }
  void init();
  void cleanup();
  void bothSidesStandInTheirColours();
  void apartTheBackIsSeenToo();
  void theFractureHasTheColoursOfItsDistances();
  void whatIsNoLongerShownTakesNoRoom();
  void aMeasuredLineIsSeenThroughTheSherd();
  void theSectionCutsHalfAway();
  void theCapOfACutModelIsFlat();
  void theBandOfCutScansHasTheColoursOfTheSides();
  void unseenPartsOfAModelAreHatchedInMagenta();
  void surfelsAreRound();
  void surfelsOfASparseCloudAreWider();
  void noSideIsBlack();
  void theMatteIsTheSameInEveryTheme();
  void manyPointsAreFewerWhileTheyTurn();
  void oneFrameIsDrawnPerTurnAndNoneAtRest();
  void twoClicksGiveTwoPointsOfTheSherd();
  void controlDragTurnsTheBackAboutTheViewersAxis();
  void itSurvivesANewParent();
  void itIsReadyBeforeItIsShown();

 private:
  // Pixels of the picture near a colour's hue and strong enough not to be grey.
  int count(const QColor& colour);
  int notBackground();
  int exactly(const QColor& colour);  ///< pixels of just this colour
  void drag(QEvent::Type type, const QPoint& at);
  QImage picture();
  QOpenGLWidget* canvas() { return view_->findChild<QOpenGLWidget*>("canvas"); }
  QColor of(State state) { return StateColours::onMatte().of(state); }

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

int SherdViewTest::exactly(const QColor& colour) {
  const QImage image = picture();
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) found += image.pixel(x, y) == colour.rgb();
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

void SherdViewTest::theFractureHasTheColoursOfItsDistances() {
  // The front's outermost ring stands out by 0.9 mm, the next one and the back touch nothing.
  const float none = std::numeric_limits<float>::quiet_NaN();
  view_->setDistances({{0.9f, none}, {none, none}, 0.5});
  const QColor back_outside = DistanceScale(0.5).of(0.5);
  QTRY_VERIFY(count(back_outside) > 500);
  QVERIFY2(count(DistanceScale::notSeen()) > 500, "these touch nothing");
  QVERIFY2(count(of(State::Front)) == 0, "what nobody asks for has its own colour");
  view_->setApart(true);  // between the sides one looks at the back's
  QTRY_VERIFY(count(DistanceScale::notSeen()) > 500);
  QVERIFY(count(back_outside) > 300);
  view_->setDistances({});
  QTRY_COMPARE(count(DistanceScale::notSeen()), 0);
}

// The next sherd fills the view, wherever the one before it lay on the plate.
void SherdViewTest::whatIsNoLongerShownTakesNoRoom() {
  QTRY_VERIFY(notBackground() > 10000);
  const int alone = notBackground();
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
  // The ink stands nowhere in the scans, which are shaded.
  const auto ink = [this] {
    const QImage image = picture();
    const QRgb text = StateColours::inkOnMatte().rgb();
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

void SherdViewTest::theCapOfACutModelIsFlat() {
  view_->showModel(model::boxMesh({40, 20, 10}));
  QTRY_VERIFY(notBackground() > 10000);
  QCOMPARE(exactly(capColour()), 0);
  view_->setSection(true);
  QTRY_COMPARE(picture().pixelColor(canvas()->rect().center()), capColour());
  // The plane stands upright on the first view, at 19 degrees to the box's end: 20 / cos 19 = 21.2
  // mm of cap, and beyond it a corner that reaches 5.4 mm farther to the side.
  const double cap = double(exactly(capColour())) / notBackground();
  QVERIFY2(cap > 0.7 && cap < 0.85, qPrintable(QString::number(cap)));
  QVERIFY2(exactly(edgeColour()) > 100, "the outline of the cut");
  // Seen from above, too, where half of the upper face of 40 x 20 mm lies beyond it.
  const QPoint middle = canvas()->rect().center();
  drag(QEvent::MouseButtonPress, middle);
  drag(QEvent::MouseMove, middle + QPoint(60, 60));
  drag(QEvent::MouseButtonRelease, middle + QPoint(60, 60));
  QTRY_VERIFY2(exactly(capColour()) < 0.67 * notBackground(),
               qPrintable(QString::number(double(exactly(capColour())) / notBackground())));
  QVERIFY(exactly(capColour()) > 0.2 * notBackground());
  // Clay is warm: what lies beyond never has the cap's colour, nor has a side's band.
  QVERIFY(capColour().blue() > capColour().red() + 40);
  QVERIFY(capColour().lightness() > of(State::Front).lightness() + 20);
}

void SherdViewTest::theBandOfCutScansHasTheColoursOfTheSides() {
  view_->setSection(true);
  QTRY_VERIFY(exactly(of(State::Front)) > 300);
  QVERIFY(exactly(of(State::Back)) > 300);
  QVERIFY2(exactly(edgeColour()) > 100, "their outline");
}

void SherdViewTest::unseenPartsOfAModelAreHatchedInMagenta() {
  TriangleMesh mesh = model::boxMesh({40, 20, 10});
  view_->showModel(mesh);
  auto* overlay = view_->findChild<ViewOverlay*>();
  QTRY_VERIFY(notBackground() > 10000);
  QCOMPARE(count(DistanceScale::notSeen()), 0);
  QCOMPARE(overlay->legend(), ViewOverlay::Legend::None);
  mesh.seen = {1, 1, 1, 1, 0, 0, 0, 0};  // the upper face
  view_->showModel(mesh);
  QCOMPARE(overlay->legend(), ViewOverlay::Legend::FilledModel);
  QTRY_VERIFY(count(DistanceScale::notSeen()) > 0.2 * notBackground());
  QVERIFY2(count(DistanceScale::notSeen()) < 0.8 * notBackground(), "stripes, and other faces");
}

// A single surfel fills a circle, of its square a share of pi / 4.
void SherdViewTest::surfelsAreRound() {
  ShownScan one;
  one.cloud.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
  one.cloud.normals.assign(4, {0.28f * 0.78f, -0.78f * 0.8f, 0.75f});  // towards the viewer
  one.cloud.colors.assign(4, {200, 200, 200});
  view_->showScans(one, {}, Eigen::Isometry3d::Identity());
  QTRY_VERIFY(notBackground() > 100);
  const QImage image = picture();
  const QRgb ground = image.pixel(2, 2);
  // From the top of the picture down to the first surfel, and what of it is filled.
  QRect box;
  int filled = 0;
  std::vector<QPoint> open;
  for (int y = 0; y < image.height() && open.empty(); ++y)
    for (int x = 0; x < image.width() && open.empty(); ++x)
      if (image.pixel(x, y) != ground) open.emplace_back(x, y);
  QImage seen(image.size(), QImage::Format_Mono);
  seen.fill(0);
  while (!open.empty()) {
    const QPoint p = open.back();
    open.pop_back();
    if (!image.rect().contains(p) || seen.pixelIndex(p) == 1 || image.pixel(p) == ground) continue;
    seen.setPixel(p, 1);
    ++filled;
    box |= QRect(p, p);
    for (const QPoint& step : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
      open.push_back(p + step);
  }
  QVERIFY2(box.width() > 20, qPrintable(QString::number(box.width())));
  const double share = double(filled) / (box.width() * box.height());
  QVERIFY2(std::abs(share - 0.785) < 0.05, qPrintable(QString::number(share)));
}

void SherdViewTest::surfelsOfASparseCloudAreWider() {
  QTRY_VERIFY(notBackground() > 10000);
  const double dense = notBackground();
  view_->showScans(disc(5, 1, 1.6f), disc(0, -1, 1.6f), Eigen::Isometry3d::Identity());
  QTRY_VERIFY(notBackground() > 10000);
  // Sixteen times fewer points cover the same disc without holes.
  QVERIFY2(notBackground() > 0.95 * dense, qPrintable(QString::number(notBackground() / dense)));
}

void SherdViewTest::noSideIsBlack() {
  // Turned towards all sides, a sphere shows every angle to the lights at once.
  TriangleMesh mesh;
  constexpr int kAround = 48;
  for (int i = 0; i <= kAround / 2; ++i)
    for (int j = 0; j < kAround; ++j) {
      const float a = 6.2831853f * static_cast<float>(i) / kAround;
      const float b = 6.2831853f * static_cast<float>(j) / kAround;
      mesh.normals.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      mesh.vertices.push_back(20 * mesh.normals.back());
    }
  for (int i = 0; i < kAround / 2; ++i)
    for (int j = 0; j < kAround; ++j) {
      const int p = i * kAround + j, q = i * kAround + (j + 1) % kAround;
      mesh.triangles.push_back({p, p + kAround, q + kAround});
      mesh.triangles.push_back({p, q + kAround, q});
    }
  mesh.colors.assign(mesh.vertices.size(), {200, 200, 200});
  view_->showModel(mesh);
  QTRY_VERIFY(notBackground() > 10000);
  const QImage image = picture();
  int darkest = 255, lightest = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixel(x, y) == image.pixel(2, 2)) continue;
      darkest = std::min(darkest, qGray(image.pixel(x, y)));
      lightest = std::max(lightest, qGray(image.pixel(x, y)));
    }
  QVERIFY2(darkest > 45, qPrintable(QString::number(darkest)));  // the matte has 40
  QVERIFY2(lightest > 2 * darkest, "and yet its form is seen");
}

void SherdViewTest::theMatteIsTheSameInEveryTheme() {
  for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Sunlight}) {
    applyLook(*qApp, theme, 100);
    QTRY_COMPARE(picture().pixelColor(2, 2), StateColours::matte());
  }
  applyLook(*qApp, Theme::Light, 100);
}

void SherdViewTest::drag(QEvent::Type type, const QPoint& at) {
  const bool move = type == QEvent::MouseMove;
  QMouseEvent event(type, at, canvas()->mapToGlobal(at), move ? Qt::NoButton : Qt::LeftButton,
                    type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
  QCoreApplication::sendEvent(canvas(), &event);
}

// 125,000 points a side: in software that takes longer than a frame may.
void SherdViewTest::manyPointsAreFewerWhileTheyTurn() {
  view_->showScans(disc(5, 1, 0.1f), disc(0, -1, 0.1f), Eigen::Isometry3d::Identity());
  QTRY_VERIFY(notBackground() > 10000);
  const QPoint middle = canvas()->rect().center();
  drag(QEvent::MouseButtonPress, middle);
  drag(QEvent::MouseMove, middle + QPoint(1, 0));
  drag(QEvent::MouseMove, middle);  // where it was
  const QImage turning = picture();
  const double covered = double(notBackground());
  drag(QEvent::MouseButtonRelease, middle);
  QTRY_VERIFY2(picture() != turning, "all points are drawn again");
  QVERIFY2(covered > 0.97 * notBackground(), "wider ones, without holes");
}

void SherdViewTest::oneFrameIsDrawnPerTurnAndNoneAtRest() {
  QTRY_VERIFY(notBackground() > 10000);
  QTest::qWait(1000);  // the view has made itself ready
  QSignalSpy drawn(static_cast<GlCanvas*>(canvas()), &GlCanvas::rendered);
  QTest::qWait(500);
  QCOMPARE(drawn.count(), 0);
  const QPoint middle = canvas()->rect().center();
  drag(QEvent::MouseButtonPress, middle);
  for (int i = 1; i <= 5; ++i) {
    drag(QEvent::MouseMove, middle + QPoint(10 * i, 0));
    QTRY_COMPARE(drawn.count(), i);
    QTest::qWait(50);
  }
  QVERIFY2(drawn.count() == 5, "what is written over it needs no second frame");
  drag(QEvent::MouseButtonRelease, middle + QPoint(50, 0));
  QTRY_COMPARE(drawn.count(), 6);  // all points again
  QTest::qWait(500);
  QCOMPARE(drawn.count(), 6);
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

OSTRAKA_UI_TEST(SherdViewTest)

}  // namespace ostraka::ui

#include "sherd_view_test.moc"
