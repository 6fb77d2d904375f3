#pragma once
#include <Eigen/Core>
#include <QMap>
#include <QMetaObject>
#include <QOpenGLWidget>
#include <memory>

class QSurface;
class QTimer;

namespace ostraka::ui {

class SherdScene;

/// VTK's generic render window inside an OpenGL widget of Qt 6: Debian's ready one is Qt 5's.
class GlCanvas final : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit GlCanvas(QWidget* parent);
  ~GlCanvas() override;

  /// False where a picture cannot be drawn by OpenGL 3.2: no such driver, or a platform of Qt that
  /// has none (offscreen).
  static bool isPossible();

  SherdScene& scene() { return *scene_; }
  void setPicking(bool picking) { picking_ = picking; }
  /// A frame soon, and word of it to what is written over the picture.
  void redraw();
  void redrawMoving();  ///< the same, as coarse as while a person turns it, and whole after a rest
  double mmPerPixel() const;  ///< of this widget's own pixels
  /// What the first picture takes a tenth of a second for is done while the canvas is hidden, in
  /// steps: true as long as there is another one to do. The window must be there.
  bool warmUp();

 signals:
  void viewChanged();  ///< a frame follows
  void rendered();
  void clicked(const Eigen::Vector3d& point);  ///< under the mouse, while picking
  void draggedWithControl(const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  struct Vtk;
  enum class Warmth { Cold, Ready, Drawn };
  void observe();
  void sync();
  void release();
  void tell(QSinglePointEvent& event);
  void setMoving(bool moving);
  void draw(const QSize& size);
  void dragBack(const QPointF& to, bool move);

  std::unique_ptr<Vtk> vtk_;
  std::unique_ptr<SherdScene> scene_;
  QMap<int, QTimer*> timers_;
  QSurface* surface_ = nullptr;
  QMetaObject::Connection dying_;
  QPointF last_;
  Warmth warmth_ = Warmth::Cold;
  bool picking_ = false, turning_back_ = false, moved_ = false;
  bool moving_ = false, slow_ = true;  ///< slow: the last whole picture took too long to turn it
  QTimer* rest_ = nullptr;             ///< after the wheel
};

}  // namespace ostraka::ui
