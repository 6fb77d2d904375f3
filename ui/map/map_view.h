#pragma once
#include <QWidget>

#include "ui/map/map_pages.h"

namespace ostraka::ui {

/// Front and back of the plate side by side. The sherd under the mouse, or the one that the arrow
/// keys reached, lights up on both.
class MapView final : public QWidget {
  Q_OBJECT

 public:
  explicit MapView(QWidget* parent = nullptr);
  void setPicture(const MapPicture& picture);
  void setNumbers(const MapNumbers& numbers);
  void setLoading(bool loading);  ///< said where no picture is there yet
  const MapPicture& picture() const { return picture_; }
  const QString& highlighted() const { return highlighted_; }

 public slots:
  void highlight(const QString& number);

 signals:
  void highlightedChanged(const QString& number);
  void activated(const QString& number);  ///< Enter or a double click

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF half(bool front) const;
  QString numberAt(const QPointF& place) const;
  QStringList numbers() const;

  MapPicture picture_;
  QString highlighted_;
  bool loading_ = false;
};

}  // namespace ostraka::ui
