#pragma once
#include <QByteArray>
#include <QGraphicsView>
#include <QImage>
#include <vector>

#include "base/result.h"

class QGraphicsPixmapItem;
class QPagedPaintDevice;

namespace ostraka {
struct Page;
}

namespace ostraka::ui {

/// A sheet of paper, looked at: at first what is drawn on it, in about its true size or as
/// large as fits; wheel or + and - come nearer or further, 0 goes back, dragging moves it. Paper is
/// white in every theme.
class SheetView final : public QGraphicsView {
  Q_OBJECT

 public:
  explicit SheetView(QWidget* parent = nullptr);
  void showSheet(const QImage& sheet);  ///< with its resolution; null: none
  bool hasSheet() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void zoom(double factor);
  void fitDrawn();

  QGraphicsPixmapItem* sheet_ = nullptr;
  QRectF drawn_;          // pixels of the sheet
  double true_size_ = 1;  // screen pixels per pixel of the sheet
  bool zoomed_ = false;
};

/// The page as a picture that knows its resolution, for jobs.
QImage paintedSheet(const Page& page, double dots_per_inch);
/// All pages in true scale, each on paper of its own size; for jobs. Errors: the device.
Result<void> printSheets(QPagedPaintDevice& device, const std::vector<Page>& pages);

}  // namespace ostraka::ui
