#include "tables/column_mapping.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/median.h"
#include "base/message.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "files/json_text.h"
#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "store/values.h"
#include "tables/column_names.h"
#include "tables/column_numbers.h"

namespace ostraka::tables {
namespace {

using nlohmann::json;

constexpr std::size_t kSamples = 3, kMostLookedAt = 1000;
constexpr const char* kSetting = "import_columns.";

// Columns that an export writes beside the fields; they say nothing about the sherd itself.
constexpr const char* kBeside[] = {"model_file",      "image_file",       "drawing_file",
                                   "licence",         "mass_centre_x_mm", "mass_centre_y_mm",
                                   "mass_centre_z_mm"};
constexpr const char* kByHand = "measured_by_hand";

// What contexts and bags never have. Of pits and layers there are lengths, diameters and colours.
constexpr const char* kOnlyOfSherds[] = {"part",
                                         "ware",
                                         "fabric",
                                         "inclusions",
                                         "manufacture",
                                         "firing",
                                         "surface_out",
                                         "surface_in",
                                         "decoration",
                                         "joins",
                                         "vessel",
                                         "thickness_min_mm",
                                         "thickness_mean_mm",
                                         "thickness_max_mm",
                                         "rim_pct"};

template <class List>
bool holds(const List& list, const std::string& name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

// The same columns in another order are the same kind of table.
std::string settingOf(std::vector<std::string> columns) {
  std::sort(columns.begin(), columns.end());
  return kSetting + sha256(json(columns).dump()).substr(0, 32);
}

// Below it the numbers of a field are rather of its next larger unit: few walls are thinner than
// 2.5 mm, and as few thicker than 2.5 cm.
double leastOwn(const std::string& field) {
  if (field.starts_with("thickness")) return 2.5;
  if (field == "rim_diameter_mm") return 45;
  return field == "weight_g" ? 1 : 15;
}

// Beyond it a part of a rim is in %: a share is at most 1, and its estimate hardly more.
constexpr double kMostShare = 1.5;

// From the values; what each of them says itself needs none.
void proposeUnit(const CsvTable& table, std::size_t column, ColumnChoice& choice) {
  const std::vector<std::string> units = unitsOf(choice.field);
  choice.unit = units.empty() ? std::string() : units.front();
  if (units.size() < 2) return;
  std::vector<double> values;
  for (const CsvRow& row : table.rows) {
    if (values.size() == kMostLookedAt) break;
    const WrittenNumber written = writtenNumber(cellOf(row, column));
    if (!written.unit.empty() || written.text.empty() || written.text.starts_with('<')) continue;
    if (const Result<double> number = store::parsedNumber(written.text)) values.push_back(*number);
  }
  const bool of_a_whole = units.back() == "share";
  choice.unit_idle = values.empty() ||
                     (of_a_whole && *std::max_element(values.begin(), values.end()) > kMostShare);
  choice.unit_guessed = !choice.unit_idle;
  if (choice.unit_idle) return;
  if (of_a_whole) {
    choice.unit = units.back();
    return;
  }
  if (medianOf(values) < leastOwn(choice.field)) choice.unit = units[1];
}

Error noUnit(const std::string& unit, const std::string& field, const std::string& where) {
  return Error::unusable(
      message("The field %1 has no unit '%2'; choose another unit.", field, unit), where);
}

class Mapper {
 public:
  Mapper(const CsvTable& table, const std::string& where) : table_(table), where_(where) {
    for (const std::string& column : table.columns) mapping_.columns.push_back({column, {}});
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      ColumnChoice& choice = mapping_.columns[i];
      choice.by = ChosenBy::Nobody;
      for (const CsvRow& row : table.rows) {
        if (choice.samples.size() == kSamples) break;
        const std::string value = cellOf(row, i);
        if (!value.empty() && !holds(choice.samples, value)) choice.samples.push_back(value);
      }
    }
  }

  Result<void> take(const std::vector<ColumnChoice>& chosen, ChosenBy by) {
    for (const ColumnChoice& one : chosen) {
      const auto found =
          std::find_if(mapping_.columns.begin(), mapping_.columns.end(),
                       [&](const ColumnChoice& column) { return column.column == one.column; });
      if (found == mapping_.columns.end())
        return Error::unusable(message("The table has no column '%1'; check its name.", one.column),
                               where_);
      if (found->by != ChosenBy::Nobody || !found->field.empty()) continue;
      if (by == ChosenBy::Earlier && !one.field.empty() && isTaken(one.field)) continue;
      found->field = one.field;
      found->unit = one.unit;
      found->unit_guessed = one.unit_guessed && !one.unit.empty();  // seen, but not chosen
      found->unit_idle = one.unit_idle && !one.unit.empty();
      found->by = by == ChosenBy::Person ? one.by : by;  // a person also keeps what was proposed
    }
    return {};
  }

  Result<TableMapping> finish() {
    const std::string numbers = columnOfNumbers();
    mapping_.of_contexts = numbers.empty();
    for (ColumnChoice& choice : mapping_.columns)  // exact names come before other languages
      if (isOpen(choice)) byExactName(choice);
    for (ColumnChoice& choice : mapping_.columns)
      if (isOpen(choice)) byName(choice);
    if (mapping_.of_contexts) mapping_.missing = missing();
    if (mapping_.missing.empty())
      mapping_.kind =
          mapping_.of_contexts
              ? message("Read as a table of contexts and bags: no column has the sherds' numbers.")
              : message("Read as a table of sherds: the column '%1' identifies them.", numbers);
    for (std::size_t i = 0; i < mapping_.columns.size(); ++i)
      if (Result<void> good = settle(mapping_.columns[i], i); !good) return good.error();
    return std::move(mapping_);
  }

 private:
  static bool isOpen(const ColumnChoice& choice) {
    return choice.by == ChosenBy::Nobody && choice.field.empty();
  }
  // Empty: none has numbers or uuids.
  std::string columnOfNumbers() const {
    const auto& columns = mapping_.columns;
    const auto found = std::find_if(columns.begin(), columns.end(), [](const ColumnChoice& choice) {
      const std::string field =
          choice.by == ChosenBy::Nobody ? fieldOfColumn(choice.column, false) : choice.field;
      return field == "number" || field == "uuid";
    });
    return found == columns.end() ? std::string() : found->column;
  }
  Message missing() const {
    // Else a sherd's weight would become its bag's.
    for (const ColumnChoice& choice : mapping_.columns) {
      if (choice.by != ChosenBy::Nobody) continue;
      std::string field = fieldOfColumn(choice.column, false);
      if (field.empty()) field = fieldOfColumn(nameAndUnit(choice.column).name, false);
      if (holds(kOnlyOfSherds, field))
        return message(
            "No column has the sherds' numbers, but '%1' is a column of sherds; select the column "
            "of numbers, or leave '%1' out if this is a table of contexts.",
            choice.column);
    }
    if (isTaken("context")) return {};
    return message(
        "The table needs a column for the sherds' numbers, or one for the contexts (a table of "
        "contexts); select it.");
  }
  bool isTaken(const std::string& field) const {
    const auto& columns = mapping_.columns;
    return std::any_of(columns.begin(), columns.end(),
                       [&](const ColumnChoice& choice) { return choice.field == field; });
  }
  void byExactName(ColumnChoice& choice) {
    const bool known = holds(fieldsOfTables(mapping_.of_contexts), choice.column) ||
                       choice.column == kByHand ||
                       (choice.column.starts_with("extra.") && choice.column.size() > 6);
    if (holds(kBeside, choice.column) && !mapping_.of_contexts) {
      choice.by = ChosenBy::Name;
      return;
    }
    if (!known || isTaken(choice.column)) return;
    choice.field = choice.column;
    choice.by = ChosenBy::Name;
    if (!unitsOf(choice.field).empty()) choice.unit = unitsOf(choice.field).front();
  }
  void byName(ColumnChoice& choice) {
    const auto [field, unit] = fieldAndUnit(choice.column, mapping_.of_contexts);
    if (holds(kBeside, field)) {
      choice.by = ChosenBy::Name;
      return;
    }
    if (field.empty() || isTaken(field)) {
      choice.field = "extra." + choice.column;
      return;
    }
    choice.field = field;
    choice.unit = unit;
    choice.by = ChosenBy::Name;
  }
  Result<void> settle(ColumnChoice& choice, std::size_t at) {
    if (choice.field.empty()) return {};
    const bool known = choice.isOwn() || choice.field == kByHand ||
                       holds(fieldsOfTables(mapping_.of_contexts), choice.field);
    if (!known) return Error::unusable(message("There is no field '%1'.", choice.field), where_);
    for (std::size_t i = 0; i < at; ++i)
      if (mapping_.columns[i].field == choice.field)
        return Error::unusable(
            message("The columns '%1' and '%2' are both mapped to the field %3; leave one of "
                    "them out.",
                    mapping_.columns[i].column, choice.column, choice.field),
            where_);
    if (choice.unit.empty())
      if (const std::string said = nameAndUnit(choice.column).unit;
          !said.empty() && holds(unitsOf(choice.field), said))
        choice.unit = said;
    if (choice.unit.empty()) proposeUnit(table_, at, choice);
    if (!choice.unit.empty() && !holds(unitsOf(choice.field), choice.unit))
      return noUnit(choice.unit, choice.field, where_);
    return {};
  }

  const CsvTable& table_;
  const std::string& where_;
  TableMapping mapping_;
};

std::string textIn(const json& choice, const char* name) {
  const auto found = choice.find(name);
  return found != choice.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<ColumnChoice> remembered(const catalogue::Catalogue& catalogue, const CsvTable& table) {
  const Result<std::string> text = catalogue::Settings(catalogue).value(settingOf(table.columns));
  std::vector<ColumnChoice> choices;
  const json saved = text ? jsonOrDiscarded(*text) : json();
  if (!saved.is_object()) return choices;
  for (const auto& [column, choice] : saved.items())
    if (choice.is_array() && choice.size() == 2 && choice[0].is_string() && choice[1].is_string())
      choices.push_back({column, choice[0]});  // its unit may have been a guess
    else if (choice.is_object())
      choices.push_back({column, textIn(choice, "field"), textIn(choice, "unit")});
  return choices;
}

// Of text like 1,2 ± 0,1: both parts.
std::optional<std::string> shifted(const std::string& text, int tens) {
  const Result<double> number = store::parsedNumber(text);
  if (!number) return std::nullopt;
  // The shortest decimal with another exponent: no rounding comes in.
  std::array<char, 48> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number,
                                 std::chars_format::scientific)
                       .ptr;
  const std::string written(digits.data(), end);
  const std::size_t e = written.find('e');
  const int exponent = std::atoi(written.c_str() + e + 1) + tens;
  const std::string other = written.substr(0, e) + "e" + std::to_string(exponent);
  double value = 0;
  std::from_chars(other.data(), other.data() + other.size(), value);
  return store::numberText(value);
}

}  // namespace

// A uuid tells which sherd is meant, and a state is compared.
bool ColumnChoice::isOnlyShown() const {
  const records::SherdField* known = sherds::sherdField(field);
  return known && !known->editable && field != "uuid" && field != "state";
}

std::vector<std::string> fieldsOfTables(bool of_contexts) {
  if (of_contexts)
    return {"site",         "trench",        "context",  "kind",    "excavated_on",
            "period",       "date_edtf",     "closed",   "note",    "bag",
            "collected_on", "count_written", "weight_g", "storage", "uuid"};
  std::vector<std::string> fields;
  for (const records::SherdField& field : sherds::sherdFields()) fields.emplace_back(field.name);
  return fields;
}

std::string inOwnUnit(const std::string& value, const std::string& unit, const std::string& field) {
  const NameAndUnit written = valueAndUnit(value);
  const std::vector<std::string> known = unitsOf(field);
  if (!written.unit.empty() && !holds(known, written.unit)) return value;
  const int tens = tensBetween(written.unit.empty() ? unit : written.unit, field);
  if (tens == 0) return written.name;
  const auto [text, after] = store::splitPlusMinus(written.name);
  if (after) {
    const auto number = shifted(text, tens), half = shifted(*after, tens);
    return number && half ? *number + " \u00b1 " + *half : value;
  }
  return shifted(text, tens).value_or(value);
}

Result<TableMapping> mapColumns(const catalogue::Catalogue& catalogue, const CsvTable& table,
                                const std::vector<ColumnChoice>& chosen, const std::string& where) {
  Mapper mapper(table, where);
  if (Result<void> taken = mapper.take(chosen, ChosenBy::Person); !taken) return taken.error();
  if (Result<void> taken = mapper.take(remembered(catalogue, table), ChosenBy::Earlier); !taken)
    return taken.error();
  return mapper.finish();
}

CsvTable mapped(const CsvTable& table, const TableMapping& mapping, const NumberRemarks& unclear) {
  CsvTable out;
  out.separator = table.separator;
  for (const ColumnChoice& choice : mapping.columns)
    if (!choice.field.empty()) out.columns.push_back(choice.field);
  for (const CsvRow& row : table.rows) {
    CsvRow values{row.line, {}};
    const auto remarks = unclear.find(row.line);
    for (std::size_t i = 0; i < mapping.columns.size(); ++i) {
      const ColumnChoice& choice = mapping.columns[i];
      if (choice.field.empty()) continue;
      const std::string value = cellOf(row, i);
      // A number that is read in two ways is refused as it was written.
      const bool clear = remarks == unclear.end() || !remarks->second.contains(choice.field);
      values.values.push_back(unitsOf(choice.field).empty() || !clear
                                  ? value
                                  : inOwnUnit(value, choice.unit, choice.field));
    }
    out.rows.push_back(std::move(values));
  }
  return out;
}

Result<void> rememberColumns(catalogue::Catalogue& catalogue, const TableMapping& mapping,
                             const records::Provenance& provenance) {
  std::vector<std::string> columns;
  json choices = json::object();
  for (const ColumnChoice& choice : mapping.columns) {
    columns.push_back(choice.column);
    const bool certain = !choice.unit_guessed && !choice.unit_idle;
    choices[choice.column] = {{"field", choice.field}, {"unit", certain ? choice.unit : ""}};
  }
  return catalogue::Settings(catalogue).setValue(settingOf(columns), choices.dump(), provenance);
}

Result<ColumnChoice> parseColumnChoice(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos || equals == 0)
    return Error::unusable(
        message("'%1' maps no column; write COLUMN=FIELD or COLUMN=FIELD:unit.", text));
  ColumnChoice choice{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
  if (const std::size_t colon = choice.field.find(':'); colon != std::string::npos) {
    choice.unit = unitNamed(choice.field.substr(colon + 1));
    if (choice.unit.empty())
      return noUnit(choice.field.substr(colon + 1), choice.field.substr(0, colon), {});
    choice.field.resize(colon);
  }
  if (choice.field == "-") choice.field.clear();
  if (choice.field.empty() || choice.isOwn()) return choice;
  for (const bool contexts : {false, true})
    for (const std::string& field : fieldsOfTables(contexts))
      if (choice.field == field) return choice;
  for (const bool contexts : {false, true})
    if (const std::string field = fieldOfColumn(choice.field, contexts); !field.empty()) {
      choice.field = field;
      return choice;
    }
  return Error::unusable(message("There is no field '%1'.", choice.field));
}

}  // namespace ostraka::tables
