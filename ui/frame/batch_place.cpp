#include "ui/frame/batch_place.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLocale>
#include <QStringList>

#include "batch/photographs.h"
#include "catalogue/batches.h"
#include "catalogue/catalogue.h"
#include "catalogue/label_codes.h"

namespace ostraka::ui {

QString placeWords(const catalogue::Catalogue& rows, const records::BatchRecord& batch) {
  const auto place = catalogue::placeOf(rows, batch);
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
  QStringList parts;
  if (const auto invented = catalogue::Batches(rows).isInvented(batch.row); invented && *invented)
    parts << QCoreApplication::translate("PlaceText", "invented by the virtual rig");
  parts << placeWords(rows, batch);
  if (batch.started_ms)
    parts << QLocale::c().toString(QDateTime::fromMSecsSinceEpoch(*batch.started_ms).date(),
                                   QStringLiteral("yyyy-MM-dd"));
  if (batch.counted > 0)
    parts << QCoreApplication::translate("PlaceText", "%n sherd(s) counted", nullptr,
                                         batch.counted);
  parts.removeAll(QString());
  return parts.join(QStringLiteral(", "));
}

QString frontPicture(const std::filesystem::path& folder) {
  const QDir front(QString::fromStdString((folder / "front").string()));
  const QStringList files =
      front.entryList({QStringLiteral("cam*_pos00.*")}, QDir::Files, QDir::Name | QDir::Reversed);
  if (!files.isEmpty()) return front.filePath(files.first());
  const std::vector<std::filesystem::path> any = batch::photographsIn(folder / "front");
  return any.empty() ? QString() : QString::fromStdString(any.front().string());
}

}  // namespace ostraka::ui
