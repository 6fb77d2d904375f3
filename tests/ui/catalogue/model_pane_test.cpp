// The chosen sherd's model as its photographs show it.
#include "ui/catalogue/model_pane.h"

#include <QOpenGLWidget>
#include <QToolButton>

#include "catalogue_window.h"
#include "cloud/glb.h"
#include "images/jpeg_image.h"
#include "tests/ui/program.h"
#include "texture/texture.h"

using namespace ostraka;
using namespace ostraka::ui;

class ModelPaneTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void theModelIsShownWithItsPhotographs() {
    sample_->giveModel(0);
    const TriangleMesh mesh = exchange::closedShell();
    GlbTexture blue;
    blue.uv.assign(mesh.vertices.size(), {0.5f, 0.5f});
    blue.jpeg = images::encodedJpeg(cv::Mat3b(16, 16, cv::Vec3b(220, 30, 30)));
    QVERIFY(writeGlb(besideModel(0), formatGlb(mesh, blue, {})).has_value());
    choose(0);
    QTRY_VERIFY(child<ModelPane>("model")->showsModel());
    QTRY_VERIFY(blueShare() > 0.95);
  }

  void withoutThemItHasItsOwnColours() {
    sample_->giveModel(0);
    choose(0);
    QTRY_VERIFY(child<ModelPane>("model")->showsModel());
    QTRY_COMPARE(blueShare(), 0.0);
  }

  void whatCannotBeReadBesideTheModelIsLeftOut() {
    sample_->giveModel(0);
    QVERIFY(writeFileAtomically(besideModel(0), "no model").has_value());
    choose(0);
    QTRY_VERIFY(child<ModelPane>("model")->showsModel());
    QTRY_COMPARE(blueShare(), 0.0);
  }

  void theModelCanBeAsLargeAsThePage() {
    sample_->giveModel(0);
    choose(0);
    auto* pane = child<ModelPane>("model");
    QTRY_VERIFY(pane->showsModel());
    const QSize beside = pane->size();
    QVERIFY2(beside.height() >= 200, qPrintable(QString::number(beside.height())));
    auto* large = child<QToolButton>("modelLarge");
    QTest::mouseClick(large, Qt::LeftButton);
    QTRY_VERIFY(pane->width() > 2 * beside.width() && pane->height() > 1.5 * beside.height());
    QVERIFY(!table()->isVisible());
    QTest::keyClick(large, Qt::Key_Escape);
    QTRY_COMPARE(pane->size(), beside);
    QVERIFY(table()->isVisible());
  }

 private:
  std::filesystem::path besideModel(int sherd) {
    return sample_->session().folder() / "results/B0001/sherds" / std::to_string(sherd) /
           "model.glb";
  }
  // Of the model's pixels; -1: it is not there yet.
  double blueShare() {
    const QImage shown = child<QOpenGLWidget>("canvas")->grabFramebuffer();
    int blue = 0, sherd = 0;
    for (int y = 0; y < shown.height(); ++y)
      for (int x = 0; x < shown.width(); ++x) {
        const QColor pixel = shown.pixelColor(x, y);
        if (pixel.saturation() <= 90) continue;
        ++sherd;
        blue += pixel.blue() > 2 * pixel.red();
      }
    return sherd < 1000 ? -1 : double(blue) / sherd;
  }
};

OSTRAKA_UI_TEST(ModelPaneTest)
#include "model_pane_test.moc"
