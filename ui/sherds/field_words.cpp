#include "ui/sherds/field_words.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <optional>

#include "records/shown_decimals.h"
#include "sherds/filter.h"
#include "sherds/sherd_fields.h"
#include "store/values.h"
#include "tables/column_names.h"
#include "ui/frame/free_tr.h"
#include "ui/frame/lines.h"
#include "ui/frame/term_words.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

namespace {

constexpr qsizetype kMostNamed = 4;
constexpr QLatin1String kCustomField("extra.");

// In English; null for a field that has none.
const char* labelOf(const QString& field) {
  static const QHash<QString, const char*> labels = {
      {"number", QT_TRANSLATE_NOOP("Fields", "number")},
      {"uuid", QT_TRANSLATE_NOOP("Fields", "identifier")},
      {"state", QT_TRANSLATE_NOOP("Fields", "state")},
      {"void_reason", QT_TRANSLATE_NOOP("Fields", "reason for voiding")},
      {"site", QT_TRANSLATE_NOOP("Fields", "site")},
      {"trench", QT_TRANSLATE_NOOP("Fields", "trench")},
      {"context", QT_TRANSLATE_NOOP("Fields", "context")},
      {"bag", QT_TRANSLATE_NOOP("Fields", "bag")},
      {"part", QT_TRANSLATE_NOOP("Fields", "part")},
      {"ware", QT_TRANSLATE_NOOP("Fields", "ware")},
      {"fabric", QT_TRANSLATE_NOOP("Fields", "fabric")},
      {"inclusions", QT_TRANSLATE_NOOP("Fields", "inclusions")},
      {"manufacture", QT_TRANSLATE_NOOP("Fields", "manufacture")},
      {"firing", QT_TRANSLATE_NOOP("Fields", "firing")},
      {"surface_out", QT_TRANSLATE_NOOP("Fields", "surface outside")},
      {"surface_in", QT_TRANSLATE_NOOP("Fields", "surface inside")},
      {"decoration", QT_TRANSLATE_NOOP("Fields", "decoration")},
      {"munsell_out", QT_TRANSLATE_NOOP("Fields", "Munsell outside")},
      {"munsell_in", QT_TRANSLATE_NOOP("Fields", "Munsell inside")},
      {"munsell_core", QT_TRANSLATE_NOOP("Fields", "Munsell core")},
      {"condition", QT_TRANSLATE_NOOP("Fields", "condition")},
      {"joins", QT_TRANSLATE_NOOP("Fields", "joins with")},
      {"one_with", QT_TRANSLATE_NOOP("Fields", "identical with")},
      {"vessel", QT_TRANSLATE_NOOP("Fields", "vessel")},
      {"period", QT_TRANSLATE_NOOP("Fields", "period")},
      {"date_edtf", QT_TRANSLATE_NOOP("Fields", "date")},
      {"length_mm", QT_TRANSLATE_NOOP("Fields", "length, mm")},
      {"width_mm", QT_TRANSLATE_NOOP("Fields", "width, mm")},
      {"thickness_min_mm", QT_TRANSLATE_NOOP("Fields", "minimum thickness, mm")},
      {"thickness_mean_mm", QT_TRANSLATE_NOOP("Fields", "thickness, mm")},
      {"thickness_max_mm", QT_TRANSLATE_NOOP("Fields", "maximum thickness, mm")},
      {"area_mm2", QT_TRANSLATE_NOOP("Fields", "area, mm²")},
      {"volume_mm3", QT_TRANSLATE_NOOP("Fields", "volume, mm³")},
      {"filled_pct", QT_TRANSLATE_NOOP("Fields", "unseen surface, %")},
      {"rim_diameter_mm", QT_TRANSLATE_NOOP("Fields", "rim diameter, mm")},
      {"rim_pct", QT_TRANSLATE_NOOP("Fields", "rim kept, %")},
      {"weight_g", QT_TRANSLATE_NOOP("Fields", "weight, g")},
      {"batch", QT_TRANSLATE_NOOP("Fields", "batch")},
      {"front", QT_TRANSLATE_NOOP("Fields", "front")},
      {"back", QT_TRANSLATE_NOOP("Fields", "back")},
      {"scale", QT_TRANSLATE_NOOP("Fields", "scale")},
      {"note", QT_TRANSLATE_NOOP("Fields", "note")},
      // Not of a sherd.
      {"place", QT_TRANSLATE_NOOP("Fields", "place")},
      {"model", QT_TRANSLATE_NOOP("Fields", "model")},
      {"entered", QT_TRANSLATE_NOOP("Fields", "entered")},
      {"excavated", QT_TRANSLATE_NOOP("Fields", "excavated")},
      {"labels", QT_TRANSLATE_NOOP("Fields", "labels")},
      {"measured_by_hand", QT_TRANSLATE_NOOP("Fields", "measured by hand")},
      {"mass_centre_x_mm", QT_TRANSLATE_NOOP("Fields", "centre of mass x, mm")},
      {"mass_centre_y_mm", QT_TRANSLATE_NOOP("Fields", "centre of mass y, mm")},
      {"mass_centre_z_mm", QT_TRANSLATE_NOOP("Fields", "centre of mass z, mm")},
      {"model_file", QT_TRANSLATE_NOOP("Fields", "model file")},
      {"image_file", QT_TRANSLATE_NOOP("Fields", "picture file")},
      {"drawing_file", QT_TRANSLATE_NOOP("Fields", "drawing file")},
      {"count_written", QT_TRANSLATE_NOOP("Fields", "sherds written on the bag")},
      {"column", QT_TRANSLATE_NOOP("Fields", "column of the CSV")},
      {"heading", QT_TRANSLATE_NOOP("Fields", "column")},
      {"unit", QT_TRANSLATE_NOOP("Fields", "unit")},
      {"meaning", QT_TRANSLATE_NOOP("Fields", "meaning")},
      {"person", QT_TRANSLATE_NOOP("Fields", "person")},
      {"name", QT_TRANSLATE_NOOP("Fields", "name")},
      {"initials", QT_TRANSLATE_NOOP("Fields", "initials")},
      {"code", QT_TRANSLATE_NOOP("Fields", "code")},
      {"location", QT_TRANSLATE_NOOP("Fields", "location")},
      {"kind", QT_TRANSLATE_NOOP("Fields", "kind")},
      {"excavated_on", QT_TRANSLATE_NOOP("Fields", "excavated on")},
      {"closed", QT_TRANSLATE_NOOP("Fields", "closed")},
      {"collected_on", QT_TRANSLATE_NOOP("Fields", "collected on")},
      {"storage", QT_TRANSLATE_NOOP("Fields", "storage")},
      {"operator", QT_TRANSLATE_NOOP("Fields", "operator")},
      {"counted", QT_TRANSLATE_NOOP("Fields", "counted sherds")},
      {"results", QT_TRANSLATE_NOOP("Fields", "results")},
      {"program", QT_TRANSLATE_NOOP("Fields", "program")},
      {"project", QT_TRANSLATE_NOOP("Fields", "project")},
      {"title", QT_TRANSLATE_NOOP("Fields", "title")},
      {"institution", QT_TRANSLATE_NOOP("Fields", "institution")},
      {"licence", QT_TRANSLATE_NOOP("Fields", "licence")},
      {"rights_holder", QT_TRANSLATE_NOOP("Fields", "rights holder")},
      {"numbering", QT_TRANSLATE_NOOP("Fields", "numbering")},
      {"sherd", QT_TRANSLATE_NOOP("Fields", "sherd")},
      {"photograph", QT_TRANSLATE_NOOP("Fields", "photograph")},
      {"scan", QT_TRANSLATE_NOOP("Fields", "scan")},
      {"file", QT_TRANSLATE_NOOP("Fields", "file")},
      {"vocabulary", QT_TRANSLATE_NOOP("Fields", "term")},
      {"mask_strokes", QT_TRANSLATE_NOOP("Fields", "mask strokes")},
      {"content", QT_TRANSLATE_NOOP("Fields", "content")}};
  return labels.value(field, nullptr);
}

// "thickness" of "thickness, mm".
QString withoutUnit(const QString& label) {
  return label.section(QLatin1Char(','), 0, 0).toCaseFolded();
}

}  // namespace

QString fieldLabel(const std::string& field) {
  const QString name = QString::fromStdString(field);
  const char* label = labelOf(name);
  if (label) return QCoreApplication::translate("Fields", label);
  return name.startsWith(kCustomField) ? name.mid(kCustomField.size()) : name;
}

bool isNumber(const std::string& field) {
  const records::SherdField* known = sherds::sherdField(field);
  return known != nullptr && known->kind == records::FieldKind::Number;
}

QString measureLabel(const std::string& kind) {
  if (records::unitOf(kind).empty()) return fieldLabel(kind);
  const std::string field = kind + "_" + records::unitOf(kind);
  const QString label = fieldLabel(field);
  return label == QString::fromStdString(field) ? fieldLabel(kind) : label;
}

QString measureText(double value, const std::string& unit) {
  return QLocale().toString(records::shownValue(value, unit), 'f', records::decimalsShown(unit));
}

QString enteredText(double value, const std::string& unit) {
  return QLocale().toString(value, 'f', records::decimalsEdited(value, unit));
}

QString measuredText(const records::Measurement& measurement) {
  const std::string& unit = measurement.unit;
  const QString value = measureText(measurement.value, unit);
  if (!measurement.uncertainty) return value;
  const double by = records::shownUncertainty(*measurement.uncertainty, unit);
  return tr("%1 ± %2").arg(value, measureText(by, unit));
}

QString sherdName(const records::SherdRecord& sherd) {
  if (!sherd.number.empty()) return QString::fromStdString(sherd.number);
  if (sherd.piece == 0 || sherd.batch_number.empty()) return tr("no number yet");
  return tr("sherd %1 of %2").arg(sherd.piece).arg(QString::fromStdString(sherd.batch_number));
}

QString stateLabel(records::SherdState state) {
  switch (state) {
    case records::SherdState::Numbered:
      return tr("numbered");
    case records::SherdState::Void:
      return tr("void");
    case records::SherdState::Draft:
      break;
  }
  return tr("no number yet");
}

QString methodLabel(const std::string& method) {
  if (method == "scale") return tr("on a scale");
  if (method == "calliper") return tr("with a calliper");
  if (method == "estimate") return tr("estimated by hand");
  if (method == "imported") return tr("imported");
  return tr("by the program");
}

bool isDoubtful(const records::SherdRecord& sherd, const std::string& field) {
  for (const std::string& kind : sherd.doubtful)
    if (field == kind + "_" + records::unitOf(kind)) return true;
  return false;
}

const double* computedBeside(const records::SherdRecord& sherd, const std::string& field) {
  for (const auto& [kind, value] : sherd.replaced)
    if (field == kind + "_" + records::unitOf(kind) || field == kind) return &value;
  return nullptr;
}

QString questionWords(const std::vector<records::MeasureFinding>& findings) {
  QStringList sentences;
  for (const records::MeasureFinding& finding : findings)
    sentences << wordsOf(records::sentenceOf(finding));
  return sentences.join(QLatin1Char(' '));
}

QString confirmWords(const std::vector<records::MeasureFinding>& findings) {
  const auto asks = [&](records::MeasureDoubt doubt) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const auto& finding) { return finding.doubt == doubt; });
  };
  if (asks(records::MeasureDoubt::ReplacesComputed)) return tr("Replace with measured value");
  if (asks(records::MeasureDoubt::DeletesComputed)) return tr("Delete computed value");
  return tr("Save this value");
}

QString withFieldNames(const QString& filter) {
  const auto isFilterField = [](const QString& name) {
    return sherds::parseFilter((name + QLatin1String(":*")).toStdString()).has_value();
  };
  QHash<QString, QString> names;
  for (const records::SherdField& field : sherds::filterFields()) {
    const QString name = QString::fromLatin1(field.name);
    const QString english = withoutUnit(QString::fromLatin1(labelOf(name)));
    const QString label = withoutUnit(fieldLabel(field.name));
    if (label.isEmpty() || label == english || label.contains(QLatin1Char(' '))) continue;
    const bool measure = field.kind == records::FieldKind::Number;  // known without its unit, too
    names.insert(label, measure && name.startsWith(english) ? english : name);
  }
  static const QRegularExpression kNames(
      QStringLiteral("\"[^\"]*\"|(?<=^|\\s|-)([^\\s:<>=\"-]+)(?=[:<>=])"));
  QString read;
  qsizetype done = 0;
  for (auto at = kNames.globalMatch(filter); at.hasNext();) {
    const auto found = at.next();
    const QString typed = found.captured(1);
    QString name = typed.isEmpty() ? QString() : names.value(typed.toCaseFolded());
    if (name.isEmpty() && !typed.isEmpty() && !isFilterField(typed))
      name = QString::fromStdString(tables::fieldOfColumn(typed.toStdString(), false));
    if (name.isEmpty()) continue;
    read += filter.mid(done, found.capturedStart(1) - done) + name;
    done = found.capturedEnd(1);
  }
  return read + filter.mid(done);
}

QString fieldText(const records::SherdRecord& sherd, const std::string& field,
                  const TermWords& words) {
  if (field == "state") return stateLabel(sherd.state);
  if (field == "scale") return sherd.scale_doubtful ? tr("in doubt") : QString();
  const std::string text = sherds::textOf(sherd, field);
  if (text.empty()) return {};
  if (!isNumber(field)) return words.shown(field, text);
  // Not std::stod: it obeys the language that Qt set.
  const auto value = store::parsedNumber(text);
  if (!value) return {};
  const std::string unit = records::unitOfMeasure(field);
  const QString number = measureText(*value, unit);
  if (const double* computed = computedBeside(sherd, field))
    return tr("%1 (computed %2)").arg(number, measureText(*computed, unit));
  return isDoubtful(sherd, field) ? tr("%1 ?").arg(number) : number;
}

QString typedText(const records::SherdField& field, const std::string& text) {
  const auto value = store::parsedNumber(text);
  if (field.kind != records::FieldKind::Number || !value) return QString::fromStdString(text);
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  const int decimals = records::decimalsEdited(*value, records::unitOfMeasure(field.name));
  return locale.toString(*value, 'f', decimals);
}

QString inTwoWays(const std::string& field, const QString& typed) {
  const std::string mark = QLocale().groupSeparator().toStdString();
  if (mark != "," && mark != ".") return {};
  if (!isNumber(field)) return {};
  const auto clear = store::readsOneWay(typed.toStdString(), mark.front());
  return clear ? QString() : wordsOf(clear.error().what);
}

QString leftBehindWords(const intake::Move& move) {
  QStringList said, bags, numbers;
  for (const catalogue::BagPlace& bag : move.lacking)
    bags << QCoreApplication::translate("ostraka::ui", "%1 in %2")
                .arg(QString::fromStdString(bag.bag), QString::fromStdString(bag.context));
  for (const std::string& number : move.numbers) numbers << QString::fromStdString(number);
  if (!bags.isEmpty())
    said << QCoreApplication::translate(
                "ostraka::ui", "%n sherd(s) leave their bag, because there is no bag %1 yet.",
                nullptr, move.without_bag)
                .arg(firstOf(bags, kMostNamed));
  else if (move.without_bag > 0)
    said << QCoreApplication::translate("ostraka::ui", "%n sherd(s) leave their bag.", nullptr,
                                        move.without_bag);
  if (!move.numbers.empty())
    said << QCoreApplication::translate("ostraka::ui",
                                        "%n sherd(s) keep a number of the old context: %1.",
                                        nullptr, static_cast<int>(move.numbers.size()))
                .arg(firstOf(numbers, kMostNamed));
  return said.join(QLatin1Char(' '));
}

QString conditionText(const sherds::Condition& condition) {
  const QString text = QString::fromStdString(condition.text);
  const char* english = labelOf(QString::fromStdString(condition.field));
  const qsizetype at = text.indexOf(QRegularExpression(QStringLiteral("[:<>=]")));
  if (english == nullptr || at <= 0) return text;
  const QString label = fieldLabel(condition.field);
  if (label == QString::fromUtf8(english)) return text;  // as it was typed
  return (condition.negated ? QStringLiteral("-") : QString()) +
         label.section(QLatin1Char(','), 0, 0) + text.mid(at);
}

QString when(std::int64_t ms) {
  return momentWords(QDateTime::fromMSecsSinceEpoch(ms));
}

}  // namespace ostraka::ui
