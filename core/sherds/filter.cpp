// The filter line: words into conditions.
#include "sherds/filter.h"

#include "base/message.h"
#include "base/text.h"
#include "catalogue/label_codes.h"
#include "sherds/sherd_columns.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::sherds {
namespace {

// One piece of the line; quoted parts keep their blanks.
struct Piece {
  std::string text;             ///< as typed
  std::string plain;            ///< without the quotes
  std::size_t operator_at = 0;  ///< of the first : < > = outside quotes, npos when there is none
  bool value_quoted = false;    ///< quotes behind it
};

Result<std::vector<Piece>> pieces(std::string_view line) {
  std::vector<Piece> all;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == ' ' || line[i] == '\t') {
      ++i;
      continue;
    }
    Piece piece;
    piece.operator_at = std::string::npos;
    bool inside = false;
    for (; i < line.size() && (inside || (line[i] != ' ' && line[i] != '\t')); ++i) {
      piece.text += line[i];
      if (line[i] == '"') {
        inside = !inside;
        piece.value_quoted |= piece.operator_at != std::string::npos;
        continue;
      }
      const bool is_operator = std::string_view(":<>=").find(line[i]) != std::string_view::npos;
      if (is_operator && !inside && piece.operator_at == std::string::npos)
        piece.operator_at = piece.plain.size();
      piece.plain += line[i];
    }
    if (inside)
      return Error::unusable(message("The filter has an unclosed quotation mark."), piece.text);
    all.push_back(std::move(piece));
  }
  return all;
}

Condition::Is comparison(std::string_view& rest) {
  using Is = Condition::Is;
  const bool or_equal = rest.size() > 1 && rest[1] == '=';
  const char sign = rest[0];
  rest.remove_prefix(or_equal ? 2 : 1);
  if (sign == '<') return or_equal ? Is::LessEqual : Is::Less;
  if (sign == '>') return or_equal ? Is::GreaterEqual : Is::Greater;
  return Is::Equal;
}

bool isComparison(Condition::Is is) {
  using Is = Condition::Is;
  return is == Is::Less || is == Is::LessEqual || is == Is::Greater || is == Is::GreaterEqual;
}

// Of a year or a month as well: 2026, 2026-07.
std::string firstDay(const std::string& days) {
  return days.size() == 4 ? days + "-01-01" : days.size() == 7 ? days + "-01" : days;
}

// The code of a printed label, as a code reader types it, finds the sherd that carries it.
Result<Condition> conditionOfLabel(const std::string& code) {
  const std::optional<catalogue::LabelCode> label = catalogue::readLabelCode(code);
  if (!label || label->of != catalogue::LabelCode::Of::Sherd)
    return Error::unusable(message("This is only part of a sherd's label; scan its code again."),
                           code);
  Condition condition;
  const bool quoted = code.find(' ') != std::string::npos;
  condition.text = quoted ? "label:\"" + code + "\"" : "label:" + code;
  condition.field = label->id_end.empty() ? kLabelPlace : kLabelEnd;
  condition.is = Condition::Is::Equal;
  condition.value = label->id_end.empty() ? label->number : label->id_end;
  return condition;
}

// extra.NAME, or a name in quotation marks; empty: no such name.
std::string customField(const std::string& name, const std::string& typed) {
  if (name.starts_with("extra.")) return name;
  return typed.starts_with('"') || typed.starts_with("-\"") ? "extra." + name : std::string();
}

// A text that may hold several words, or a number of several parts.
bool isFreeText(const SherdColumn& column) {
  using K = records::FieldKind;
  const K kind = column.field.kind;
  return column.text && column.field.editable &&
         (kind == K::Text || kind == K::Munsell || kind == K::Edtf);
}

Result<Condition> conditionOf(Piece piece) {
  Condition condition;
  condition.text = piece.text;
  if (catalogue::beginsAsSherdLabel(piece.plain)) return conditionOfLabel(piece.plain);
  if (piece.plain.size() > 1 && piece.plain[0] == '-' && piece.text[0] == '-') {
    condition.negated = true;
    piece.plain.erase(0, 1);
    if (piece.operator_at != std::string::npos) --piece.operator_at;
  }
  const bool named = piece.operator_at != std::string::npos && piece.operator_at > 0;
  if (!named) {
    condition.value = store::composed(piece.plain);
    return condition;
  }
  const std::string name = store::uniqueKey(piece.plain.substr(0, piece.operator_at));
  std::string_view rest = std::string_view(piece.plain).substr(piece.operator_at);
  condition.is = comparison(rest);
  condition.value = store::composed(store::trimmed(rest));
  if (name == kLabelEnd) {
    Result<Condition> label = conditionOfLabel(condition.value);
    if (label) label->negated = condition.negated;
    if (label) label->text = piece.text;
    return label;
  }
  const SherdColumn* column = sherdColumn(name);
  condition.field = column ? column->field.name : customField(name, piece.text);
  if (condition.field.empty())
    return Error::unusable(message("The filter has no field '%1'; write extra.%1 for a custom "
                                   "field, or enclose the word in quotation marks to search for it "
                                   "literally.",
                                   name),
                           piece.text);
  const bool measure = column && column->measure;
  const bool is_day = column && column->field.kind == records::FieldKind::Day;
  if (isComparison(condition.is) && !measure && !is_day)
    return Error::unusable(
        message("Only measurements and days accept < and >; write %1:value.", name), piece.text);
  if (condition.is == Condition::Is::Equal && condition.value == "*")
    condition.is = Condition::Is::NotEmpty;
  else if (condition.is == Condition::Is::Equal && condition.value.empty())
    condition.is = Condition::Is::Empty;
  else if (measure) {
    if (const Result<double> number = store::parsedNumber(condition.value); !number)
      return Error::unusable(number.error().what, piece.text);
    if (const Result<void> clear = store::readsOneWay(condition.value); !clear)
      return Error::unusable(clear.error().what, piece.text);
  } else if (is_day) {
    if (const Result<std::string> day = store::checkedDay(firstDay(condition.value)); !day)
      return Error::unusable(day.error().what, piece.text);
  } else if (!piece.value_quoted && (!column || isFreeText(*column))) {
    condition.is = Condition::Is::Contains;
  }
  return condition;
}

}  // namespace

std::string Filter::text() const {
  std::string line;
  for (const Condition& condition : conditions) {
    if (!line.empty()) line += ' ';
    line += condition.text;
  }
  return line;
}

Result<Filter> parseFilter(std::string_view line) {
  if (line.size() > 10'000 || !isUtf8(line))
    return Error::unusable(message("The filter is not valid text."));
  if (catalogue::beginsAsSherdLabel(store::trimmed(line)) &&
      catalogue::readLabelCode(line)) {  // its number may hold blanks
    Result<Condition> label = conditionOfLabel(store::trimmed(line));
    if (!label) return label.error();
    return Filter{{std::move(*label)}};
  }
  const Result<std::vector<Piece>> all = pieces(line);
  if (!all) return all.error();
  Filter filter;
  for (const Piece& piece : *all) {
    if (piece.plain.empty()) continue;
    Result<Condition> condition = conditionOf(piece);
    if (!condition) return condition.error();
    filter.conditions.push_back(std::move(*condition));
  }
  return filter;
}

}  // namespace ostraka::sherds
