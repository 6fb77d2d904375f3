#include "ui/queue/batch_figures.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "catalogue/catalogue.h"

namespace ostraka::ui {
namespace {

std::string keyOf(const QString& number) {
  return "queue.figures." + number.toStdString();
}

}  // namespace

std::optional<BatchFigures> keptFigures(const catalogue::Catalogue& rows, const QString& number) {
  const Result<std::string> text = rows.setting(keyOf(number));
  if (!text || text->empty()) return std::nullopt;
  const QJsonObject kept = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  if (kept.isEmpty()) return std::nullopt;
  BatchFigures figures;
  figures.sherds = kept[QStringLiteral("sherds")].toInt();
  figures.sure = kept[QStringLiteral("sure")].toInt();
  figures.decided = kept[QStringLiteral("decided")].toInt();
  figures.ask = kept[QStringLiteral("ask")].toInt();
  figures.uncertainty_mm = kept[QStringLiteral("uncertainty_mm")].toDouble();
  figures.seconds = kept[QStringLiteral("seconds")].toDouble();
  figures.draft = kept[QStringLiteral("draft")].toBool();
  figures.counted = kept[QStringLiteral("counted")].toInt();
  return figures;
}

Result<void> keepFigures(catalogue::Catalogue& rows, const QString& number,
                         const BatchFigures& figures) {
  QJsonObject kept;
  kept[QStringLiteral("sherds")] = figures.sherds;
  kept[QStringLiteral("sure")] = figures.sure;
  kept[QStringLiteral("decided")] = figures.decided;
  kept[QStringLiteral("ask")] = figures.ask;
  kept[QStringLiteral("uncertainty_mm")] = figures.uncertainty_mm;
  kept[QStringLiteral("seconds")] = figures.seconds;
  kept[QStringLiteral("draft")] = figures.draft;
  kept[QStringLiteral("counted")] = figures.counted;
  return rows.setSetting(keyOf(number),
                         QJsonDocument(kept).toJson(QJsonDocument::Compact).toStdString());
}

}  // namespace ostraka::ui
