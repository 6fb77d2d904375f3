// The tables of an export.
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "exchange/export_folder.h"
#include "files/json_text.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/values.h"
#include "tables/column_meanings.h"
#include "tables/column_names.h"
#include "tables/csv.h"
#include "tables/ods.h"

namespace ostraka::exchange {
namespace {

using namespace catalogue;
using store::valueOrThrow;

constexpr const char* kCentreColumns[] = {"mass_centre_x_mm", "mass_centre_y_mm",
                                          "mass_centre_z_mm"};
constexpr const char* kFileColumns[] = {"model_file", "image_file", "drawing_file"};
constexpr std::size_t kPage = 1000;

bool isNumber(const records::SherdField& field) {
  return field.kind == records::FieldKind::Number;
}

std::string columnOf(const std::string& kind) {
  const std::string unit = "_" + records::unitOf(kind);
  return kind.ends_with(unit) ? kind : kind + unit;
}

// Says which value of which sherd or context it is that no table can hold.
[[noreturn]] void refuseCell(const Error& error, const std::string& of, const std::string& column) {
  throw store::Refused({error.code, error.what, of + ", " + column});
}

// Sherds are read a page at a time, so that 100,000 need no more memory than the text itself.
// use: takes a sherd, and the columns of what was measured by hand.
template <class Use>
void eachSherd(const Catalogue& catalogue, std::span<const store::SherdRow> rows, Use use) {
  for (std::size_t i = 0; i < rows.size(); i += kPage) {
    const std::span<const store::SherdRow> some = rows.subspan(i, std::min(kPage, rows.size() - i));
    const auto page = valueOrThrow(sherds::Sherds(catalogue).of(some));
    std::map<store::SherdRow, std::set<std::string>> by_hand;
    for (const auto& m : valueOrThrow(sherds::Measurements(catalogue).byHand(some)))
      by_hand[m.sherd].insert(columnOf(m.kind));
    for (const records::SherdRecord& sherd : page) use(sherd, by_hand[sherd.row]);
  }
}

// Takes a table row by row.
class TableWriter {
 public:
  virtual ~TableWriter() = default;
  virtual void begin(const std::vector<tables::OdsSheet::Column>& columns) = 0;
  virtual void row(const std::vector<std::string>& values) = 0;
};

// A row as it may stand in a table of any form; `of`: whose it is.
void writeRow(TableWriter& table, const std::vector<tables::OdsSheet::Column>& columns,
              const std::vector<std::string>& values, const std::string& of) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!isUtf8(values[i]))
      refuseCell(Error::unusable(message("The text is not valid UTF-8 or contains a zero byte.")),
                 of, columns[i].name);
  table.row(values);
}

// words: what the reader calls each column, if known.
void writeMeanings(TableWriter& table, const ColumnWords& words) {
  std::vector<tables::OdsSheet::Column> columns = {{"column"}, {"unit"}, {"meaning"}};
  if (words) columns.push_back({"name"});
  table.begin(columns);
  for (const tables::ColumnMeaning& one : tables::columnMeanings()) {
    std::vector<std::string> row = {one.column, one.unit, one.meaning};
    if (words) row.push_back(words(one.column));
    table.row(row);
  }
}

void addCustomFields(const std::string& extra_json, std::set<std::string>& names) {
  if (extra_json == "{}") return;
  const nlohmann::json extra = jsonOrDiscarded(extra_json);
  if (extra.is_object())
    for (const auto& [key, value] : extra.items()) names.insert(key);
}

void writeSherds(const Catalogue& catalogue, std::span<const store::SherdRow> rows,
                 const FilesOfSherds& files, TableWriter& table) {
  const std::string licence = valueOrThrow(Settings(catalogue).project()).licence;
  std::set<std::string> custom;  // fields of any of the sherds
  eachSherd(catalogue, rows, [&](const records::SherdRecord& sherd, const auto&) {
    addCustomFields(sherd.extra_json, custom);
  });
  std::vector<tables::OdsSheet::Column> columns;
  for (const records::SherdField& field : sherds::sherdFields())
    columns.push_back({field.name, isNumber(field)});
  columns.push_back({"measured_by_hand"});
  for (const char* column : kCentreColumns) columns.push_back({column, true});
  for (const char* column : kFileColumns) columns.push_back({column});
  columns.push_back({"licence"});
  for (const std::string& key : custom) columns.push_back({"extra." + key});
  table.begin(columns);
  eachSherd(catalogue, rows,
            [&](const records::SherdRecord& sherd, const std::set<std::string>& by_hand) {
              static const std::map<std::string, std::string> kNoFiles;
              const auto named = files.find(sherd.row);
              const auto& beside = named == files.end() ? kNoFiles : named->second;
              const std::string& name = sherd.number.empty() ? sherd.id : sherd.number;
              std::vector<std::string> values;
              for (const records::SherdField& field : sherds::sherdFields()) {
                std::string text = sherds::textOf(sherd, field.name);
                if (isNumber(field) && !text.empty()) {
                  const Result<double> number = store::parsedNumber(text);
                  if (!number) refuseCell(number.error(), name, field.name);
                  text = tables::tableNumber(*number);
                }
                values.push_back(std::move(text));
              }
              values.push_back(store::joinTerms({by_hand.begin(), by_hand.end()}));
              const auto add = [&](const char* column) {
                const auto found = beside.find(column);
                values.push_back(found == beside.end() ? std::string() : found->second);
              };
              for (const char* column : kCentreColumns) add(column);
              for (const char* column : kFileColumns) add(column);
              values.push_back(licence);
              for (const std::string& key : custom)
                values.push_back(sherds::customText(sherd.extra_json, key));
              writeRow(table, columns, values, name);
            });
}

void writeContexts(const Catalogue& catalogue, std::span<const store::ContextRow> rows,
                   TableWriter& table) {
  std::vector<records::ContextRecord> contexts;
  std::set<std::string> custom;
  for (const store::ContextRow& row : rows) {
    contexts.push_back(valueOrThrow(Places(catalogue).context(row)));
    addCustomFields(contexts.back().extra_json, custom);
  }
  std::vector<tables::OdsSheet::Column> columns = {
      {"site"},           {"trench"}, {"context"},      {"kind"},
      {"excavated_on"},   {"period"}, {"date_edtf"},    {"closed"},
      {"note"},           {"bag"},    {"collected_on"}, {"count_written", true},
      {"weight_g", true}, {"storage"}};
  for (const std::string& key : custom) columns.push_back({"extra." + key});
  table.begin(columns);
  for (const records::ContextRecord& c : contexts) {
    std::vector<records::BagRecord> bags = valueOrThrow(Places(catalogue).bags(c.row));
    if (bags.empty()) bags.emplace_back();
    for (const records::BagRecord& bag : bags) {
      if (bag.weight_g && !std::isfinite(*bag.weight_g))
        refuseCell(store::parsedNumber(store::numberText(*bag.weight_g)).error(), c.number,
                   "weight_g");
      std::vector<std::string> values = {c.site_code,
                                         c.trench_code,
                                         c.number,
                                         c.kind,
                                         c.excavated_on,
                                         c.period,
                                         c.date_edtf,
                                         c.closedWord(),
                                         c.note,
                                         bag.number,
                                         bag.collected_on,
                                         optionalText(bag.count_written),
                                         optionalText(bag.weight_g),
                                         bag.storage};
      for (const std::string& key : custom) values.push_back(sherds::customText(c.extra_json, key));
      writeRow(table, columns, values, c.number);
    }
  }
}

// Numbers stand as they are, texts with the guard against formulas.
class CsvWriter final : public TableWriter {
 public:
  explicit CsvWriter(ByteOrderMark mark)
      : text(mark == ByteOrderMark::With ? tables::kUtf8Mark : "") {}
  void begin(const std::vector<tables::OdsSheet::Column>& columns) override {
    columns_ = columns;
    std::vector<std::string> names;
    for (const auto& column : columns) names.push_back(tables::guarded(column.name));
    text += tables::csvLine(names);
  }
  void row(const std::vector<std::string>& values) override {
    std::vector<std::string> safe;
    for (std::size_t i = 0; i < values.size(); ++i)
      safe.push_back(columns_[i].number ? values[i] : tables::guarded(values[i]));
    text += tables::csvLine(safe);
  }
  std::string text;

 private:
  std::vector<tables::OdsSheet::Column> columns_;
};

class OdsWriter final : public TableWriter {
 public:
  /// heading: of a column, by its name.
  OdsWriter(std::string name, ColumnWords heading)
      : name_(std::move(name)), heading_(std::move(heading)) {}
  void begin(const std::vector<tables::OdsSheet::Column>& columns) override {
    std::vector<tables::OdsSheet::Column> headed = columns;
    for (tables::OdsSheet::Column& column : headed) column.name = heading_(column.name);
    sheet.emplace(name_, headed);
  }
  void row(const std::vector<std::string>& values) override { sheet->row(values); }
  std::optional<tables::OdsSheet> sheet;

 private:
  std::string name_;
  ColumnWords heading_;
};

}  // namespace

Result<std::string> sherdsCsv(const Catalogue& catalogue, std::span<const store::SherdRow> rows,
                              ByteOrderMark mark, const FilesOfSherds& files) {
  return catalogue.database().asResult([&] {
    CsvWriter table(mark);
    writeSherds(catalogue, rows, files, table);
    return std::move(table.text);
  });
}

Result<std::string> contextsCsv(const Catalogue& catalogue, std::span<const store::ContextRow> rows,
                                ByteOrderMark mark) {
  return catalogue.database().asResult([&] {
    CsvWriter table(mark);
    writeContexts(catalogue, rows, table);
    return std::move(table.text);
  });
}

std::string columnsCsv(ByteOrderMark mark) {
  CsvWriter table(mark);
  writeMeanings(table, {});
  return std::move(table.text);
}

Result<std::string> tablesOds(const Catalogue& catalogue, std::span<const store::SherdRow> sherds,
                              std::span<const store::ContextRow> contexts,
                              const FilesOfSherds& files, const ColumnWords& words) {
  return catalogue.database().asResult([&] {
    // A field of the users' own keeps its mark: its name may be that of another field.
    const auto headings = [&words](bool of_contexts) -> ColumnWords {
      return [&words, of_contexts](const std::string& column) {
        return words && !column.starts_with("extra.")
                   ? tables::headingOf(column, words(column), of_contexts)
                   : column;
      };
    };
    OdsWriter first("sherds", headings(false)), second("contexts", headings(true)),
        third("columns",
              [&words](const std::string&column) { return words ? words(column) : column; });
    writeSherds(catalogue, sherds, files, first);
    writeContexts(catalogue, contexts, second);
    writeMeanings(third, words);
    return valueOrThrow(tables::formatOds(
        {std::move(*first.sheet), std::move(*second.sheet), std::move(*third.sheet)}));
  });
}

}  // namespace ostraka::exchange
