#pragma once
#include <QString>
#include <QWidget>

namespace ostraka::ui {

/// What is written over the picture: scale bar, legend of the sides, colours along the rim.
class ViewOverlay final : public QWidget {
  Q_OBJECT

 public:
  explicit ViewOverlay(QWidget* parent);

  enum class Legend { None, Sides, Rim };
  void setLegend(Legend legend, double reach_mm = 0);
  void setScale(double mm_per_pixel);  ///< 0: no bar
  void setUnitKnown(bool known);       ///< false: lengths are no millimetres, and nothing says so
  void setNote(const QString& note);
  void setMeasure(const QString& text);
  const QString& measure() const { return measure_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBar(QPainter& painter) const;
  void paintLegend(QPainter& painter) const;

  Legend legend_ = Legend::None;
  double reach_mm_ = 0, mm_per_pixel_ = 0;
  bool unit_known_ = true;
  QString note_, measure_;
};

}  // namespace ostraka::ui
