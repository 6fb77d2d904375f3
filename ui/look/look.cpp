#include "ui/look/look.h"

#include <QApplication>
#include <QLabel>
#include <QPalette>
#include <QWidget>
#include <algorithm>

#include "ui/look/style.h"

namespace ostraka::ui {
namespace {

constexpr double kPointsPerPixel = 72.0 / 96.0;
constexpr double kControlLines = 1.75, kPrimaryLines = 2.4;  // heights in lines of text
constexpr const char* kPlainPointSize = "ostrakaPlainPointSize";
constexpr const char* kPlainPalette = "ostrakaPlainPalette";

constexpr QColor rgb(int code) {
  return {(code >> 16) & 0xff, (code >> 8) & 0xff, code & 0xff};
}

constexpr Colours kLight = {
    rgb(0xf7f6f3), rgb(0xffffff), rgb(0xffffff), rgb(0xd8d5ce), rgb(0x8a857b), 1,
    rgb(0x1d1c1a), rgb(0x5d5a54), rgb(0x98948c), rgb(0x1c66a8), rgb(0xffffff), rgb(0x2c7a3f),
    rgb(0x8a5200), rgb(0xb3261e), rgb(0x0072b2), rgb(0xd55e00)};
constexpr Colours kDark = {
    rgb(0x17181a), rgb(0x202225), rgb(0x292c30), rgb(0x3a3e43), rgb(0x868b91), 1,
    rgb(0xeceae6), rgb(0xa8a49d), rgb(0x6c6964), rgb(0x5aa9ee), rgb(0x10151a), rgb(0x7bc68c),
    rgb(0xe7b15a), rgb(0xf2887f), rgb(0x56b4e9), rgb(0xe69f00)};
constexpr Colours kSunlight = {
    rgb(0xffffff), rgb(0xffffff), rgb(0xffffff), rgb(0x000000), rgb(0x000000), 2,
    rgb(0x000000), rgb(0x000000), rgb(0x6b6b6b), rgb(0x003a7a), rgb(0xffffff), rgb(0x1f5c2e),
    rgb(0x6b3f00), rgb(0x8c1a14), rgb(0x0072b2), rgb(0xd55e00)};
constexpr QColor kMatte = rgb(0x26282b);

QPalette filled(const Colours& c) {
  QPalette made(c.raised, c.page);
  made.setColor(QPalette::Window, c.page);
  made.setColor(QPalette::Base, c.surface);
  made.setColor(QPalette::AlternateBase, c.page);
  made.setColor(QPalette::Button, c.raised);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    made.setColor(role, c.text);
  made.setColor(kSecondaryText, c.secondary);
  made.setColor(QPalette::ToolTipBase, c.raised);
  made.setColor(QPalette::PlaceholderText, mixed(c.text, c.surface, 0.35));
  made.setColor(QPalette::Mid, c.border);
  made.setColor(QPalette::Dark, c.control);
  made.setColor(QPalette::Highlight, c.accent);
  made.setColor(QPalette::HighlightedText, c.on_accent);
  made.setColor(QPalette::Link, c.accent);
  made.setColor(QPalette::LinkVisited, c.accent);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    made.setColor(QPalette::Disabled, role, c.disabled);
  return made;
}

}  // namespace

const Colours& coloursOf(Theme theme) {
  return theme == Theme::Dark ? kDark : theme == Theme::Sunlight ? kSunlight : kLight;
}

const Colours& coloursOf(const QPalette& palette) {
  if (palette.color(QPalette::Base).lightnessF() < 0.5F) return kDark;
  return palette.color(QPalette::Highlight) == kSunlight.accent ? kSunlight : kLight;
}

const PhotographInks& photographInks() {
  static constexpr PhotographInks kInks = {
      QColor(0, 0, 0, 170),      rgb(0xffffff),           rgb(0xffff00),
      QColor(255, 255, 0, 60),   rgb(0x56b4e9),           rgb(0xff9466),
      QColor(255, 255, 255, 46), QColor(0, 90, 190, 160), QColor(255, 255, 255, 160),
      QColor(0, 90, 190, 120)};
  return kInks;
}

const PaperInks& paperInks() {
  static constexpr PaperInks kInks = {rgb(0xffffff), rgb(0x000000), rgb(0xa0a0a0), rgb(0xffff00)};
  return kInks;
}

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
  for (const Theme theme : {Theme::System, Theme::Dark, Theme::Sunlight})
    if (themeName(theme) == name) return theme;
  return Theme::Light;
}

// A desktop's own colours are not known to go together with ours: only its lightness is taken.
QPalette paletteOf(Theme theme, const QPalette& system) {
  if (theme == Theme::System)
    theme = system.color(QPalette::Window).lightnessF() < 0.5F ? Theme::Dark : Theme::Light;
  return filled(coloursOf(theme));
}

QPalette mattePalette() {
  QPalette made = filled(kDark);
  made.setColor(QPalette::Window, kMatte);
  made.setColor(QPalette::Base, kMatte);
  return made;
}

bool isSunlight() {
  return QApplication::palette().color(QPalette::Highlight) == kSunlight.accent;
}

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto mix = [share_of_b](float x, float y) {
    return static_cast<float>(x + (y - x) * share_of_b);
  };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()),
                          mix(a.blueF(), b.blueF()));
}

void applyLook(QApplication& application, Theme theme, int text_percent) {
  if (!application.property(kPlainPointSize).isValid()) {
    application.setProperty(kPlainPointSize, application.font().pointSizeF());
    application.setProperty(kPlainPalette, QVariant::fromValue(application.palette()));
    application.setStyle(makeStyle());  // the application owns it
  }
  application.setPalette(paletteOf(theme, application.property(kPlainPalette).value<QPalette>()));
  QFont font = application.font();
  const double plain =
      std::max(kPointsPerPixel * Look::kBody, application.property(kPlainPointSize).toDouble());
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

int controlHeight(const QWidget& widget) {
  return std::max(Look::kControl, static_cast<int>(kControlLines * widget.fontMetrics().height()));
}

int targetSize(const QWidget& widget) {
  return std::max(Look::kPrimary, static_cast<int>(kPrimaryLines * widget.fontMetrics().height()));
}

QFont scaledFont(const QWidget& widget, double factor, bool semibold) {
  QFont font = widget.font();
  font.setPointSizeF(QApplication::font().pointSizeF() * factor);
  if (semibold) font.setWeight(QFont::DemiBold);
  return font;
}

QFont tabularFont(const QFont& font) {
  // Qt 6.4 cannot ask a font for its tabular figures; DejaVu's and Noto's are tabular as they are.
  QFont figures = font;
  figures.setKerning(false);
  return figures;
}

QLabel* wrappedLabel(QWidget* parent, const QString& name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

double lineWidth(const QWidget& widget, double weight) {
  const double base = std::max(1.0, widget.fontMetrics().height() / 16.0);
  return base * weight * (isSunlight() ? 2 : 1);
}

}  // namespace ostraka::ui
