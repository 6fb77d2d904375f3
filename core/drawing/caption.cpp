#include "drawing/caption.h"

#include <algorithm>

#include "base/message.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;

constexpr double kLeastWidth_mm = 70;                // of a line, however small the sherd is
constexpr double kHeading_mm = 4, kMeasures_mm = 3;  // of their letters

std::string share(const Estimate& kept, const Wording& w) {
  const auto percent = [&](double value) { return w.number(value, 0); };
  if (!kept.interval) return w.said(message("%1 % of the rim preserved", percent(kept.value)));
  return w.said(message("%1 % of the rim preserved (%2 to %3)", percent(kept.value),
                        percent(kept.interval->first), percent(kept.interval->second)));
}

std::string mouthLine(const Mouth& mouth, const Wording& w) {
  const auto cm = [&](double mm) { return w.number(mm / 10, 1); };
  const std::string diameter = cm(mouth.diameter_mm.value);
  const auto& interval = mouth.diameter_mm.interval;
  const std::string line = w.said(interval ? message("Ø %1 cm (95 %: %2 to %3)", diameter,
                                                     cm(interval->first), cm(interval->second))
                                           : message("Ø %1 cm", diameter));
  return mouth.kept_pct ? line + ", " + share(*mouth.kept_pct, w) : line;
}

std::string measuresLine(const model::Measures& m, const Wording& w) {
  const auto mm = [&](double value) { return w.number(value, 1); };
  const std::string line = mm(m.length_mm) + " × " + mm(m.width_mm) + " mm";
  if (!(m.thickness_mean_mm > 0)) return line;
  const bool range = m.thickness_min_mm > 0 && m.thickness_max_mm > 0;
  const Message wall = range ? message("wall %1 mm (%2 to %3)", mm(m.thickness_mean_mm),
                                       mm(m.thickness_min_mm), mm(m.thickness_max_mm))
                             : message("wall %1 mm", mm(m.thickness_mean_mm));
  return line + ", " + w.said(wall);
}

double widthOf(const std::string& text, double size_mm, Weight weight) {
  return textWidth({{0, 0}, size_mm, text, Anchor::Left, weight});
}

// At blanks; a word that is wider stays whole.
std::vector<std::string> broken(const std::string& text, double size_mm, double width_mm) {
  std::vector<std::string> lines(1);
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, end - from);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && widthOf(longer, size_mm, Weight::Plain) > width_mm)
      lines.push_back(word);
    else
      lines.back() = longer;
    from = end + 1;
  }
  return lines;
}

}  // namespace

void addCaption(SherdDrawing& drawing, const Wording& wording) {
  double y = drawing.box.max().y() + 6;
  const double x = drawing.box.min().x();
  const double width = std::max(kLeastWidth_mm, drawing.box.sizes().x());
  const auto add = [&](const std::string& text, double size_mm, Weight weight) {
    drawing.sheet.text({x, y}, size_mm, text, Anchor::Left, weight);
    drawing.box.extend(Vector2d(x + widthOf(text, size_mm, weight), y + 1));
    y += 1.45 * size_mm;
  };
  const auto addBroken = [&](const std::string& text, double size_mm) {
    for (const std::string& line : broken(text, size_mm, width)) add(line, size_mm, Weight::Plain);
  };
  add(wording.said(drawing.id), kHeading_mm, Weight::Bold);
  if (drawing.mouth) addBroken(mouthLine(*drawing.mouth, wording), kMeasures_mm);
  addBroken(measuresLine(drawing.measures, wording), kMeasures_mm);
}

}  // namespace ostraka::drawing
