#pragma once
#include <QString>
#include <QWidget>
#include <utility>

#include "ui/look/distance_scale.h"
#include "ui/viewport/orientation_cube.h"

namespace ostraka::ui {

/// What is written over the picture: scale bar, orientation cube, and what the colours mean.
class ViewOverlay final : public QWidget {
  Q_OBJECT

 public:
  explicit ViewOverlay(QWidget* parent);

  enum class Legend { None, Sides, Distances, FilledModel };
  void setLegend(Legend legend, double reach_mm = 1);
  void setView(double mm_per_pixel, const ViewAxes& axes);
  void setUnitKnown(bool known);  ///< false: lengths are no millimetres, and the bar says so
  void setMeasure(const QString& text);
  void setFocusRing(bool shown);  ///< keys go to this view
  const QString& measure() const { return measure_; }
  Legend legend() const { return legend_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBar(QPainter& painter) const;
  void paintLegend(QPainter& painter) const;
  void paintScale(QPainter& painter, const QPointF& at, double bar) const;
  std::pair<QString, QString> scaleEnds() const;  ///< of the bar, in words: front, back

  Legend legend_ = Legend::None;
  DistanceScale scale_{1};
  double mm_per_pixel_ = 0;
  ViewAxes axes_;
  bool unit_known_ = true, focus_ring_ = false;
  QString measure_;
};

}  // namespace ostraka::ui
