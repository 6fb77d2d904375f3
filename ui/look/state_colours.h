#pragma once
#include <QColor>
#include <QPalette>

#include "ui/look/look.h"

namespace ostraka::ui {

/// What a colour stands for. Each goes along with a word and an icon or a kind of line.
enum class State {
  Sure,      ///< done, whole, agreed
  Ask,       ///< a person should look
  Failed,    ///< did not succeed
  Busy,      ///< being computed
  Waiting,   ///< its turn comes
  Aside,     ///< set aside by a person
  Front,     ///< the front side: blue, solid lines
  Back,      ///< the back side: orange, dashed lines
  Selected,  ///< what the keys act on
};

/// The colours that have a meaning, for a light or a dark palette; told apart by colour-blind eyes.
/// All other colours are the palette's.
class StateColours {
 public:
  explicit StateColours(const QPalette& palette);
  /// For what stands on the dark matte around photographs and models, the same in every theme.
  static StateColours onMatte();
  static QColor matte();
  static QColor inkOnMatte();
  QColor of(State state) const;      ///< for lines, marks and text on the palette's base
  QColor behind(State state) const;  ///< a quiet ground for text of the palette

 private:
  const Colours& colours_;
  bool dark_;
  QColor base_;
};

}  // namespace ostraka::ui
