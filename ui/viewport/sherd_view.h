#pragma once
#include <Eigen/Geometry>
#include <QString>
#include <QWidget>
#include <vector>

#include "ui/viewport/sherd_scene.h"

namespace ostraka::ui {

class GlCanvas;
class ViewOverlay;

/// How far the two sides lie apart along the fracture: core's figures, for ShownScan::strip_point.
struct ShownDistances {
  std::vector<float> front_mm, back_mm;  ///< positive: the back lies outside the front
  double reach_mm = 0.5;                 ///< the ends of the colour scale
};

/// The sherd in three dimensions: two scans at a pose, or a closed model. Shows only: all figures
/// come from outside. Without OpenGL it says so in words, and everything else goes on.
///
/// Mouse: drag turns the view, wheel zooms, middle button moves. Ctrl+drag turns the back by hand,
/// Ctrl+Shift+drag moves it. With the section on, Shift+wheel moves the plane.
class SherdView final : public QWidget {
  Q_OBJECT

 public:
  explicit SherdView(QWidget* parent = nullptr);

  bool hasOpenGl() const { return canvas_ != nullptr; }

  void clear();
  void showScans(const ShownScan& front, const ShownScan& back,
                 const Eigen::Isometry3d& front_from_back);
  void setPose(const Eigen::Isometry3d& front_from_back);
  /// Empty: the fractures keep the colours of their sides.
  void setDistances(const ShownDistances& distances);
  void showModel(const TriangleMesh& model, const ShownTexture& texture = {});
  void setUnitKnown(bool known);  ///< false: no length is known, and the bar says so
  /// The line and its length, in words; empty: none.
  void setMeasure(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const QString& text);

  ViewPose viewPose() const;
  void setViewPose(const ViewPose& pose);
  /// The arrows turn the view, plus and minus zoom; false: it is another key.
  bool turnByKey(int key);
  void setFocusRing(bool shown);  ///< the widget around it passes its keys on

  bool isApart() const { return apart_; }
  bool hasSection() const { return section_; }
  bool isMeasuring() const { return measuring_; }

 public slots:
  void setApart(bool apart);
  void setSection(bool section);
  void setMeasuring(bool measuring);
  void resetView();

 signals:
  void pointPicked(const Eigen::Vector3d& point);  ///< while measuring; front's frame, mm
  /// The back is to be turned and moved by so much, in the front's frame.
  void backMoved(const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm);
  void sectionChanged(bool on);
  void viewMoved();  ///< turned, moved or zoomed, by a person or by a call

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showView();

  GlCanvas* canvas_ = nullptr;
  ViewOverlay* overlay_ = nullptr;
  bool apart_ = false, section_ = false, measuring_ = false;
};

/// To be called before QApplication is made: the surface format and platform that VTK needs.
void prepareOpenGl();
/// To be called before a window is shown first. Otherwise the first view in three dimensions, which
/// comes when somebody needs it, has the window made anew, and it loses the keyboard.
void reserveOpenGl(QWidget& window);

}  // namespace ostraka::ui
