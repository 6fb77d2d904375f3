#pragma once
#include <QImage>
#include <QPolygonF>
#include <QWidget>
#include <optional>

namespace ostraka::ui {

/// A photograph under an overlay, and a round brush. The wheel and + - enlarge, the right button
/// moves the picture. By keyboard: the arrows move the brush, Space paints where it is.
class MaskView final : public QWidget {
  Q_OBJECT

 public:
  explicit MaskView(QWidget* parent = nullptr);

  void setPicture(const QImage& photograph, const QString& otherwise);
  void setOverlay(const QImage& overlay);
  /// px of the photograph.
  void setBrush(double radius_px, bool paints_sherd);
  void enlarge(double factor);
  void showWhole();
  QSize sizeHint() const override;
  /// Where a pixel of the photograph lies in the widget.
  QPointF placeOf(const QPointF& pixel) const;

 signals:
  void stroked(const QPolygonF& path);  ///< px of the photograph

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  double scale() const;
  QPointF pixelAt(const QPointF& place) const;
  void enlargeAbout(const QPointF& place, double factor);
  void moveBrush(const QPointF& by_px);
  void keepWithin();

  QImage photograph_, overlay_;
  QString otherwise_;
  QSize size_;  ///< of the photograph shown last: the next one of a batch is looked at alike
  double radius_px_ = 20, zoom_ = 1;  ///< 1: the whole picture fits
  bool paints_sherd_ = true;
  QPointF middle_;                ///< the pixel in the middle of the widget
  std::optional<QPointF> brush_;  ///< px
  QPolygonF path_;                ///< being painted
  QPointF dragged_from_;
};

}  // namespace ostraka::ui
