#pragma once
#include <QIcon>
#include <QString>

class QApplication;
class QFont;
class QPalette;
class QWidget;

namespace ostraka::ui {

enum class Theme {
  System,  ///< as the desktop says
  Light,
  Dark,      ///< for a dark tent
  Sunlight,  ///< black on white, thick lines
};

QString themeName(Theme theme);  ///< "system", as in the settings
Theme themeFromName(const QString& name);

/// Palette, text size and thickness of lines of the whole application.
void applyLook(QApplication& application, Theme theme, int text_percent);
QPalette paletteOf(Theme theme, const QPalette& system);

/// A picture of resources/icons by name, drawn in the palette's text colour at any size and anew
/// when the palette changes.
QIcon icon(const QString& name);

/// A size that a finger in a glove hits: 12 mm on this screen, at least 2.4 lines of text.
int targetSize(const QWidget& widget);
/// Larger text: 1 = body, 1.3 = heading, 3 = readable from three metres on a laptop.
QFont scaledFont(const QWidget& widget, double factor);
/// The same digits' width, for columns of figures.
QFont tabularFont(const QFont& font);
/// Width of a line that must be seen: 1 for hairlines, thicker in sunlight and on fine screens.
double lineWidth(const QWidget& widget, double weight = 1);

}  // namespace ostraka::ui
