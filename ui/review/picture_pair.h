#pragma once
#include <Eigen/Core>
#include <QImage>
#include <QLineF>
#include <QWidget>

#include "review/orthophoto.h"

class QPainter;

namespace ostraka::ui {

/// The photographs of both sides cut out, in one scale, turned alike: the back beside as one sees
/// it when the sherd is turned over, or mirrored as if looked at through the front.
class PicturePair final : public QWidget {
  Q_OBJECT

 public:
  explicit PicturePair(QWidget* parent = nullptr);
  /// back: as seen through the front; a back without a front as one sees it.
  void setPictures(const QImage& front, const QImage& back, const review::PictureFrame& frame);
  void setLoading(bool loading);  ///< they are on their way; ends with setPictures
  void setNames(const QString& front, const QString& back);
  bool isCutting() const { return cutting_; }
  /// Where a picture is missing: whether it still comes.
  QString missingWords() const;
  QString cutWords() const;  ///< what to do to cut; the pictures themselves are left free

 public slots:
  void setMirrored(bool mirrored);
  /// A line drawn over a picture cuts that piece in two. One lies there from the beginning, across
  /// the middle, to be moved by the keys.
  void setCutting(bool cutting);
  void moveLine(int steps);  ///< across itself, a fortieth of the picture each
  void turnLine(int steps);  ///< five degrees each
  void takeOtherSide();
  void cutHere();  ///< along the line that lies there

 signals:
  /// In the pictures' frame, mm.
  void cut(bool front, const Eigen::Vector2d& a_mm, const Eigen::Vector2d& b_mm);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  QRect half(bool front) const;
  double scale() const;
  QRectF place(bool front) const;
  bool flips(bool front) const;
  Eigen::Vector2d shown(const QPointF& at, bool front) const;
  QLineF line() const;  ///< that the keys move
  bool hasPicture(bool front) const { return !(front ? front_ : back_).isNull(); }
  void tellLine();
  void paintLine(QPainter& painter) const;

  QImage front_, back_;
  QString front_name_, back_name_;
  review::PictureFrame frame_;
  QPointF from_, to_;
  bool mirrored_ = false, cutting_ = false, drawing_ = false, line_on_front_ = true,
       loading_ = false;
  int line_steps_ = 0, line_turns_ = 0;
};

}  // namespace ostraka::ui
