#pragma once
#include <QWidget>
#include <optional>

#include "ui/wizard/capture_facts.h"

namespace ostraka::ui {

/// A picture of the plate with the sherds' outlines and numbers; two that nearly touch are tied by
/// a thick line. Without a picture it says why.
class PlateView final : public QWidget {
  Q_OBJECT

 public:
  explicit PlateView(QWidget* parent = nullptr);
  void setPicture(const std::optional<PlatePicture>& picture, const QString& otherwise);
  /// Numbers that the sherds have got, by their index; chosen: the one in hand, or -1.
  void setNumbers(const QStringList& numbers, int chosen);
  QSize sizeHint() const override;

 signals:
  void sherdClicked(int sherd);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void drawFreePlaces(QPainter& painter, double scale) const;
  void drawSherds(QPainter& painter, double scale) const;
  void drawMarks(QPainter& painter, double scale) const;
  QRectF target() const;  ///< where the picture is drawn
  void drawScaleBar(QPainter& painter, const QRectF& picture, double scale) const;

  std::optional<PlatePicture> picture_;
  QString otherwise_;
  QStringList numbers_;
  int chosen_ = -1;
};

}  // namespace ostraka::ui
