#include "ui/frame/batch_place.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QStringList>

#include "catalogue/batches.h"
#include "catalogue/catalogue.h"
#include "catalogue/label_codes.h"

namespace ostraka::ui {

QString placeWords(const catalogue::Catalogue& rows, const records::BatchRecord& batch) {
  if (batch.bags.empty()) return {};
  const auto place = catalogue::placeOf(rows, batch.bags.front());
  if (!place || !*place) return {};
  QStringList parts;
  for (const std::string& part : {(*place)->site, (*place)->trench, (*place)->context})
    if (!part.empty()) parts << QString::fromStdString(part);
  const QString all = parts.join(QStringLiteral(" / "));
  if ((*place)->bag.empty()) return all;
  return QCoreApplication::translate("PlaceText", "%1 bag %2")
      .arg(all, QString::fromStdString((*place)->bag));
}

QString batchWords(const catalogue::Catalogue& rows, const QString& number) {
  const auto batch = catalogue::Batches(rows).byNumber(number.toStdString());
  const QString place = batch ? placeWords(rows, *batch) : QString();
  return place.isEmpty() ? number : QStringLiteral("%1, %2").arg(number, place);
}

QString aboutBatch(const catalogue::Catalogue& rows, const records::BatchRecord& batch) {
  QStringList parts{placeWords(rows, batch)};
  if (batch.started_ms)
    parts << QLocale::c().toString(QDateTime::fromMSecsSinceEpoch(*batch.started_ms).date(),
                                   QStringLiteral("yyyy-MM-dd"));
  if (batch.counted > 0)
    parts << QCoreApplication::translate("PlaceText", "%n sherd(s) counted", nullptr,
                                         batch.counted);
  parts.removeAll(QString());
  return parts.join(QStringLiteral(", "));
}

}  // namespace ostraka::ui
