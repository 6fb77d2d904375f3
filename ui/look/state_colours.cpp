#include "ui/look/state_colours.h"

namespace ostraka::ui {

StateColours::StateColours(const QPalette& palette)
    : colours_(coloursOf(palette)),
      dark_(palette.color(QPalette::Base).lightnessF() < 0.5F),
      base_(palette.color(QPalette::Base)) {}

QColor StateColours::of(State state) const {
  switch (state) {
    case State::Sure:
      return colours_.good;
    case State::Ask:
      return colours_.check;
    case State::Failed:
      return colours_.bad;
    case State::Busy:
    case State::Selected:
      return colours_.accent;
    case State::Waiting:
    case State::Aside:
      return colours_.secondary;
    case State::Front:
      return colours_.front;
    case State::Back:
      return colours_.back;
  }
  return colours_.text;
}

QColor StateColours::behind(State state) const {
  return mixed(base_, of(state), dark_ ? 0.18 : 0.09);
}

StateColours StateColours::onMatte() {
  return StateColours(mattePalette());
}

QColor StateColours::matte() {
  return mattePalette().color(QPalette::Base);
}

QColor StateColours::inkOnMatte() {
  return mattePalette().color(QPalette::Text);
}

}  // namespace ostraka::ui
