#pragma once
#include "ui/look/state_colours.h"

class QPainter;
class QRect;

namespace ostraka::ui {

/// A state at the end of a row: its icon, its word, its colour. In sunlight, which takes colours
/// away, their edges differ as well.
struct Pill {
  State state;
  const char* icon;
  QString word;
};
QSize sizeOf(const Pill& pill, const QFontMetrics& metrics);
void drawPill(QPainter& painter, const QRect& where, const Pill& pill, const QPalette& palette);

/// A picture of sherds on its dark matte.
void drawThumbnail(QPainter& painter, const QRect& where, const QPixmap& picture);
/// The ground of a row, by whether it is selected and has the focus.
void drawRowGround(QPainter& painter, const QRect& row, const QPalette& palette, bool selected,
                   bool focus);

}  // namespace ostraka::ui
