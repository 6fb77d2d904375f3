#include "ui/frame/state_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::ui {
namespace {

struct Pair {
  QRgb on_light, on_dark;
};

// Blue and vermilion stay apart for every common kind of colour blindness (Okabe and Ito 2008); as
// text they keep a contrast of 4.5 : 1 against the ground.
constexpr Pair pairOf(State state) {
  switch (state) {
    case State::Sure:
      return {0xff00694d, 0xff4fcfa5};
    case State::Ask:
      return {0xff8a5200, 0xfff2b134};
    case State::Failed:
      return {0xffa3122f, 0xffff8fa3};
    case State::Busy:
      return {0xff4a3f9e, 0xffb9aefc};
    case State::Waiting:
      return {0xff595959, 0xffb4b4b4};
    case State::Aside:
      return {0xff6b4a3a, 0xffd3b8a6};
    case State::Front:
      return {0xff005fa3, 0xff62b8f5};
    case State::Back:
      return {0xffb84300, 0xffff9466};
    case State::Selected:
      return {0xff7a0f6f, 0xfff29be9};
    case State::Near:
      return {0xff00224e, 0xff35456c};
    case State::Far:
      return {0xffb39b1e, 0xfffee838};
  }
  return {0xff000000, 0xffffffff};
}

// Evenly spaced stops of a scale whose lightness rises all the way, so that it reads in grey too.
constexpr std::array<QRgb, 6> kScale = {0xff00224e, 0xff35456c, 0xff666970,
                                        0xff948e77, 0xffc8b866, 0xfffee838};

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto mix = [share_of_b](float x, float y) {
    return static_cast<float>(x + (y - x) * share_of_b);
  };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()),
                          mix(a.blueF(), b.blueF()));
}

}  // namespace

StateColours::StateColours(const QPalette& palette)
    : dark_(palette.color(QPalette::Base).lightnessF() < 0.5),
      base_(palette.color(QPalette::Base)) {}

QColor StateColours::of(State state) const {
  const Pair pair = pairOf(state);
  return QColor::fromRgb(dark_ ? pair.on_dark : pair.on_light);
}

QColor StateColours::behind(State state) const {
  return mixed(base_, of(state), dark_ ? 0.22 : 0.12);
}

QColor StateColours::alongRim(double t) const {
  const double at = std::clamp(t, 0.0, 1.0) * (kScale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kScale.size() - 2);
  return mixed(QColor::fromRgb(kScale[i]), QColor::fromRgb(kScale[i + 1]),
               at - static_cast<double>(i));
}

}  // namespace ostraka::ui
