#include "ui/viewport/sherd_view.h"

#include <QEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/frame/state_colours.h"
#include "ui/viewport/gl_canvas.h"
#include "ui/viewport/sherd_scene.h"
#include "ui/viewport/view_overlay.h"

namespace ostraka::ui {
namespace {

// When the window is usable and nobody has asked for a view yet.
constexpr int kIdle_ms = 700, kBetweenSteps_ms = 100;

Rgb rgb(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

SherdScene::Look lookOf(const QPalette& palette) {
  const StateColours colours(palette);
  return {rgb(palette.color(QPalette::Base)), rgb(palette.color(QPalette::Text)),
          rgb(colours.of(State::Front)), rgb(colours.of(State::Back))};
}

}  // namespace

void prepareOpenGl() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setAlphaBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  // With EGL, and so on Wayland, VTK complains in each frame; GLX is right.
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && !qEnvironmentVariableIsEmpty("DISPLAY"))
    qputenv("QT_QPA_PLATFORM", "xcb");
}

void reserveOpenGl(QWidget& window) {
  if (!GlCanvas::isPossible()) return;
  // Qt asks all children, hidden ones too, what kind of surface the window needs.
  auto* nothing = new QOpenGLWidget(&window);
  nothing->setObjectName("reservesOpenGl");
  nothing->setFocusPolicy(Qt::NoFocus);
  nothing->hide();
}

SherdView::SherdView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Sherd in three dimensions"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (!GlCanvas::isPossible()) {
    auto* words = new QLabel(tr("This screen has no OpenGL 3.2, so the sherd cannot be shown in "
                                "three dimensions. Everything else works; photographs and outlines "
                                "are beside."),
                             this);
    words->setObjectName("noOpenGl");
    words->setWordWrap(true);
    words->setAlignment(Qt::AlignCenter);
    layout->addWidget(words);
    return;
  }
  canvas_ = new GlCanvas(this);
  canvas_->setObjectName("canvas");
  layout->addWidget(canvas_);
  overlay_ = new ViewOverlay(canvas_);
  canvas_->scene().setLook(lookOf(palette()));
  connect(canvas_, &GlCanvas::rendered, this,
          [this] { overlay_->setScale(canvas_->mmPerPixel()); });
  connect(canvas_, &GlCanvas::clicked, this,
          [this](double x, double y, double z) { emit pointPicked(Eigen::Vector3d(x, y, z)); });
  connect(canvas_, &GlCanvas::draggedWithControl, this,
          [this](double a, double b, double c, double x, double y, double z) {
            emit backMoved(Eigen::Vector3d(a, b, c), Eigen::Vector3d(x, y, z));
          });
  connect(canvas_, &GlCanvas::releasedWithControl, this, &SherdView::backReleased);
  auto* idle = new QTimer(this);
  idle->setSingleShot(true);
  connect(idle, &QTimer::timeout, this, [this, idle] {
    if (canvas_->warmUp()) idle->start(kBetweenSteps_ms);
  });
  idle->start(kIdle_ms);
}

SherdView::~SherdView() = default;

void SherdView::clear() {
  if (canvas_ == nullptr) return;
  canvas_->scene().clear();
  overlay_->setLegend(ViewOverlay::Legend::None);
  overlay_->setMeasure({});
  canvas_->update();
}

void SherdView::showScans(const ShownScan& front, const ShownScan& back,
                          const Eigen::Isometry3d& front_from_back) {
  if (canvas_ == nullptr) return;
  setSection(false);
  SherdScene& scene = canvas_->scene();
  scene.clear();
  scene.setFront(front.cloud, front.rim);
  scene.setBack(back.cloud, back.rim);
  scene.setPose(front_from_back);
  scene.setApart(apart_);
  scene.resetView();
  overlay_->setNote({});
  overlay_->setMeasure({});
  overlay_->setLegend(ViewOverlay::Legend::Sides);
  canvas_->update();
}

void SherdView::setPose(const Eigen::Isometry3d& front_from_back) {
  if (canvas_ == nullptr) return;
  canvas_->scene().setPose(front_from_back);
  canvas_->update();
}

void SherdView::setRim(const ShownRim& rim) {
  if (canvas_ == nullptr) return;
  const StateColours colours(palette());
  std::vector<Rgb> shown;
  for (const float distance : rim.distance_mm)
    shown.push_back(rgb(colours.alongRim(std::min(1.0, std::abs(distance) / rim.reach_mm))));
  canvas_->scene().setRim(rim.points, shown);
  overlay_->setLegend(rim.points.empty() ? ViewOverlay::Legend::Sides : ViewOverlay::Legend::Rim,
                      rim.reach_mm);
  canvas_->update();
}

void SherdView::showModel(const TriangleMesh& model) {
  if (canvas_ == nullptr) return;
  setSection(false);
  canvas_->scene().setModel(model);
  canvas_->scene().resetView();
  overlay_->setNote({});
  overlay_->setMeasure({});
  overlay_->setLegend(ViewOverlay::Legend::None);
  canvas_->update();
}

void SherdView::setNote(const QString& note) {
  if (overlay_ != nullptr) overlay_->setNote(note);
}

void SherdView::setUnitKnown(bool known) {
  if (overlay_ != nullptr) overlay_->setUnitKnown(known);
}

void SherdView::setMeasure(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const QString& text) {
  if (canvas_ == nullptr) return;
  canvas_->scene().setMeasure(a, b, !text.isEmpty());
  overlay_->setMeasure(text);
  canvas_->update();
}

void SherdView::setApart(bool apart) {
  if (apart_ == apart) return;
  apart_ = apart;
  if (canvas_ != nullptr) {
    canvas_->scene().setApart(apart);
    canvas_->scene().fitView();
    canvas_->update();
  }
  emit apartChanged(apart);
}

void SherdView::setSection(bool section) {
  if (section_ == section) return;
  section_ = section;
  if (canvas_ != nullptr) {
    canvas_->scene().setSection(section);
    canvas_->update();
  }
  emit sectionChanged(section);
}

void SherdView::setMeasuring(bool measuring) {
  if (measuring_ == measuring) return;
  measuring_ = measuring;
  if (canvas_ != nullptr) {
    canvas_->setPicking(measuring);
    canvas_->setCursor(measuring ? Qt::CrossCursor : Qt::ArrowCursor);
    if (!measuring) setMeasure({}, {}, {});
  }
  emit measuringChanged(measuring);
}

void SherdView::resetView() {
  if (canvas_ == nullptr) return;
  canvas_->scene().resetView();
  canvas_->update();
}

void SherdView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeOverlay();
}

void SherdView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || canvas_ == nullptr) return;
  canvas_->scene().setLook(lookOf(palette()));
  canvas_->update();
}

void SherdView::placeOverlay() {
  if (overlay_ != nullptr) overlay_->setGeometry(rect());
}

}  // namespace ostraka::ui
