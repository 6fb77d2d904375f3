#include "ui/look/style.h"

#include <QApplication>
#include <QLineEdit>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>
#include <QWidget>
#include <algorithm>

#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

int lineHeight() {
  return QFontMetrics(QApplication::font()).height();
}

// Fusion draws shades that the sun takes away and the dark theme lacks: here lines tell what can be
// pressed, typed into or ticked, and the accent tells what has the focus or is pressed in.
class OstrakaStyle final : public QProxyStyle {
 public:
  OstrakaStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("fusion"))) {}

  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    switch (metric) {
      case PM_LayoutHorizontalSpacing:
      case PM_LayoutVerticalSpacing:
      case PM_LayoutLeftMargin:
      case PM_LayoutTopMargin:
      case PM_LayoutRightMargin:
      case PM_LayoutBottomMargin:
        return Look::kGap;
      case PM_ButtonIconSize:
      case PM_SmallIconSize:
      case PM_TabBarIconSize:
      case PM_LineEditIconSize:
        return std::max(lineHeight(), metric == PM_LineEditIconSize ? 0 : Look::kIcon - 2);
      case PM_IndicatorWidth:
      case PM_IndicatorHeight:
      case PM_ExclusiveIndicatorWidth:
      case PM_ExclusiveIndicatorHeight:
      case PM_SliderThickness:
      case PM_SliderLength:
        return std::max(usual, lineHeight());
      case PM_DefaultFrameWidth:
        return usual + edge(QApplication::palette()) - 1;
      default:
        return usual;
    }
  }

  // One height for all controls, so that rows of them share a line.
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                         const QWidget* widget) const override {
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const bool control = type == CT_PushButton || type == CT_LineEdit || type == CT_ComboBox ||
                         type == CT_SpinBox || type == CT_TabBarTab ||
                         (type == CT_ToolButton && widget != nullptr &&
                          qobject_cast<const QTabBar*>(widget->parentWidget()) == nullptr);
    if (control && widget != nullptr && !isInner(*widget))
      size.setHeight(std::max(size.height(), controlHeight(*widget)));
    return size;
  }

  // Letters keep clear of the round corners.
  QRect subElementRect(SubElement element, const QStyleOption* option,
                       const QWidget* widget) const override {
    const QRect usual = QProxyStyle::subElementRect(element, option, widget);
    if (element != SE_LineEditContents || widget == nullptr || isInner(*widget)) return usual;
    return usual.adjusted(Look::kCorner, 0, -Look::kCorner, 0);
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    const QPalette& colours = option->palette;
    switch (element) {
      case PE_PanelButtonCommand:
        return panel(*painter, *option, false);
      case PE_PanelButtonTool:
        return panel(*painter, *option, (option->state & State_AutoRaise) != 0);
      case PE_FrameLineEdit:
        return frame(*painter, option->rect, *option, Look::kCorner);
      case PE_Frame:
        return edgeOf(*painter, *option, 0);
      case PE_FrameGroupBox:
        return edgeBelowTitle(*painter, *option, widget);
      case PE_FrameFocusRect:
        return outline(*painter, option->rect, colours.color(QPalette::Highlight), Look::kFocus,
                       Look::kCorner / 2.0);
      default:
        break;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox) frame(*painter, option->rect, *option, 2);
    if (element == PE_IndicatorRadioButton)
      frame(*painter, option->rect, *option, option->rect.height() / 2.0);
    if (element == PE_PanelLineEdit) sayThatNothingIsTyped(*painter, widget);
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (control == CC_ComboBox && box != nullptr && !box->editable) {
      panel(*painter, *option, false);
      QStyleOption arrow(*option);
      arrow.rect = subControlRect(CC_ComboBox, option, SC_ComboBoxArrow, widget);
      proxy()->drawPrimitive(PE_IndicatorArrowDown, &arrow, painter, widget);
      return;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox || control == CC_ComboBox)
      frame(*painter, option->rect, *option, Look::kCorner);
    if (control == CC_Slider)
      frame(*painter, subControlRect(CC_Slider, option, SC_SliderHandle, widget), *option, 2);
  }

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    // Menus and tool tips stay where the hand left them; nothing fades or slides.
    if (hint == SH_Widget_Animate || hint == SH_Widget_Animation_Duration) return 0;
    if (hint == SH_FormLayoutLabelAlignment) return int(Qt::AlignRight | Qt::AlignVCenter);
    return QProxyStyle::styleHint(hint, option, widget, data);
  }

 private:
  static int edge(const QPalette& palette) { return coloursOf(palette).border_width; }

  // Lines within a spin box or a combo box have its height already.
  static bool isInner(const QWidget& widget) {
    return widget.objectName().startsWith(QLatin1String("qt_"));
  }

  // The words of an empty line are drawn next, by the same painter.
  static void sayThatNothingIsTyped(QPainter& painter, const QWidget* widget) {
    const auto* line = qobject_cast<const QLineEdit*>(widget);
    if (line == nullptr || !line->text().isEmpty()) return;
    QFont font = painter.font();
    font.setItalic(true);
    font.setWeight(QFont::Normal);
    painter.setFont(font);
  }

  static void outline(QPainter& painter, const QRect& where, const QColor& colour, double wide,
                      double corner, Qt::PenStyle line = Qt::SolidLine) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, wide, line));
    painter.setBrush(Qt::NoBrush);
    const double inwards = wide / 2;
    painter.drawRoundedRect(QRectF(where).adjusted(inwards, inwards, -inwards, -inwards), corner,
                            corner);
    painter.restore();
  }

  // Of what groups other things: nothing in it can be pressed, and it needs no shade.
  static void edgeOf(QPainter& painter, const QStyleOption& option, double corner) {
    const Colours& c = coloursOf(option.palette);
    outline(painter, option.rect, c.border, c.border_width, corner);
  }

  // Where Fusion has it, so that its margins fit.
  void edgeBelowTitle(QPainter& painter, const QStyleOption& option, const QWidget* widget) const {
    constexpr int kAboveFrame = 3;
    const int title = std::max(pixelMetric(PM_ExclusiveIndicatorHeight, &option, widget),
                               option.fontMetrics.height());
    QStyleOption below(option);
    below.rect.adjust(0, title + kAboveFrame, 0, 0);
    edgeOf(painter, below, Look::kCorner);
  }

  static void frame(QPainter& painter, const QRect& where, const QStyleOption& option,
                    double corner) {
    const Colours& c = coloursOf(option.palette);
    const bool enabled = (option.state & State_Enabled) != 0;
    if (enabled && (option.state & State_HasFocus))
      return outline(painter, where, c.accent, std::max(Look::kFocus, c.border_width), corner);
    outline(painter, where, enabled ? c.control : c.disabled, c.border_width, corner,
            enabled ? Qt::SolidLine : Qt::DashLine);
  }

  // A flat one shows its panel only under the hand, with the focus, or pressed in.
  static void panel(QPainter& painter, const QStyleOption& option, bool flat) {
    const Colours& c = coloursOf(option.palette);
    const bool enabled = (option.state & State_Enabled) != 0;
    const bool over = enabled && (option.state & State_MouseOver);
    const bool in = (option.state & (State_On | State_Sunken)) != 0;
    const bool focus = enabled && (option.state & State_HasFocus);
    if (flat && !over && !in && !focus) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QColor ground = option.palette.color(QPalette::Button);
    if (over || in) ground = mixed(ground, c.accent, in ? 0.2 : 0.08);  // the accent shines through
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), Look::kCorner,
                            Look::kCorner);
    painter.restore();
    if (in || focus)
      return outline(painter, option.rect, c.accent,
                     std::max(Look::kFocus, c.border_width) + (in ? c.border_width : 0),
                     Look::kCorner);
    outline(painter, option.rect, enabled ? c.control : c.disabled, c.border_width, Look::kCorner,
            enabled ? Qt::SolidLine : Qt::DashLine);
  }
};

}  // namespace

QStyle* makeStyle() {
  return new OstrakaStyle;
}

}  // namespace ostraka::ui
