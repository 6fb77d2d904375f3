#pragma once
#include <QColor>
#include <QIcon>
#include <QString>

class QApplication;
class QFont;
class QLabel;
class QPalette;
class QWidget;

namespace ostraka::ui {

/// The measures of the window in logical pixels at 100 % text, on a grid of 8, and its letters as
/// shares of the body's. No other file has one of its own.
struct Look {
  static constexpr int kGap = 8, kGroup = 16, kMargin = 24;
  static constexpr int kControl = 32;  ///< height of a control
  static constexpr int kPrimary = 44;  ///< of the primary button, and of what a glove presses
  static constexpr int kLabelColumn = 160, kField = 480;
  static constexpr int kRow = 56, kThumbnail = 48, kMatte = 4;
  static constexpr int kIcon = 20, kEmptyIcon = 56;
  static constexpr int kCorner = 6, kFocus = 2;
  static constexpr int kCompactBelow = 500;  ///< height of the window
  static constexpr int kBody = 13;           ///< pixels
  static constexpr double kTitle = 20.0 / kBody, kSection = 15.0 / kBody, kCaption = 12.0 / kBody,
                          kDecides = 28.0 / kBody;  ///< figures that decide
};

enum class Theme {
  System,  ///< light or dark, as the desktop is
  Light,
  Dark,      ///< for a dark tent
  Sunlight,  ///< black on white, thick lines
};

/// All colours of a theme. A colour never speaks alone: a word, an icon or a kind of line goes with
/// it. Text has a contrast of 4.5 : 1 against its ground, the edge of a control 3 : 1.
struct Colours {
  QColor page, surface, raised;
  QColor border;   ///< between parts of a page
  QColor control;  ///< the edge of what can be pressed or typed into
  int border_width;
  QColor text, secondary, disabled;
  QColor accent, on_accent;
  QColor good, check, bad;
  QColor front, back;  ///< of Okabe and Ito; told apart by colour-blind eyes
};
const Colours& coloursOf(Theme theme);  ///< System: light
const Colours& coloursOf(const QPalette& palette);

/// Inks upon photographs, whose ground is neither light nor dark.
struct PhotographInks {
  QColor halo, line, lit, lit_ground, good, bad, free_place, sherd_brush, plate_brush;
  QColor sherd;  ///< over what a mask takes for sherd: seen on every clay and on the plate
};
const PhotographInks& photographInks();

/// Inks upon paper, which is white in every theme.
struct PaperInks {
  QColor paper, ink, faint, lit;
};
const PaperInks& paperInks();

QString themeName(Theme theme);  ///< "system", as in the settings
Theme themeFromName(const QString& name);

/// What lies between two colours.
QColor mixed(const QColor& a, const QColor& b, double share_of_b);

/// Palette, text size and thickness of lines of the whole application.
void applyLook(QApplication& application, Theme theme, int text_percent);
QPalette paletteOf(Theme theme, const QPalette& system);
/// Of photographs and models: a dark matte in every theme.
QPalette mattePalette();
bool isSunlight();

/// A picture of resources/icons by name, drawn in the palette's text colour at any size and anew
/// when the palette changes.
/// ink: a colour of its own.
QIcon icon(const QString& name, const QColor& ink = {});

/// The heights of the two kinds of controls; they grow with the text.
int controlHeight(const QWidget& widget);
int targetSize(const QWidget& widget);
/// Larger text by a share of the body's: Look::kTitle, 3 = readable from three metres on a laptop.
QFont scaledFont(const QWidget& widget, double factor, bool semibold = false);
/// The same digits' width, for columns of figures.
QFont tabularFont(const QFont& font);
/// An empty label of this name, whose words go on in the next line where they need to.
QLabel* wrappedLabel(QWidget* parent, const QString& name);
/// The layout of a part that stands within a page, which has the margins.
template <class Layout>
Layout* bareLayout(QWidget* part) {
  auto* layout = new Layout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  return layout;
}
/// Width of a line that must be seen: 1 for hairlines, thicker in sunlight and on fine screens.
double lineWidth(const QWidget& widget, double weight = 1);

}  // namespace ostraka::ui
