#include "ui/map/catalogue_labels.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <optional>
#include <utility>

#include "catalogue/catalogue.h"
#include "catalogue/places.h"
#include "intake/plate_sherds.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherds.h"

namespace ostraka::ui {
namespace {

QString placeOf(const std::string& site, const std::string& trench, const std::string& context,
                const std::string& bag) {
  QStringList parts;
  for (const std::string* part : {&site, &trench, &context})
    if (!part->empty()) parts << QString::fromStdString(*part);
  QString place = parts.join(QStringLiteral(" / "));
  if (!bag.empty()) {
    if (!place.isEmpty()) place += QStringLiteral(", ");
    place += QCoreApplication::translate("ostraka::ui", "bag %1").arg(QString::fromStdString(bag));
  }
  return place;
}

// Those that the catalogue knows; before it knows any, those that were counted by hand.
QString contentsOf(const records::BagRecord& bag, const QString& initials) {
  const int written = bag.count_written.value_or(0);
  const QString who = bag.entered_by.empty() ? initials : QString::fromStdString(bag.entered_by);
  QString sherds;
  if (bag.sherds > 0 && written > 0 && written != bag.sherds)
    sherds = QCoreApplication::translate("ostraka::ui", "%1 of %n sherd(s)", nullptr, written)
                 .arg(bag.sherds);
  else if (bag.sherds + written > 0)
    sherds = QCoreApplication::translate("ostraka::ui", "%n sherd(s)", nullptr,
                                         bag.sherds > 0 ? bag.sherds : written);
  if (sherds.isEmpty() || who.isEmpty()) return sherds + who;
  return QCoreApplication::translate("ostraka::ui", "%1, %2").arg(sherds, who);
}

// kind: S of a sherd, B of a bag.
QString codeOf(QLatin1Char kind, const QString& number, const std::string& id) {
  constexpr int kTail = 8;  // tells two of one number apart, and keeps the code small
  return QStringLiteral("OST1:%1:%2:%3")
      .arg(kind)
      .arg(number.toUpper(), QString::fromStdString(id).remove('-').right(kTail).toUpper());
}

bool isTakenOut(const review::MapMark& mark) {
  return mark.state == review::CardState::Aside || mark.state == review::CardState::Reshoot;
}

void fillIn(PlateSherd& sherd, const QString& on_label, const records::SherdRecord& known,
            const review::MapMark& mark) {
  SherdLabel& label = sherd.label;
  label.context = placeOf(known.site, known.trench, known.context_number, known.bag_number);
  sherd.has_final_number = !known.number.empty();
  if (sherd.has_final_number) label.number = QString::fromStdString(known.number);
  label.code = codeOf(QLatin1Char('S'), sherd.has_final_number ? label.number : on_label, known.id);
  // A draft whose front has no partner is void without anybody's word.
  const bool alone = isTakenOut(mark) || mark.state == review::CardState::Alone;
  sherd.is_void = known.state == records::SherdState::Void && (sherd.has_final_number || !alone);
}

}  // namespace

QVector<PlateSherd> sherdsOnPlate(const review::PlateMap& map,
                                  const catalogue::Catalogue* catalogue,
                                  const QString& batch_number, const QString& date) {
  std::optional<intake::PlateSherds> known;
  if (catalogue != nullptr) known.emplace(*catalogue, batch_number.toStdString());
  QVector<PlateSherd> sherds;
  for (const review::MapMark& mark : map.front.marks) {
    if (mark.number.empty() || mark.part > 0) continue;
    PlateSherd sherd;
    sherd.on_plate = QString::fromStdString(mark.number);
    sherd.is_taken_out = isTakenOut(mark);
    const QString number = batch_number + QLatin1Char('-') + sherd.on_plate;
    sherd.label = {QCoreApplication::translate("ostraka::ui", "sherd %1 of %2")
                       .arg(MapNumbers().shown(sherd.on_plate), batch_number),
                   {},
                   date,
                   QStringLiteral("OST1:S:") + number.toUpper()};
    const records::SherdRecord* record = known ? known->at(mark.place_mm) : nullptr;
    if (record != nullptr) fillIn(sherd, number, *record, mark);
    if (const auto* again = known ? known->again(mark.place_mm) : nullptr)
      sherd.again = QCoreApplication::translate("ostraka::ui", "%1 in %2")
                        .arg(QString::fromStdString(again->number),
                             QString::fromStdString(again->batch_number));
    sherds.append(std::move(sherd));
  }
  return sherds;
}

QVector<SherdLabel> labelsOf(const QVector<PlateSherd>& sherds) {
  QVector<SherdLabel> labels;
  for (const PlateSherd& sherd : sherds)
    if (sherd.getsLabel()) labels.append(sherd.label);
  return labels;
}

namespace {

// What most begin with, so that most are short; it ends with a mark between two parts: 0012-, never
// 001. The others stand there whole: those written otherwise, for of another context nobody would
// tell the short ones. Empty where an end would be another's number.
QString commonBeginning(const QStringList& numbers) {
  QString best;
  qsizetype most_saved = 0;
  for (const QString& number : numbers)
    for (qsizetype size = 1; size < number.size(); ++size) {
      if (number[size - 1].isLetterOrNumber()) continue;
      const QString beginning = number.left(size);
      const auto sharing = std::ranges::count_if(numbers, [&](const QString& other) {
        return other.startsWith(beginning) && other.size() > size;
      });
      const bool clear = std::ranges::none_of(numbers, [&](const QString& other) {
        return other.startsWith(beginning)
                   ? numbers.contains(other.mid(size))
                   : other.count(QLatin1Char('-')) == number.count(QLatin1Char('-'));
      });
      if (2 * sharing < numbers.size() || sharing < std::min<qsizetype>(2, numbers.size()))
        continue;
      if (!clear || sharing * size <= most_saved) continue;
      most_saved = sharing * size;
      best = beginning;
    }
  return best;
}

}  // namespace

MapNumbers mapNumbers(const QVector<PlateSherd>& sherds) {
  MapNumbers numbers;
  for (const PlateSherd& sherd : sherds) {
    if (sherd.has_final_number) numbers.endings.insert(sherd.on_plate, sherd.label.number);
    if (sherd.is_void) numbers.voided.insert(sherd.on_plate);
    if (!sherd.again.isEmpty()) numbers.again.insert(sherd.on_plate, sherd.again);
  }
  if (numbers.endings.isEmpty()) return numbers;
  numbers.common = commonBeginning(numbers.endings.values());
  for (auto ending = numbers.endings.begin(); ending != numbers.endings.end(); ++ending) {
    if (numbers.common.isEmpty() || !ending->startsWith(numbers.common)) continue;
    ending->remove(0, numbers.common.size());
    numbers.shortened.insert(ending.key());
  }
  return numbers;
}

QVector<SherdLabel> sherdLabels(const catalogue::Catalogue& catalogue,
                                std::span<const store::SherdRow> sherds) {
  QVector<SherdLabel> labels;
  const auto records = sherds::Sherds(catalogue).of(sherds);
  if (!records) return labels;
  for (const records::SherdRecord& sherd : *records) {
    if (sherd.number.empty() || sherd.state == records::SherdState::Void) continue;
    const QString number = QString::fromStdString(sherd.number);
    labels.append({number,
                   placeOf(sherd.site, sherd.trench, sherd.context_number, sherd.bag_number),
                   {},
                   codeOf(QLatin1Char('S'), number, sherd.id)});
  }
  return labels;
}

QVector<SherdLabel> bagLabels(const catalogue::Catalogue& catalogue, const QString& initials) {
  QVector<SherdLabel> labels;
  const auto bags = catalogue::Places(catalogue).bags();
  const auto contexts = catalogue::Places(catalogue).contexts();
  if (!bags || !contexts) return labels;
  for (const records::BagRecord& bag : *bags) {
    const auto place =
        std::ranges::find_if(*contexts, [&](const auto& c) { return c.row == bag.context; });
    if (place == contexts->end()) continue;
    QStringList parts;
    for (const std::string* part :
         {&place->site_code, &place->trench_code, &place->number, &bag.number})
      if (!part->empty()) parts << QString::fromStdString(*part);
    const QString number = parts.join('-');
    labels.append({number, placeOf(place->site_code, place->trench_code, place->number, bag.number),
                   QString::fromStdString(bag.collected_on),
                   codeOf(QLatin1Char('B'), number, bag.id), contentsOf(bag, initials)});
  }
  std::ranges::stable_sort(labels, {}, &SherdLabel::number);
  return labels;
}

}  // namespace ostraka::ui
