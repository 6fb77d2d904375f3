#include "ui/queue/batch_failure.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "catalogue/catalogue.h"
#include "catalogue/settings.h"
#include "files/json_message.h"
#include "records/words.h"
#include "ui/queue/batch_queue.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

constexpr QLatin1String kCancelled("cancelled"), kAside("aside"), kWas("was"), kRemoved("removed"),
    kWhat("what"), kWhere("where");

std::string failureKey(const QString& number) {
  return "queue.failure." + number.toStdString();
}

}  // namespace

BatchFailure keptFailure(const catalogue::Catalogue& rows, const QString& number) {
  const Result<std::string> text = catalogue::Settings(rows).value(failureKey(number));
  if (!text || text->empty()) return {};
  const QJsonObject kept = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  BatchFailure failure;
  const std::string where = kept[kWhere].toString().toStdString();
  failure.error = {ErrorCode::Failed, {}, where};
  for (const Message& what : messagesFromText(kept[kWhat].toString().toStdString(), where))
    failure.error.what = what;
  failure.cancelled = kept[kCancelled].toBool();
  failure.removed = kept[kRemoved].toBool();
  failure.aside = kept[kAside].toBool();
  if (const std::string was = kept[kWas].toString().toStdString(); !was.empty())
    failure.was = records::fromWord<records::BatchState>(was);
  return failure;
}

Result<void> keepFailure(catalogue::Catalogue& rows, const QString& number,
                         const BatchFailure& failure) {
  QJsonObject kept{{kCancelled, failure.cancelled}};
  if (failure.removed) kept[kRemoved] = true;
  if (failure.aside) kept[kAside] = true;
  if (failure.was) kept[kWas] = QString::fromLatin1(records::wordOf(*failure.was));
  if (!failure.error.what.empty()) {
    kept[kWhat] = QString::fromStdString(textOf({failure.error.what}));
    kept[kWhere] = QString::fromStdString(failure.error.where);
  }
  return catalogue::Settings(rows).setValue(
      failureKey(number), QJsonDocument(kept).toJson(QJsonDocument::Compact).toStdString());
}

Result<void> forgetFailure(catalogue::Catalogue& rows, const QString& number) {
  return catalogue::Settings(rows).setValue(failureKey(number), {});
}

QString wordsOf(const BatchFailure& failure) {
  if (failure.aside)
    return BatchQueue::tr("You set it aside. Its photographs are kept; R takes it up again.");
  if (failure.removed) return BatchQueue::tr("You removed it from the queue.");
  if (failure.cancelled) return BatchQueue::tr("You cancelled it. Finished stages are saved.");
  if (!failure.error.what.empty()) return sentenceOf(failure.error);
  return BatchQueue::tr("It was interrupted. Reprocess it.");
}

}  // namespace ostraka::ui
