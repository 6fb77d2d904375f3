#pragma once
#include <QPointer>
#include <QWidget>

namespace ostraka::ui {

class RigConnection;
class SideProgress;
class Thumbnails;

/// While a side is shot: a ring of stops (before, of calibration photographs) filling up, and the
/// photographs as they arrive, a row a camera. One with a problem is framed, with its reason below.
class StopBoard final : public QWidget {
  Q_OBJECT

 public:
  StopBoard(const RigConnection* rig, const SideProgress* side, QWidget* parent = nullptr);
  void setThumbnails(Thumbnails* thumbnails);
  void follow();  ///< the side changed
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawRing(QPainter& painter, const QRectF& ring) const;
  void drawShots(QPainter& painter, const QRectF& board) const;

  const RigConnection* rig_;
  const SideProgress* side_;
  QPointer<Thumbnails> thumbnails_;
};

}  // namespace ostraka::ui
