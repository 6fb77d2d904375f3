#pragma once
#include <QWidget>

#include "review/live_pairs.h"

namespace ostraka::ui {

/// The outlines laid over each other, mm, and beside them the descriptors: accumulated turning
/// angles along both. Front blue and solid, back red and dashed.
class OutlinePlot final : public QWidget {
  Q_OBJECT

 public:
  explicit OutlinePlot(QWidget* parent = nullptr);
  void setView(const review::PairView& view);
  void clear();
  int readableWidth() const;  ///< in less the plots say nothing

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintOutlines(QPainter& painter, const QRectF& where) const;
  void paintTurns(QPainter& painter, const QRectF& where) const;
  QPen penOf(bool front) const;

  review::PairView view_;
};

}  // namespace ostraka::ui
