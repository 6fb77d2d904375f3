#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

#include "ui/look/look.h"

// A static library's resources are linked in only when somebody asks for them; the macro wants the
// global namespace.
static void initialiseIcons() {
  Q_INIT_RESOURCE(icons);
}

namespace ostraka::ui {
namespace {

// Draws a one-coloured SVG in the colour that the palette has at that moment.
class PaletteIcon final : public QIconEngine {
 public:
  explicit PaletteIcon(QString path, QColor ink = {}) : path_(std::move(path)), ink_(ink) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const double ratio = painter->device()->devicePixelRatioF();
    QPixmap drawn = scaledPixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state, ratio);
    painter->drawPixmap(rect, drawn);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
    QPixmap drawn(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    QSvgRenderer svg(path_);
    svg.setAspectRatioMode(Qt::KeepAspectRatio);
    svg.render(&painter, QRectF(QPointF(), size));
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(drawn.rect(), colour(mode));
    return drawn;
  }

  QIconEngine* clone() const override { return new PaletteIcon(path_, ink_); }

 private:
  QColor colour(QIcon::Mode mode) const {
    if (ink_.isValid() && mode != QIcon::Disabled) return ink_;
    const QPalette palette = QApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
    if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
    return palette.color(QPalette::ButtonText);
  }

  QString path_;
  QColor ink_;
};

}  // namespace

QIcon icon(const QString& name, const QColor& ink) {
  initialiseIcons();
  const QString path = QStringLiteral(":/icons/%1.svg").arg(name);
  Q_ASSERT_X(QFile::exists(path), "icon", qPrintable(path));
  return QIcon(new PaletteIcon(path, ink));
}

}  // namespace ostraka::ui
