#include "ui/catalogue/sheet_view.h"

#include <QGraphicsPixmapItem>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QSvgRenderer>
#include <QWheelEvent>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "paper/sheet.h"
#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

constexpr double kStep = 1.25;
constexpr double kNearest = 4;  // screen pixels per pixel of the picture
constexpr double kMargin_mm = 5;
constexpr int kLook = 2;  // every second pixel: the thinnest line is wider

QByteArray svgOf(const Page& page) {
  return QByteArray::fromStdString(formatSvg(page, {}));
}

// What is not white, with some paper around it; all of the sheet if that is empty.
QRectF drawnOn(const QImage& sheet) {
  QRect box;
  for (int y = 0; y < sheet.height(); y += kLook) {
    const auto* line = reinterpret_cast<const QRgb*>(sheet.constScanLine(y));
    int first = 0, last = sheet.width() - 1;
    while (first <= last && qGreen(line[first]) == 255) first += kLook;
    if (first > last) continue;
    while (last > first && qGreen(line[last]) == 255) last -= kLook;
    box |= QRect(QPoint(first, y), QPoint(last, y));
  }
  const int margin = qRound(kMargin_mm / 1000 * sheet.dotsPerMeterX());
  return box.isNull() ? sheet.rect()
                      : box.marginsAdded({margin, margin, margin, margin}) & sheet.rect();
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
  drawn_ = drawnOn(sheet);
  true_size_ = sheet.isNull() ? 1 : logicalDpiX() / 0.0254 / sheet.dotsPerMeterX();
  if (zoomed_ && same_size) return;
  fitDrawn();
}

bool SheetView::hasSheet() const {
  return !sheet_->pixmap().isNull();
}

void SheetView::fitDrawn() {
  zoomed_ = false;
  if (drawn_.isEmpty()) return;
  const double whole = viewport()->width() / sheet_->boundingRect().width();
  const double factor = std::max(whole, std::min(true_size_, viewport()->width() / drawn_.width()));
  setTransform(QTransform::fromScale(factor, factor));
  centerOn(drawn_.center().x(), drawn_.top() + viewport()->height() / factor / 2);
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
  if (!zoomed_) fitDrawn();
}

void SheetView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void SheetView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoom(kStep);
  if (event->key() == Qt::Key_Minus) return zoom(1 / kStep);
  if (event->key() != Qt::Key_0) return QGraphicsView::keyPressEvent(event);
  fitDrawn();
}

QImage paintedSheet(const Page& page, double dots_per_inch) {
  const double per_mm = dots_per_inch / 25.4;
  QImage image(qCeil(page.width_mm * per_mm), qCeil(page.height_mm * per_mm), QImage::Format_RGB32);
  image.fill(paperInks().paper);
  image.setDotsPerMeterX(qRound(per_mm * 1000));
  image.setDotsPerMeterY(qRound(per_mm * 1000));
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
