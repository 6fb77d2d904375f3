#include "ui/viewport/sherd_view.h"

#include <QLabel>
#include <QResizeEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/distance_scale.h"
#include "ui/viewport/gl_canvas.h"
#include "ui/viewport/view_overlay.h"

namespace ostraka::ui {
namespace {

// When the window is usable and nobody has asked for a view yet.
constexpr int kIdle_ms = 700, kBetweenSteps_ms = 100;
constexpr double kTurn_rad = 0.1745, kZoom = 1.2;  // of one key: 10 degrees

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
  connect(canvas_, &GlCanvas::viewChanged, this, &SherdView::showView);
  connect(canvas_, &GlCanvas::clicked, this, &SherdView::pointPicked);
  connect(canvas_, &GlCanvas::draggedWithControl, this, &SherdView::backMoved);
  auto* idle = new QTimer(this);
  idle->setSingleShot(true);
  connect(idle, &QTimer::timeout, this, [this, idle] {
    if (canvas_->warmUp()) idle->start(kBetweenSteps_ms);
  });
  idle->start(kIdle_ms);
}

void SherdView::clear() {
  if (canvas_ == nullptr) return;
  canvas_->scene().clear();
  overlay_->setLegend(ViewOverlay::Legend::None);
  overlay_->setMeasure({});
  canvas_->redraw();
}

void SherdView::showScans(const ShownScan& front, const ShownScan& back,
                          const Eigen::Isometry3d& front_from_back) {
  if (canvas_ == nullptr) return;
  setSection(false);
  SherdScene& scene = canvas_->scene();
  scene.clear();
  scene.setSides(front, back);
  scene.setPose(front_from_back);
  scene.setApart(apart_);
  scene.resetView();
  overlay_->setMeasure({});
  overlay_->setLegend(ViewOverlay::Legend::Sides);
  canvas_->redraw();
}

void SherdView::setPose(const Eigen::Isometry3d& front_from_back) {
  if (canvas_ == nullptr) return;
  canvas_->scene().setPose(front_from_back);
  canvas_->redraw();
}

void SherdView::setDistances(const ShownDistances& distances) {
  if (canvas_ == nullptr) return;
  canvas_->scene().setDistances(distances.front_mm, distances.back_mm,
                                DistanceScale(distances.reach_mm));
  overlay_->setLegend(distances.front_mm.empty() && distances.back_mm.empty()
                          ? ViewOverlay::Legend::Sides
                          : ViewOverlay::Legend::Distances,
                      distances.reach_mm);
  canvas_->redraw();
}

void SherdView::showModel(const TriangleMesh& model, const ShownTexture& texture) {
  if (canvas_ == nullptr) return;
  setSection(false);
  canvas_->scene().setModel(model, texture);
  canvas_->scene().resetView();
  overlay_->setMeasure({});
  const bool filled = std::find(model.seen.begin(), model.seen.end(), 0) != model.seen.end();
  overlay_->setLegend(filled ? ViewOverlay::Legend::FilledModel : ViewOverlay::Legend::None);
  canvas_->redraw();
}

void SherdView::setUnitKnown(bool known) {
  if (overlay_ != nullptr) overlay_->setUnitKnown(known);
}

void SherdView::setMeasure(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const QString& text) {
  if (canvas_ == nullptr) return;
  canvas_->scene().setMeasure(a, b, !text.isEmpty());
  overlay_->setMeasure(text);
  canvas_->redraw();
}

void SherdView::setApart(bool apart) {
  if (apart_ == apart) return;
  apart_ = apart;
  if (canvas_ != nullptr) {
    canvas_->scene().setApart(apart);
    canvas_->scene().fitView();
    canvas_->redraw();
  }
}

void SherdView::setSection(bool section) {
  if (section_ == section) return;
  section_ = section;
  if (canvas_ != nullptr) {
    canvas_->scene().setSection(section);
    canvas_->redraw();
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
}

ViewPose SherdView::viewPose() const {
  return canvas_ == nullptr ? ViewPose() : canvas_->scene().viewPose();
}

void SherdView::setViewPose(const ViewPose& pose) {
  if (canvas_ == nullptr) return;
  canvas_->scene().setViewPose(pose);
  canvas_->redrawMoving();
}

bool SherdView::turnByKey(int key) {
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY();
  ViewPose pose = viewPose();
  const auto turn = [&](double angle_rad, const Eigen::Vector3d& axis) {
    pose.view_from_front = Eigen::AngleAxisd(angle_rad, axis) * pose.view_from_front;
  };
  switch (key) {
    case Qt::Key_Left:
      turn(-kTurn_rad, up);
      break;
    case Qt::Key_Right:
      turn(kTurn_rad, up);
      break;
    case Qt::Key_Up:
      turn(-kTurn_rad, right);
      break;
    case Qt::Key_Down:
      turn(kTurn_rad, right);
      break;
    case Qt::Key_Plus:
      pose.half_height_mm /= kZoom;
      break;
    case Qt::Key_Minus:
      pose.half_height_mm *= kZoom;
      break;
    default:
      return false;
  }
  setViewPose(pose);
  return true;
}

void SherdView::setFocusRing(bool shown) {
  if (overlay_ != nullptr) overlay_->setFocusRing(shown);
}

void SherdView::resetView() {
  if (canvas_ == nullptr) return;
  canvas_->scene().resetView();
  canvas_->redraw();
}

// Written over the picture in the frame that shows it: one painting for both.
void SherdView::showView() {
  ViewAxes axes;
  canvas_->scene().viewAxes(axes.right, axes.up, axes.away);
  overlay_->setView(canvas_->mmPerPixel(), axes);
  emit viewMoved();
}

void SherdView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (overlay_ != nullptr) overlay_->setGeometry(rect());
}

}  // namespace ostraka::ui
