// The recipe that was tried and measured: see the traps named in the comments.
#include "ui/viewport/gl_canvas.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkPointPicker.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QTimer>
#include <QWheelEvent>
#include <cmath>
#include <functional>

#include "ui/viewport/sherd_scene.h"

namespace ostraka::ui {
namespace {

// 60 pictures a second; what takes longer is drawn coarser while it moves.
constexpr double kFrame_ms = 16;
constexpr int kRest_ms = 250;  // after the wheel's last notch

class Observer final : public vtkCommand {
 public:
  static Observer* New() { return new Observer; }
  void Execute(vtkObject*, unsigned long, void* data) override { call(data); }
  std::function<void(void*)> call;
};

void on(vtkObject* object, unsigned long event, std::function<void(void*)> call) {
  vtkNew<Observer> observer;
  observer->call = std::move(call);
  object->AddObserver(event, observer);
}

}  // namespace

struct GlCanvas::Vtk {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  vtkNew<vtkPointPicker> picker;
};

bool GlCanvas::isPossible() {
  static const bool possible = [] {
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal" || platform == "vnc") return false;
    QOpenGLContext context;
    context.setFormat(QSurfaceFormat::defaultFormat());
    if (!context.create()) return false;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) return false;
    const bool enough = context.format().version() >= qMakePair(3, 2);
    context.doneCurrent();
    return enough;
  }();
  return possible;
}

GlCanvas::GlCanvas(QWidget* parent)
    : QOpenGLWidget(parent), vtk_(std::make_unique<Vtk>()), scene_(std::make_unique<SherdScene>()) {
  setFocusPolicy(Qt::NoFocus);  // keys belong to the screen around
  vtk_->window->SetReadyForRendering(false);
  vtk_->window->SetOwnContext(0);
  vtk_->window->SetFrameBlitModeToNoBlit();
  vtk_->window->SetMultiSamples(0);
  vtk_->window->SetNumberOfLayers(2);
  vtk_->window->AddRenderer(scene_->renderer());
  vtk_->window->AddRenderer(scene_->above());
  vtk_->interactor->SetRenderWindow(vtk_->window);
  vtk_->interactor->SetInteractorStyle(vtk_->style);
  vtk_->interactor->EnableRenderOff();
  vtk_->picker->SetTolerance(0.008);
  rest_ = new QTimer(this);
  rest_->setSingleShot(true);
  rest_->setInterval(kRest_ms);
  connect(rest_, &QTimer::timeout, this, [this] { setMoving(false); });
  observe();
  vtk_->interactor->Initialize();
}

GlCanvas::~GlCanvas() {
  // aboutToBeDestroyed comes from ~QOpenGLWidget, when our members are gone.
  QObject::disconnect(dying_);
  release();
  vtk_->interactor->SetRenderWindow(nullptr);
}

void GlCanvas::observe() {
  on(vtk_->interactor, vtkCommand::RenderEvent, [this](void*) { redraw(); });
  // Not QOpenGLWidget::makeCurrent(): it binds the widget's framebuffer while VTK builds its own.
  on(vtk_->window, vtkCommand::WindowMakeCurrentEvent, [this](void*) {
    if (context() != nullptr && QOpenGLContext::currentContext() != context())
      context()->makeCurrent(surface_);
  });
  on(vtk_->window, vtkCommand::WindowIsCurrentEvent, [this](void* told) {
    *static_cast<bool*>(told) =
        context() != nullptr && QOpenGLContext::currentContext() == context();
  });
  // In this event IsOneShotTimer(id) and GetTimerDuration(id) still say 0.
  on(vtk_->interactor, vtkCommand::CreateTimerEvent, [this](void* told) {
    const int id = *static_cast<int*>(told);
    QTimer* timer = timers_[id] = new QTimer(this);
    timer->setSingleShot(vtk_->interactor->GetTimerEventType() ==
                         vtkRenderWindowInteractor::OneShotTimer);
    connect(timer, &QTimer::timeout, this, [this, id] {
      int which = id;
      vtk_->interactor->InvokeEvent(vtkCommand::TimerEvent, &which);
    });
    timer->start(static_cast<int>(vtk_->interactor->GetTimerEventDuration()));
  });
  on(vtk_->interactor, vtkCommand::DestroyTimerEvent, [this](void* told) {
    if (QTimer* timer = timers_.take(*static_cast<int*>(told))) timer->deleteLater();
  });
}

void GlCanvas::initializeGL() {
  surface_ = context()->surface();
  dying_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
  vtk_->window->SetMapped(1);
  vtk_->window->SetIsDirect(1);
  vtk_->window->SetSupportsOpenGL(1);
  vtk_->window->SetForceMaximumHardwareLineWidth(1);
  vtk_->window->SetReadyForRendering(true);
  vtk_->window->OpenGLInitContext();
  sync();
}

void GlCanvas::sync() {
  const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
  vtk_->window->SetSize(size.width(), size.height());
  vtk_->interactor->UpdateSize(size.width(), size.height());
  vtk_->window->SetDPI(static_cast<int>(72 * devicePixelRatioF()));
  scene_->setPixelRatio(devicePixelRatioF());
  emit viewChanged();
}

void GlCanvas::redraw() {
  emit viewChanged();
  update();
}

void GlCanvas::redrawMoving() {
  setMoving(true);
  rest_->start();
  redraw();
}

void GlCanvas::setMoving(bool moving) {
  if (moving_ == moving) return;
  moving_ = moving;
  scene_->setMoving(moving && slow_);
  if (!moving) redraw();
}

void GlCanvas::resizeGL(int, int) {
  sync();
}

// Off the screen: the driver's context first, the first picture with all its shaders then.
bool GlCanvas::warmUp() {
  if (isVisible() || warmth_ == Warmth::Drawn) return false;
  grabFramebuffer();
  if (!isValid()) return false;  // the window is not there yet
  warmth_ = warmth_ == Warmth::Cold ? Warmth::Ready : Warmth::Drawn;
  return warmth_ == Warmth::Ready;
}

void GlCanvas::paintGL() {
  if (!vtk_->window->GetReadyForRendering()) return;
  if (warmth_ == Warmth::Cold && !isVisible()) return;
  const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
  QElapsedTimer clock;
  clock.start();
  draw(size);
  if (!moving_) {
    context()->functions()->glFinish();
    slow_ = static_cast<double>(clock.nsecsElapsed()) > 1e6 * kFrame_ms;
  }
  emit rendered();
}

void GlCanvas::draw(const QSize& size) {
  scene_->prepare();
  QOpenGLFunctions* gl = context()->functions();
  gl->glEnable(GL_PROGRAM_POINT_SIZE);
  vtk_->window->Render();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  vtk_->window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  gl->glDisable(GL_SCISSOR_TEST);
  vtk_->window->BlitDisplayFramebuffer(0, 0, 0, size.width(), size.height(), 0, 0, size.width(),
                                       size.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

void GlCanvas::release() {
  if (context() == nullptr || !vtk_->window->GetReadyForRendering()) return;
  makeCurrent();
  vtk_->window->Finalize();
  vtk_->window->SetReadyForRendering(false);
  doneCurrent();
}

double GlCanvas::mmPerPixel() const {
  return height() > 0 ? 2 * scene_->camera()->GetParallelScale() / height() : 0;
}

void GlCanvas::tell(QSinglePointEvent& event) {
  const double ratio = devicePixelRatioF();
  vtk_->interactor->SetEventInformationFlipY(
      static_cast<int>(event.position().x() * ratio),
      static_cast<int>(event.position().y() * ratio),
      event.modifiers().testFlag(Qt::ControlModifier) ? 1 : 0,
      event.modifiers().testFlag(Qt::ShiftModifier) ? 1 : 0);
}

void GlCanvas::mousePressEvent(QMouseEvent* event) {
  last_ = event->position();
  moved_ = false;
  if (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ControlModifier)) {
    turning_back_ = true;
    return;
  }
  tell(*event);
  if (event->button() == Qt::LeftButton)
    vtk_->interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  else if (event->button() == Qt::MiddleButton)
    vtk_->interactor->InvokeEvent(vtkCommand::MiddleButtonPressEvent);
  else if (event->button() == Qt::RightButton)
    vtk_->interactor->InvokeEvent(vtkCommand::RightButtonPressEvent);
}

void GlCanvas::mouseMoveEvent(QMouseEvent* event) {
  if ((event->position() - last_).manhattanLength() > 0) moved_ = true;
  if (event->buttons() != Qt::NoButton && moved_) setMoving(true);
  if (turning_back_) {
    dragBack(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    last_ = event->position();
    return;
  }
  tell(*event);
  vtk_->interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
}

void GlCanvas::mouseReleaseEvent(QMouseEvent* event) {
  setMoving(false);
  if (turning_back_) {
    turning_back_ = false;
    return;
  }
  tell(*event);
  if (event->button() == Qt::LeftButton)
    vtk_->interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  else if (event->button() == Qt::MiddleButton)
    vtk_->interactor->InvokeEvent(vtkCommand::MiddleButtonReleaseEvent);
  else if (event->button() == Qt::RightButton)
    vtk_->interactor->InvokeEvent(vtkCommand::RightButtonReleaseEvent);
  if (!picking_ || moved_ || event->button() != Qt::LeftButton) return;
  makeCurrent();  // the picker asks the depth of the picture
  const int* at = vtk_->interactor->GetEventPosition();
  const bool hit = vtk_->picker->Pick(at[0], at[1], 0, scene_->renderer()) != 0 &&
                   vtk_->picker->GetPointId() >= 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  vtk_->picker->GetPickPosition(point.data());
  doneCurrent();
  if (hit) emit clicked(point);
}

// Across turns about the axis of the view, up and down tips: half a turn for the widget's width.
void GlCanvas::dragBack(const QPointF& to, bool move) {
  Eigen::Vector3d right, up, away;
  scene_->viewAxes(right.data(), up.data(), away.data());
  const QPointF by = (to - last_) * mmPerPixel();
  if (move) return emit draggedWithControl(Eigen::Vector3d::Zero(), by.x() * right - by.y() * up);
  const QPointF middle(width() / 2.0, height() / 2.0);
  const QPointF a = last_ - middle, b = to - middle;
  // As if the back were held where the mouse is: the angle that the mouse went around the middle.
  const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  emit draggedWithControl(turn * away, Eigen::Vector3d::Zero());
}

void GlCanvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  setMoving(true);
  rest_->start();
  if (event->modifiers().testFlag(Qt::ShiftModifier) && scene_->hasSection()) {
    const double sideways = event->angleDelta().x() / 120.0;  // some desktops turn Shift+wheel
    scene_->moveSection((notches + sideways) * 5 * mmPerPixel());
    redraw();
    return;
  }
  tell(*event);
  const int turns = std::max(1, static_cast<int>(std::abs(notches)));
  for (int i = 0; i < turns && notches != 0; ++i)
    vtk_->interactor->InvokeEvent(notches > 0 ? vtkCommand::MouseWheelForwardEvent
                                              : vtkCommand::MouseWheelBackwardEvent);
}

}  // namespace ostraka::ui
