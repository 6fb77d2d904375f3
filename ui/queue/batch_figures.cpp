#include "ui/queue/batch_figures.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "catalogue/catalogue.h"
#include "catalogue/photographed_again.h"

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
  figures.reshoot = kept[QStringLiteral("reshoot")].toInt();
  figures.uncertainty_mm = kept[QStringLiteral("uncertainty_mm")].toDouble();
  figures.seconds = kept[QStringLiteral("seconds")].toDouble();
  figures.draft = kept[QStringLiteral("draft")].toBool();
  figures.counted = kept[QStringLiteral("counted")].toInt();
  for (const QJsonValue& value : kept[QStringLiteral("moved")].toArray()) {
    const QJsonObject camera = value.toObject();
    figures.moved.push_back({camera[QStringLiteral("camera")].toInt(),
                             camera[QStringLiteral("residual_px")].toDouble(),
                             camera[QStringLiteral("moved_mm")].toDouble(),
                             camera[QStringLiteral("turned_rad")].toDouble()});
  }
  for (const QJsonValue& value : kept[QStringLiteral("unlike")].toArray()) {
    const QJsonObject sherd = value.toObject();
    figures.unlike.push_back({sherd[QStringLiteral("number")].toString().toStdString(),
                              sherd[QStringLiteral("before_mm")].toDouble(),
                              sherd[QStringLiteral("now_mm")].toDouble()});
  }
  for (const QJsonValue& value : kept[QStringLiteral("numbers_left")].toArray())
    figures.numbers_left.push_back(value.toString().toStdString());
  return figures;
}

std::optional<BatchFigures> shownFigures(const catalogue::Catalogue& rows, const QString& number) {
  std::optional<BatchFigures> figures = keptFigures(rows, number);
  const auto batch = rows.batchByNumber(number.toStdString());
  if (!figures || !batch) return figures;
  if (const auto again = catalogue::photographedAgain(rows, batch->row))
    figures->again = static_cast<int>(again->size());
  figures->reshoot = std::max(0, figures->reshoot - figures->again);
  const auto isOfBatch = [&](const std::string& sherd_number) {
    const auto row = rows.sherdByNumber(sherd_number);
    if (!row || !*row) return false;
    const auto sherd = rows.sherd(*row);
    return sherd && sherd->batch == batch->row;
  };
  std::erase_if(figures->numbers_left, isOfBatch);  // a person gave it since
  std::erase_if(figures->unlike, [&](const auto& sherd) { return !isOfBatch(sherd.number); });
  return figures;
}

Result<void> keepFigures(catalogue::Catalogue& rows, const QString& number,
                         const BatchFigures& figures) {
  QJsonObject kept;
  kept[QStringLiteral("sherds")] = figures.sherds;
  kept[QStringLiteral("sure")] = figures.sure;
  kept[QStringLiteral("decided")] = figures.decided;
  kept[QStringLiteral("ask")] = figures.ask;
  kept[QStringLiteral("reshoot")] = figures.reshoot;
  kept[QStringLiteral("uncertainty_mm")] = figures.uncertainty_mm;
  kept[QStringLiteral("seconds")] = figures.seconds;
  kept[QStringLiteral("draft")] = figures.draft;
  kept[QStringLiteral("counted")] = figures.counted;
  QJsonArray moved;
  for (const checks::MovedCamera& camera : figures.moved)
    moved.append(QJsonObject{{QStringLiteral("camera"), camera.camera},
                             {QStringLiteral("residual_px"), camera.residual_px},
                             {QStringLiteral("moved_mm"), camera.moved_mm},
                             {QStringLiteral("turned_rad"), camera.turned_rad}});
  kept[QStringLiteral("moved")] = moved;
  QJsonArray unlike;
  for (const catalogue::UnlikeBefore& sherd : figures.unlike)
    unlike.append(QJsonObject{{QStringLiteral("number"), QString::fromStdString(sherd.number)},
                              {QStringLiteral("before_mm"), sherd.before_mm},
                              {QStringLiteral("now_mm"), sherd.now_mm}});
  kept[QStringLiteral("unlike")] = unlike;
  QJsonArray left;
  for (const std::string& number_left : figures.numbers_left)
    left.append(QString::fromStdString(number_left));
  kept[QStringLiteral("numbers_left")] = left;
  return rows.setSetting(keyOf(number),
                         QJsonDocument(kept).toJson(QJsonDocument::Compact).toStdString());
}

}  // namespace ostraka::ui
