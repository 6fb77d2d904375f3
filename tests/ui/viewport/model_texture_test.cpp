// A model with a picture on it, in a real window: pixels are counted, pictures not compared.
#include <QOpenGLWidget>
#include <QTest>
#include <cmath>

#include "tests/core/model/shapes.h"
#include "tests/ui/program.h"
#include "ui/look/distance_scale.h"
#include "ui/viewport/shading.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {
namespace {

const QColor kOwn(0, 160, 160);  // of the vertices

// Upwards; the picture's corners are its own.
TriangleMesh square() {
  TriangleMesh mesh;
  mesh.vertices = {{-20, 20, 0}, {20, 20, 0}, {20, -20, 0}, {-20, -20, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.colors.assign(4, {0, 160, 160});
  mesh.triangles = {{0, 3, 2}, {0, 2, 1}};
  return mesh;
}

// Red and green above blue and yellow.
ShownTexture quarters(std::size_t vertices) {
  QImage picture(62, 40, QImage::Format_RGB32);  // whose rows of three bytes a pixel are padded
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      picture.setPixelColor(
          x, y, y < 20 ? (x < 31 ? Qt::red : Qt::green) : (x < 31 ? Qt::blue : Qt::yellow));
  std::vector<Eigen::Vector2f> uv(vertices, {0, 0});
  uv[1] = {1, 0};
  uv[2] = {1, 1};
  uv[3] = {0, 1};
  return {picture, uv};
}

}  // namespace

class ModelTextureTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { prepareOpenGl(); }

 private slots:
  void init();
  void cleanup() { view_.reset(); }
  void aModelHasTheColoursOfItsTexture();
  void theNextModelHasNothingOfIt();
  void itSurvivesANewParent();
  void aModelWithoutATextureHasItsOwnColours();
  void theTextureChangesNeitherCapNorHatching();

 private:
  struct Seen {
    double share = 0;  // of the model's pixels
    QPointF middle;
  };
  Seen seen(const QColor& colour);
  bool showsAllQuarters();
  QOpenGLWidget* canvas() { return view_->findChild<QOpenGLWidget*>("canvas"); }

  std::unique_ptr<SherdView> view_;
};

void ModelTextureTest::init() {
  view_ = std::make_unique<SherdView>();
  view_->resize(500, 400);
  view_->show();
  QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  QVERIFY2(view_->hasOpenGl(), "this test needs the virtual screen with GLX");
}

// Light makes colours darker, and leaves their hue.
ModelTextureTest::Seen ModelTextureTest::seen(const QColor& colour) {
  canvas()->update();
  const QImage image = canvas()->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
  int all = 0, found = 0;
  QPointF sum;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixel(x, y) == image.pixel(2, 2)) continue;
      ++all;
      const QColor c = image.pixelColor(x, y);
      const int apart = std::abs(c.hue() - colour.hue());
      if (c.saturation() < 90 || std::min(apart, 360 - apart) > 10) continue;
      sum += QPointF(x, y);
      ++found;
    }
  if (all < 10000) return {};
  return {double(found) / all, sum / std::max(1, found)};
}

bool ModelTextureTest::showsAllQuarters() {
  for (const Qt::GlobalColor colour : {Qt::red, Qt::green, Qt::blue, Qt::yellow})
    if (seen(colour).share < 0.2) return false;
  return seen(kOwn).share < 0.01;
}

void ModelTextureTest::aModelHasTheColoursOfItsTexture() {
  view_->showModel(square(), quarters(4));
  QTRY_VERIFY(showsAllQuarters());
  QVERIFY2(seen(Qt::red).middle.x() < seen(Qt::green).middle.x(), "left in the picture is left");
  QVERIFY2(seen(Qt::red).middle.y() < seen(Qt::blue).middle.y(), "and above is above");
}

void ModelTextureTest::theNextModelHasNothingOfIt() {
  view_->showModel(square(), quarters(4));
  QTRY_VERIFY(showsAllQuarters());
  view_->showModel(square());
  QTRY_VERIFY(seen(kOwn).share > 0.95);
  view_->showModel(square(), quarters(4));
  QTRY_VERIFY(showsAllQuarters());
}

// Another context: the picture goes to the graphics card once more.
void ModelTextureTest::itSurvivesANewParent() {
  view_->showModel(square(), quarters(4));
  QTRY_VERIFY(showsAllQuarters());
  QWidget other;
  other.resize(500, 400);
  view_->setParent(&other);
  view_->show();
  other.show();
  QVERIFY(QTest::qWaitForWindowExposed(&other));
  QTRY_VERIFY(showsAllQuarters());
  view_->setParent(nullptr);
  view_->hide();
}

void ModelTextureTest::aModelWithoutATextureHasItsOwnColours() {
  ShownTexture none = quarters(4);
  none.picture = {};
  view_->showModel(square(), none);
  QTRY_VERIFY(seen(kOwn).share > 0.95);
  view_->showModel(square(), quarters(5));  // of another mesh
  QTRY_VERIFY(seen(kOwn).share > 0.95);
}

void ModelTextureTest::theTextureChangesNeitherCapNorHatching() {
  TriangleMesh mesh = model::boxMesh({40, 20, 10});
  mesh.seen = {1, 1, 1, 1, 0, 0, 0, 0};  // all but the upper face
  view_->showModel(mesh, quarters(8));
  QTRY_VERIFY(seen(DistanceScale::notSeen()).share > 0.2);
  view_->setSection(true);
  QTRY_COMPARE(canvas()->grabFramebuffer().pixelColor(canvas()->rect().center()), capColour());
}

OSTRAKA_UI_TEST(ModelTextureTest)

}  // namespace ostraka::ui

#include "model_texture_test.moc"
