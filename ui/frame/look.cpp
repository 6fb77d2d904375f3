#include "ui/frame/look.h"

#include <QApplication>
#include <QFontDatabase>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QScreen>
#include <QStyleFactory>
#include <QStyleOption>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace ostraka::ui {
namespace {

constexpr double kMillimetresPerInch = 25.4;
constexpr double kTarget_mm = 12;
constexpr double kPressedFrame = 2;  // pixels
constexpr const char* kSunlightProperty = "ostrakaSunlight";
constexpr const char* kPlainPointSize = "ostrakaPlainPointSize";
constexpr const char* kPlainPalette = "ostrakaPlainPalette";

QPalette palette(const QColor& window, const QColor& base, const QColor& text, const QColor& button,
                 const QColor& highlight, const QColor& faint) {
  QPalette made(button, window);
  made.setColor(QPalette::Window, window);
  made.setColor(QPalette::Base, base);
  made.setColor(QPalette::AlternateBase, window);
  made.setColor(QPalette::Button, button);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                         QPalette::ToolTipText, QPalette::BrightText})
    made.setColor(role, text);
  made.setColor(QPalette::ToolTipBase, base);
  made.setColor(QPalette::PlaceholderText, faint);
  if (window.lightnessF() < 0.5F)  // what Qt derives for lines is darker than the dark behind them
    made.setColor(QPalette::Mid,
                  QColor((faint.red() + window.red()) / 2, (faint.green() + window.green()) / 2,
                         (faint.blue() + window.blue()) / 2));
  made.setColor(QPalette::Highlight, highlight);
  made.setColor(QPalette::HighlightedText,
                highlight.lightnessF() > 0.55 ? QColor(Qt::black) : QColor(Qt::white));
  made.setColor(QPalette::Link, highlight);
  made.setColor(QPalette::LinkVisited, highlight);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    made.setColor(QPalette::Disabled, role, faint);
  return made;
}

// Fusion, with icons as large as the letters and thick lines where the sun shines on the screen.
class OstrakaStyle final : public QProxyStyle {
 public:
  OstrakaStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("fusion"))) {}

  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    int usual = QProxyStyle::pixelMetric(metric, option, widget);
    // Icons grow with the letters that they stand beside.
    if (metric == PM_ButtonIconSize || metric == PM_SmallIconSize || metric == PM_TabBarIconSize ||
        metric == PM_LineEditIconSize)
      usual = std::max(usual, QFontMetrics(QApplication::font()).height());
    if (metric == PM_IndicatorWidth || metric == PM_IndicatorHeight ||
        metric == PM_ExclusiveIndicatorWidth || metric == PM_ExclusiveIndicatorHeight ||
        metric == PM_SliderThickness || metric == PM_SliderLength)
      usual = std::max(usual, QFontMetrics(QApplication::font()).height());
    if (!qApp->property(kSunlightProperty).toBool()) return usual;
    if (metric == PM_DefaultFrameWidth) return usual + 1;
    return usual;
  }

  // Fusion tells what is pressed in, and where one can type, tick or pull, by a shade that the sun
  // takes away and the dark theme lacks.
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const QPalette& colours = option->palette;
    const bool button = element == PE_PanelButtonTool || element == PE_PanelButtonCommand;
    if (button && (option->state & State_On))
      frame(*painter, option->rect, colours.color(QPalette::Highlight), kPressedFrame);
    const QColor faint = colours.color(QPalette::PlaceholderText);
    if (element == PE_IndicatorCheckBox) frame(*painter, option->rect, faint, 1);
    if (element == PE_IndicatorRadioButton)
      frame(*painter, option->rect, faint, 1, option->rect.height() / 2.0);
    if (element == PE_FrameLineEdit && isDark(colours) && !(option->state & State_HasFocus))
      frame(*painter, option->rect, faint, 1);
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (!isDark(option->palette)) return;
    const QColor faint = option->palette.color(QPalette::PlaceholderText);
    if (control == CC_SpinBox && !(option->state & State_HasFocus))
      frame(*painter, option->rect, faint, 1);
    if (control == CC_Slider)
      frame(*painter, subControlRect(CC_Slider, option, SC_SliderHandle, widget), faint, 1);
  }

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    // Menus and tool tips stay where the hand left them; nothing fades or slides.
    if (hint == SH_Widget_Animate || hint == SH_Widget_Animation_Duration) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }

 private:
  static bool isDark(const QPalette& colours) {
    return colours.color(QPalette::Window).lightnessF() < 0.5F;
  }

  static void frame(QPainter& painter, const QRect& where, const QColor& colour, double wide,
                    double corner = 2) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, wide));
    painter.setBrush(Qt::NoBrush);
    const double inwards = wide / 2;
    painter.drawRoundedRect(QRectF(where).adjusted(inwards, inwards, -inwards, -inwards), corner,
                            corner);
    painter.restore();
  }
};

}  // namespace

QString themeName(Theme theme) {
  switch (theme) {
    case Theme::Light:
      return QStringLiteral("light");
    case Theme::Dark:
      return QStringLiteral("dark");
    case Theme::Sunlight:
      return QStringLiteral("sunlight");
    case Theme::System:
      break;
  }
  return QStringLiteral("system");
}

Theme themeFromName(const QString& name) {
  for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Sunlight})
    if (themeName(theme) == name) return theme;
  return Theme::System;
}

QPalette paletteOf(Theme theme, const QPalette& system) {
  switch (theme) {
    case Theme::Light:
      return palette(QColor(0xf3, 0xf1, 0xee), Qt::white, QColor(0x1d, 0x1b, 0x19),
                     QColor(0xe7, 0xe3, 0xde), QColor(0x00, 0x5f, 0xa3), QColor(0x6b, 0x66, 0x60));
    case Theme::Dark:
      return palette(QColor(0x1c, 0x1b, 0x1a), QColor(0x12, 0x11, 0x10), QColor(0xe6, 0xe1, 0xda),
                     QColor(0x2d, 0x2b, 0x29), QColor(0x62, 0xb8, 0xf5), QColor(0x98, 0x92, 0x8a));
    case Theme::Sunlight:
      return palette(Qt::white, Qt::white, Qt::black, Qt::white, Qt::black,
                     QColor(0x40, 0x40, 0x40));
    case Theme::System:
      break;
  }
  return system;
}

void applyLook(QApplication& application, Theme theme, int text_percent) {
  if (!application.property(kPlainPointSize).isValid()) {
    application.setProperty(kPlainPointSize, application.font().pointSizeF());
    application.setStyle(new OstrakaStyle);  // the application owns it
    application.setProperty(kPlainPalette, QVariant::fromValue(application.palette()));
  }
  application.setProperty(kSunlightProperty, theme == Theme::Sunlight);
  application.setPalette(paletteOf(theme, application.property(kPlainPalette).value<QPalette>()));
  QFont font = application.font();
  const double plain = std::max(9.0, application.property(kPlainPointSize).toDouble());
  font.setPointSizeF(plain * std::clamp(text_percent, 90, 200) / 100.0);
  font.setBold(theme == Theme::Sunlight);
  const double before = application.font().pointSizeF();
  application.setFont(font);
  if (before <= 0 || before == font.pointSizeF()) return;
  // What has a size of its own, as headings have, follows too.
  for (QWidget* widget : QApplication::allWidgets()) {
    QFont own = widget->font();
    if (!widget->testAttribute(Qt::WA_SetFont) || !(own.resolveMask() & QFont::SizeResolved))
      continue;
    own.setPointSizeF(own.pointSizeF() * font.pointSizeF() / before);
    widget->setFont(own);
  }
}

int targetSize(const QWidget& widget) {
  const double per_mm = widget.screen()->logicalDotsPerInch() / kMillimetresPerInch;
  return std::max(static_cast<int>(std::lround(kTarget_mm * per_mm)),
                  static_cast<int>(2.4 * widget.fontMetrics().height()));
}

QFont scaledFont(const QWidget& widget, double factor) {
  QFont font = widget.font();
  font.setPointSizeF(QApplication::font().pointSizeF() * factor);
  return font;
}

QFont tabularFont(const QFont& font) {
  // Qt 6.4 cannot ask a font for its tabular figures; DejaVu's and Noto's are tabular as they are.
  QFont figures = font;
  figures.setKerning(false);
  return figures;
}

double lineWidth(const QWidget& widget, double weight) {
  const bool sunlight = qApp->property(kSunlightProperty).toBool();
  const double base = std::max(1.0, widget.fontMetrics().height() / 16.0);
  return base * weight * (sunlight ? 2 : 1);
}

}  // namespace ostraka::ui
