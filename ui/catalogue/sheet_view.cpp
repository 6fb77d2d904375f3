#include "ui/catalogue/sheet_view.h"

#include <QGraphicsPixmapItem>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QScrollBar>
#include <QSvgRenderer>
#include <QWheelEvent>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "base/sheet.h"

namespace ostraka::ui {
namespace {

constexpr double kStep = 1.25;
constexpr double kNearest = 4;  // screen pixels per pixel of the picture

QByteArray svgOf(const Page& page) {
  return QByteArray::fromStdString(formatSvg(page, {}));
}

}  // namespace

SheetView::SheetView(QWidget* parent) : QGraphicsView(parent) {
  setObjectName("sheet");
  setAccessibleName(tr("The drawing on its sheet"));
  auto* scene = new QGraphicsScene(this);
  sheet_ = new QGraphicsPixmapItem;
  sheet_->setTransformationMode(Qt::SmoothTransformation);
  scene->addItem(sheet_);  // the scene's from here
  setScene(scene);
  setDragMode(QGraphicsView::ScrollHandDrag);
  setTransformationAnchor(QGraphicsView::AnchorUnderMouse);
  setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // else fitting the width would swing
}

void SheetView::showSheet(const QImage& sheet) {
  const bool same_size = sheet.size() == sheet_->pixmap().size();
  sheet_->setPixmap(QPixmap::fromImage(sheet));
  setSceneRect(sheet_->boundingRect());
  if (zoomed_ && same_size) return;
  zoomed_ = false;
  fitWidth();
  verticalScrollBar()->setValue(0);
}

bool SheetView::hasSheet() const {
  return !sheet_->pixmap().isNull();
}

void SheetView::fitWidth() {
  const double width = sheet_->boundingRect().width();
  if (width <= 0) return;
  const double factor = viewport()->width() / width;
  setTransform(QTransform::fromScale(factor, factor));
}

void SheetView::zoom(double factor) {
  const double width = sheet_->boundingRect().width();
  if (width <= 0) return;
  const double now = transform().m11();
  const double farthest = std::min(1.0, viewport()->width() / width / 2);
  const double then = std::clamp(now * factor, farthest, kNearest);
  scale(then / now, then / now);
  zoomed_ = true;
}

void SheetView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if (!zoomed_) fitWidth();
}

void SheetView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void SheetView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoom(kStep);
  if (event->key() == Qt::Key_Minus) return zoom(1 / kStep);
  if (event->key() != Qt::Key_0) return QGraphicsView::keyPressEvent(event);
  zoomed_ = false;
  fitWidth();
}

QImage paintedSheet(const Page& page, double dots_per_inch) {
  const double per_mm = dots_per_inch / 25.4;
  QImage image(qCeil(page.width_mm * per_mm), qCeil(page.height_mm * per_mm), QImage::Format_RGB32);
  image.fill(Qt::white);
  QSvgRenderer renderer(svgOf(page));
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  renderer.render(&painter, QRectF(0, 0, page.width_mm * per_mm, page.height_mm * per_mm));
  return image;
}

Result<void> printSheets(QPagedPaintDevice& device, const std::vector<Page>& pages) {
  const Error failed{ErrorCode::CannotWrite,
                     "The printer or file took no further sheet; is it ready, is the disk full?",
                     {}};
  QPainter painter;
  for (const Page& page : pages) {
    const bool across = page.width_mm > page.height_mm;
    const QSizeF upright =
        across ? QSizeF(page.height_mm, page.width_mm) : QSizeF(page.width_mm, page.height_mm);
    device.setPageLayout(QPageLayout(QPageSize(upright, QPageSize::Millimeter),
                                     across ? QPageLayout::Landscape : QPageLayout::Portrait,
                                     QMarginsF(), QPageLayout::Millimeter, QMarginsF()));
    if (painter.isActive() ? !device.newPage() : !painter.begin(&device)) return failed;
    // From the paper's corner, whatever the printer's margins: the drawing keeps its own.
    const QRect paintable = device.pageLayout().paintRectPixels(device.logicalDpiX());
    const double x_per_mm = device.logicalDpiX() / 25.4, y_per_mm = device.logicalDpiY() / 25.4;
    QSvgRenderer renderer(svgOf(page));
    renderer.render(&painter, QRectF(-paintable.left(), -paintable.top(), page.width_mm * x_per_mm,
                                     page.height_mm * y_per_mm));
  }
  if (painter.isActive() && !painter.end()) return failed;
  return {};
}

}  // namespace ostraka::ui
