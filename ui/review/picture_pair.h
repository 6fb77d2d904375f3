#pragma once
#include <QImage>
#include <QWidget>

namespace ostraka::ui {

/// The photographs of both sides cut out, in one scale, turned alike: the back beside as one sees
/// it when the sherd is turned over, or mirrored as if looked at through the front.
class PicturePair final : public QWidget {
  Q_OBJECT

 public:
  explicit PicturePair(QWidget* parent = nullptr);
  /// back: as seen through the front.
  void setPictures(const QImage& front, const QImage& back, double px_mm);
  void setNames(const QString& front, const QString& back);
  bool isMirrored() const { return mirrored_; }

 public slots:
  void setMirrored(bool mirrored);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage front_, back_;
  QString front_name_, back_name_;
  double px_mm_ = 0.15;
  bool mirrored_ = false;
};

}  // namespace ostraka::ui
