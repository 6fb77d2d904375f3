#pragma once
#include <QColor>
#include <QPalette>
#include <QString>

namespace ostraka::ui {

/// What a colour stands for. Each goes along with a word and an icon or a kind of line.
enum class State {
  Sure,      ///< done, whole, agreed
  Ask,       ///< a person should look
  Failed,    ///< did not succeed
  Busy,      ///< being computed
  Waiting,   ///< its turn comes
  Aside,     ///< set aside by a person
  Front,     ///< the front side: the blue of the paper, solid lines
  Back,      ///< the back side: the red of the paper, dashed lines
  Selected,  ///< what the keys act on
  Near,      ///< a small distance along the rim
  Far,       ///< a large distance along the rim
};

/// The colours that have a meaning, for a light or a dark palette; told apart by colour-blind eyes.
/// All other colours are the palette's.
class StateColours {
 public:
  explicit StateColours(const QPalette& palette);
  QColor of(State state) const;      ///< for lines, marks and text on the palette's base
  QColor behind(State state) const;  ///< a quiet ground for text of the palette
  /// From Near to Far: t 0..1, even to the eye.
  QColor alongRim(double t) const;
  bool dark() const { return dark_; }

 private:
  bool dark_;
  QColor base_;
};

}  // namespace ostraka::ui
