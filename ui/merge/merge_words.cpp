#include "ui/merge/merge_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>

#include "records/shown_decimals.h"
#include "records/words.h"
#include "store/values.h"
#include "ui/frame/term_words.h"
#include "ui/merge/merge_model.h"
#include "ui/sherds/field_words.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

constexpr int kMostKeptNamed = 4;

QString text(const std::string& value) {
  return QString::fromStdString(value);
}

QString verdictWord(const std::string& verdict) {
  static const QHash<QString, const char*> words = {
      {"accept", QT_TRANSLATE_NOOP("Verdicts", "accepted")},
      {"reject", QT_TRANSLATE_NOOP("Verdicts", "rejected")},
      {"aside", QT_TRANSLATE_NOOP("Verdicts", "set aside")},
      {"reshoot", QT_TRANSLATE_NOOP("Verdicts", "to be photographed again")},
      {"join", QT_TRANSLATE_NOOP("Verdicts", "merged")},
      {"cut", QT_TRANSLATE_NOOP("Verdicts", "split")},
      {"withdraw", QT_TRANSLATE_NOOP("Verdicts", "withdrawn")}};
  const char* word = words.value(text(verdict), nullptr);
  return word ? QCoreApplication::translate("Verdicts", word) : text(verdict);
}

bool isMeasure(const merge::Conflict& conflict, const std::string& field) {
  return conflict.table == "sherd" && !records::unitOf(field).empty();
}

bool isDecision(const merge::Conflict& conflict) {
  return conflict.table == "pair_decision" || conflict.table == "piece_decision";
}

QString label(const merge::Conflict& conflict, const std::string& field) {
  if (field.starts_with("extra.")) return text(field.substr(6));
  if (isDecision(conflict)) return verdictWord(field);
  return isMeasure(conflict, field) ? measureLabel(field) : fieldLabel(field);
}

QString valueWords(const merge::Conflict& conflict, const std::string& field,
                   const std::string& value, const TermWords& terms) {
  if (field == "method") return methodLabel(value);
  if (isMeasure(conflict, field))
    if (const auto number = store::parsedNumber(value))
      return enteredText(*number, records::unitOfMeasure(field));
  if (conflict.table != "sherd") return text(value);
  return field == "state" ? stateLabel(records::fromWord<records::SherdState>(value))
                          : terms.shown(field, value);
}

}  // namespace

QString recordWords(const merge::Conflict& conflict) {
  const QString kind = isDecision(conflict) ? fieldLabel("batch") : fieldLabel(conflict.table);
  return conflict.name.empty() ? kind : kind + QLatin1Char(' ') + text(conflict.name);
}

QString fieldWords(const merge::Conflict& conflict) {
  if (conflict.table == "pair_decision")
    return QCoreApplication::translate("Verdicts", "pair of %1").arg(text(conflict.field));
  if (conflict.table == "piece_decision")
    return QCoreApplication::translate("Verdicts", "fragments: %1").arg(fieldLabel(conflict.field));
  return conflict.field.empty() ? QString() : label(conflict, conflict.field);
}

QString versionWords(const merge::Conflict& conflict, const merge::Version& version,
                     const TermWords& terms) {
  QStringList lines;
  for (const auto& [field, value] : version.values) {
    const QString shown = valueWords(conflict, field, value, terms);
    if (shown.isEmpty()) continue;
    if (field == "method" && !lines.isEmpty())
      lines.last() += QStringLiteral(" (%1)").arg(shown);
    else
      lines << (field == conflict.field
                    ? shown
                    : QStringLiteral("%1: %2").arg(label(conflict, field), shown));
  }
  if (lines.isEmpty()) lines << QStringLiteral("\u2013");
  QStringList who;
  if (!version.by.empty()) who << text(version.by);
  if (version.at_ms > 0) who << when(version.at_ms);
  if (!who.isEmpty()) lines << who.join(QStringLiteral(", "));
  return lines.join(QLatin1Char('\n'));
}

QString countWords(const merge::MergeReport& report) {
  const QLocale locale;
  return QCoreApplication::translate(
             "ostraka::ui::MergeModel",
             "Sherds: %1. Batches: %2. Changed records: %3. Files: %4 (%5).")
      .arg(locale.toString(report.sherds), locale.toString(report.batches),
           locale.toString(report.changed), locale.toString(report.files),
           locale.formattedDataSize(report.bytes));
}

QString keptWords(const std::vector<std::string>& kept) {
  QStringList places;
  for (const std::string& place : kept) places << text(place);
  return places.isEmpty() ? QString()
                          : MergeModel::tr(
                                "An earlier merge was interrupted and could not be completed here: "
                                "%1. What lies there is kept; the other project's version was left "
                                "out, or waits in the folder merge.partial.")
                                .arg(firstOf(places, kMostKeptNamed));
}

}  // namespace ostraka::ui
