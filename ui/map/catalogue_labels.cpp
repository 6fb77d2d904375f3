#include "ui/map/catalogue_labels.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "catalogue/catalogue.h"

namespace ostraka::ui {
namespace {

QString placeOf(const catalogue::SherdRecord& sherd) {
  QStringList parts;
  for (const std::string* part : {&sherd.site, &sherd.trench, &sherd.context_number})
    if (!part->empty()) parts << QString::fromStdString(*part);
  QString place = parts.join(QStringLiteral(" / "));
  if (!sherd.bag_number.empty()) {
    if (!place.isEmpty()) place += QStringLiteral(", ");
    place += QCoreApplication::translate("ostraka::ui", "bag %1")
                 .arg(QString::fromStdString(sherd.bag_number));
  }
  return place;
}

QString codeOf(const catalogue::SherdRecord& sherd) {
  constexpr int kTail = 8;  // tells two sherds of one number apart, and keeps the code small
  return QStringLiteral("OST1:S:%1:%2")
      .arg(QString::fromStdString(sherd.number).toUpper(),
           QString::fromStdString(sherd.id).remove('-').right(kTail).toUpper());
}

}  // namespace

QVector<SherdLabel> withCatalogue(QVector<SherdLabel> labels, const pipeline::PlateMap& map,
                                  const catalogue::Catalogue& catalogue,
                                  const std::string& batch_number) {
  const auto batch = catalogue.batchByNumber(batch_number);
  if (!batch) return labels;
  const auto scans = catalogue.scans(batch->row);
  const auto rows = catalogue.sherdRows(batch->row);
  if (!scans || !rows) return labels;
  const auto sherds = catalogue.sherds(*rows);
  if (!sherds) return labels;
  qsizetype next = 0;
  for (const pipeline::MapMark& mark : map.front.marks) {
    if (mark.number.empty() || next >= labels.size()) continue;
    SherdLabel& label = labels[next++];
    const int index = QString::fromStdString(mark.number).toInt();
    const auto scan = std::find_if(scans->begin(), scans->end(), [&](const auto& s) {
      return s.side == batch::Side::Front && s.index == index;
    });
    if (scan == scans->end()) continue;
    const auto sherd = std::find_if(sherds->begin(), sherds->end(),
                                    [&](const auto& s) { return s.front == scan->row; });
    if (sherd == sherds->end()) continue;
    label.context = placeOf(*sherd);
    if (sherd->number.empty()) continue;
    label.number = QString::fromStdString(sherd->number);
    label.code = codeOf(*sherd);
  }
  return labels;
}

}  // namespace ostraka::ui
