#include "ui/import/side_labels.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace ostraka::ui {
namespace {

bool isAmong(const std::vector<PlaceText>& bags, const PlaceText& bag) {
  return std::ranges::any_of(bags, [&](const PlaceText& one) { return !one.differsFrom(bag); });
}

std::vector<PlaceText> together(const std::vector<PlaceText>& front,
                                const std::vector<PlaceText>& back) {
  std::vector<PlaceText> all = front;
  for (const PlaceText& bag : back)
    if (!isAmong(all, bag)) all.push_back(bag);
  return all;
}

}  // namespace

std::optional<PlaceText> SideLabels::bag() const {
  const std::vector<PlaceText> all = together(front, back);
  return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

QString SideLabels::doubt(const PlaceText& place) const {
  const std::vector<PlaceText> all = together(front, back);
  const bool apart =
      !front.empty() && !back.empty() &&
      std::ranges::none_of(front, [this](const PlaceText& bag) { return isAmong(back, bag); });
  if (apart)
    return QCoreApplication::translate(
               "SideLabels",
               "A label among the fronts names %1, one among the backs %2: check that both sides "
               "show the same sherds, and type the bag that they are from.")
        .arg(wordsOf(front), wordsOf(back));
  if (all.size() > 1)
    return QCoreApplication::translate("SideLabels",
                                       "Labels of several bags are in the photographs: %1. Type "
                                       "the one that these sherds are from.")
        .arg(wordsOf(all));
  if (all.empty() || place.isEmpty() || !all.front().differsFrom(place)) return {};
  return QCoreApplication::translate("SideLabels",
                                     "The label in the photographs names %1: check the bag.")
      .arg(wordsOf(all));
}

SideLabels labelsOf(const std::vector<capture::PhotographCodes>& seen, const ImportSides& sides,
                    const std::function<std::optional<PlaceText>(const QString&)>& reader) {
  QStringList front, back;
  for (const capture::PhotographCodes& photograph : seen) {
    const bool of_back = std::ranges::find(sides.back, photograph.file) != sides.back.end();
    for (const std::string& text : photograph.texts)
      (of_back ? back : front) << QString::fromStdString(text);
  }
  return {bagsOn(front, reader), bagsOn(back, reader)};
}

}  // namespace ostraka::ui
