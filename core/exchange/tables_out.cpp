// The tables of an export.
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/message.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "exchange/export_folder.h"
#include "files/json_text.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "store/values.h"
#include "tables/column_meanings.h"
#include "tables/csv.h"
#include "tables/ods.h"

namespace ostraka::exchange {
namespace {

using namespace catalogue;

constexpr const char* kMark = "\xEF\xBB\xBF";
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

using HandColumns = std::map<store::SherdRow, std::set<std::string>>;
Result<HandColumns> measuredByHand(const Catalogue& catalogue,
                                   std::span<const store::SherdRow> rows) {
  const Result<std::vector<records::Measurement>> measured =
      sherds::Measurements(catalogue).byHand(rows);
  if (!measured) return measured.error();
  HandColumns columns;
  for (const records::Measurement& m : *measured) columns[m.sherd].insert(columnOf(m.kind));
  return columns;
}

Result<std::string> shownValue(const records::SherdRecord& sherd,
                               const records::SherdField& field) {
  std::string text = sherds::textOf(sherd, field.name);
  if (!isNumber(field) || text.empty()) return text;
  const Result<double> number = store::parsedNumber(text);
  if (!number) return number.error();
  return tables::tableNumber(*number);
}

// Says which value of which sherd or context it is that no table can hold.
Error refusedCell(const Error& error, const std::string& of, const std::string& column) {
  return {error.code, error.what, of + ", " + column};
}

// Sherds are read a page at a time, so that 100,000 need no more memory than the text itself.
template <class Use>
Result<void> eachSherd(const Catalogue& catalogue, std::span<const store::SherdRow> rows, Use use) {
  for (std::size_t i = 0; i < rows.size(); i += kPage) {
    const std::span<const store::SherdRow> some = rows.subspan(i, std::min(kPage, rows.size() - i));
    const Result<std::vector<records::SherdRecord>> page = sherds::Sherds(catalogue).of(some);
    if (!page) return page.error();
    Result<HandColumns> by_hand = measuredByHand(catalogue, some);
    if (!by_hand) return by_hand.error();
    for (const records::SherdRecord& sherd : *page)
      if (Result<void> used = use(sherd, (*by_hand)[sherd.row]); !used) return used;
  }
  return {};
}

// Takes a table row by row.
class TableWriter {
 public:
  virtual ~TableWriter() = default;
  virtual void begin(const std::vector<tables::OdsSheet::Column>& columns) = 0;
  virtual void row(const std::vector<std::string>& values) = 0;
};

// A row as it may stand in a table of any form; `of`: whose it is.
Result<void> writeRow(TableWriter& table, const std::vector<tables::OdsSheet::Column>& columns,
                      const std::vector<std::string>& values, const std::string& of) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!store::isUtf8(values[i]))
      return refusedCell(
          Error::unusable(message("The text is not valid UTF-8 or contains a zero byte.")), of,
          columns[i].name);
  table.row(values);
  return {};
}

void writeMeanings(TableWriter& table) {
  table.begin({{"column"}, {"unit"}, {"meaning"}});
  for (const tables::ColumnMeaning& one : tables::columnMeanings())
    table.row({one.column, one.unit, one.meaning});
}

Result<void> writeSherds(const Catalogue& catalogue, std::span<const store::SherdRow> rows,
                         const FilesOfSherds& files, TableWriter& table) {
  const Result<records::ProjectRecord> project = Settings(catalogue).project();
  if (!project) return project.error();
  std::set<std::string> own;  // fields of the user's own, of any of the sherds
  Result<void> read = eachSherd(
      catalogue, rows,
      [&](const records::SherdRecord& sherd, const std::set<std::string>&) -> Result<void> {
        if (sherd.extra_json == "{}") return {};
        const nlohmann::json extra = jsonOrDiscarded(sherd.extra_json);
        if (extra.is_object())
          for (const auto& [key, value] : extra.items()) own.insert(key);
        return {};
      });
  if (!read) return read;
  std::vector<tables::OdsSheet::Column> columns;
  for (const records::SherdField& field : sherds::sherdFields())
    columns.push_back({field.name, isNumber(field)});
  columns.push_back({"measured_by_hand"});
  for (const char* column : kCentreColumns) columns.push_back({column, true});
  for (const char* column : kFileColumns) columns.push_back({column});
  columns.push_back({"licence"});
  for (const std::string& key : own) columns.push_back({"extra." + key});
  table.begin(columns);
  return eachSherd(
      catalogue, rows,
      [&](const records::SherdRecord& sherd, const std::set<std::string>& by_hand) -> Result<void> {
        static const std::map<std::string, std::string> kNoFiles;
        const auto named = files.find(sherd.row);
        const auto& beside = named == files.end() ? kNoFiles : named->second;
        const std::string& name = sherd.number.empty() ? sherd.id : sherd.number;
        std::vector<std::string> values;
        for (const records::SherdField& field : sherds::sherdFields()) {
          const Result<std::string> shown = shownValue(sherd, field);
          if (!shown) return refusedCell(shown.error(), name, field.name);
          values.push_back(*shown);
        }
        values.push_back(store::joinTerms({by_hand.begin(), by_hand.end()}));
        const auto add = [&](const char* column) {
          const auto found = beside.find(column);
          values.push_back(found == beside.end() ? std::string() : found->second);
        };
        for (const char* column : kCentreColumns) add(column);
        for (const char* column : kFileColumns) add(column);
        values.push_back(project->licence);
        for (const std::string& key : own) values.push_back(sherds::textOf(sherd, "extra." + key));
        return writeRow(table, columns, values, name);
      });
}

Result<void> writeContexts(const Catalogue& catalogue, std::span<const store::ContextRow> rows,
                           TableWriter& table) {
  const std::vector<tables::OdsSheet::Column> columns = {
      {"site"},           {"trench"}, {"context"},      {"kind"},
      {"excavated_on"},   {"period"}, {"date_edtf"},    {"closed"},
      {"note"},           {"bag"},    {"collected_on"}, {"count_written", true},
      {"weight_g", true}, {"storage"}};
  table.begin(columns);
  for (const store::ContextRow& row : rows) {
    const Result<records::ContextRecord> c = Places(catalogue).context(row);
    if (!c) return c.error();
    Result<std::vector<records::BagRecord>> bags = Places(catalogue).bags(row);
    if (!bags) return bags.error();
    if (bags->empty()) bags->emplace_back();
    for (const records::BagRecord& bag : *bags) {
      if (bag.weight_g && !std::isfinite(*bag.weight_g))
        return refusedCell(store::parsedNumber(store::numberText(*bag.weight_g)).error(), c->number,
                           "weight_g");
      Result<void> written =
          writeRow(table, columns,
                   {c->site_code, c->trench_code, c->number, c->kind, c->excavated_on, c->period,
                    c->date_edtf, c->closed ? "yes" : "no", c->note, bag.number, bag.collected_on,
                    bag.count_written ? std::to_string(*bag.count_written) : "",
                    bag.weight_g ? store::numberText(*bag.weight_g) : "", bag.storage},
                   c->number);
      if (!written) return written;
    }
  }
  return {};
}

// Numbers stand as they are, texts with the guard against formulas.
class CsvWriter final : public TableWriter {
 public:
  explicit CsvWriter(ByteOrderMark mark) : text(mark == ByteOrderMark::With ? kMark : "") {}
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
  explicit OdsWriter(std::string name) : name_(std::move(name)) {}
  void begin(const std::vector<tables::OdsSheet::Column>& columns) override {
    sheet.emplace(name_, columns);
  }
  void row(const std::vector<std::string>& values) override { sheet->row(values); }
  std::optional<tables::OdsSheet> sheet;

 private:
  std::string name_;
};

}  // namespace

Result<std::string> sherdsCsv(const Catalogue& catalogue, std::span<const store::SherdRow> rows,
                              ByteOrderMark mark, const FilesOfSherds& files) {
  CsvWriter table(mark);
  if (Result<void> done = writeSherds(catalogue, rows, files, table); !done) return done.error();
  return std::move(table.text);
}

Result<std::string> contextsCsv(const Catalogue& catalogue, std::span<const store::ContextRow> rows,
                                ByteOrderMark mark) {
  CsvWriter table(mark);
  if (Result<void> done = writeContexts(catalogue, rows, table); !done) return done.error();
  return std::move(table.text);
}

std::string columnsCsv(ByteOrderMark mark) {
  CsvWriter table(mark);
  writeMeanings(table);
  return std::move(table.text);
}

Result<std::string> tablesOds(const Catalogue& catalogue, std::span<const store::SherdRow> sherds,
                              std::span<const store::ContextRow> contexts,
                              const FilesOfSherds& files) {
  OdsWriter first("sherds"), second("contexts"), third("columns");
  if (Result<void> done = writeSherds(catalogue, sherds, files, first); !done) return done.error();
  if (Result<void> done = writeContexts(catalogue, contexts, second); !done) return done.error();
  writeMeanings(third);
  return tables::formatOds(
      {std::move(*first.sheet), std::move(*second.sheet), std::move(*third.sheet)});
}

}  // namespace ostraka::exchange
