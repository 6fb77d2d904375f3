#pragma once
#include <QRectF>
#include <QString>

class QPainter;

namespace ostraka::ui {

/// How one looks at the sherd: unit vectors in the front's frame; away: into the picture.
struct ViewAxes {
  double right[3] = {1, 0, 0}, up[3] = {0, 1, 0}, away[3] = {0, 0, -1};
  bool operator==(const ViewAxes& other) const;
};

/// A cube that lies as the sherd does: its upper face (+z) is the front, its lower one the back, in
/// their colours and words; the others carry their axis.
void paintOrientationCube(QPainter& painter, const QRectF& where, const ViewAxes& axes,
                          const QString& front, const QString& back);

}  // namespace ostraka::ui
