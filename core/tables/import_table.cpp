#include "tables/import_table.h"

#include <algorithm>
#include <set>

#include "base/message.h"
#include "store/values.h"
#include "tables/column_names.h"
#include "tables/column_numbers.h"
#include "tables/csv.h"

namespace ostraka::tables {
namespace {

using catalogue::Catalogue;
using records::Provenance;

Result<void> checkColumns(const CsvTable& table, const std::string& where) {
  std::set<std::string> seen;
  for (const std::string& column : table.columns) {
    if (column.empty())
      return Error::unusable(message("A column of the table has no name."), where);
    if (!seen.insert(column).second)
      return Error::unusable(message("The column '%1' appears twice.", column), where);
  }
  return {};
}

std::map<std::string, Message> ofLine(const NumberRemarks& remarks, int line) {
  const auto found = remarks.find(line);
  return found == remarks.end() ? std::map<std::string, Message>() : found->second;
}

std::vector<ImportRow> sherdRowsOf(const CsvTable& table, const NumberRemarks& unclear) {
  const NumberRemarks doubtful = doubtfulNumbers(table, unclear);
  std::vector<ImportRow> rows;
  for (const CsvRow& read : table.rows) {
    ImportRow row{read.line, {}, {}};
    row.unclear = ofLine(unclear, read.line);
    row.doubtful = ofLine(doubtful, read.line);
    for (std::size_t i = 0; i < read.values.size(); ++i) {
      if (table.columns[i] != "measured_by_hand") {
        // Blank is as if absent; wide tables are mostly blank.
        if (!read.values[i].empty()) row.values[table.columns[i]] = read.values[i];
        continue;
      }
      const std::vector<std::string> columns = store::splitTerms(read.values[i]);
      row.by_hand.emplace(columns.begin(), columns.end());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Takes out the rows that do not fit the header.
std::vector<Refusal> takeBroken(CsvTable& table) {
  std::vector<Refusal> broken;
  std::erase_if(table.rows, [&](const CsvRow& row) {
    if (row.values.size() == table.columns.size()) return false;
    broken.push_back({row.line,
                      {},
                      {},
                      message("Values in the row: %1, columns in the header: %2; correct the row.",
                              row.values.size(), table.columns.size())});
    return true;
  });
  return broken;
}

void addBroken(ImportReport& report, const std::vector<Refusal>& broken) {
  report.refused += static_cast<int>(broken.size());
  for (const Refusal& refusal : broken) report.rows.emplace_back(refusal.line, RowFate::Refused);
  std::sort(report.rows.begin(), report.rows.end());
  report.refusals.insert(report.refusals.end(), broken.begin(), broken.end());
  std::stable_sort(report.refusals.begin(), report.refusals.end(),
                   [](const Refusal& a, const Refusal& b) { return a.line < b.line; });
}

// A refusal names the column as the table does.
void nameColumns(std::vector<Refusal>& refusals, const TableMapping& mapping) {
  std::map<std::string, std::string> columns;
  for (const ColumnChoice& choice : mapping.columns)
    if (!choice.field.empty()) columns.emplace(choice.field, choice.column);
  for (Refusal& refusal : refusals)
    if (const auto column = columns.find(refusal.column); column != columns.end())
      refusal.column = column->second;
}

// A column that has no field: its name says nothing, or another one has its field.
Message ownField(const ColumnChoice& choice, const TableMapping& mapping) {
  std::string field = fieldOfColumn(choice.column, mapping.of_contexts);
  if (field.empty()) field = fieldOfColumn(nameAndUnit(choice.column).name, mapping.of_contexts);
  for (const ColumnChoice& other : mapping.columns)
    if (!field.empty() && other.field == field && other.column != choice.column)
      return message(
          "The column '%1' means the same as '%2'; its values are kept as a custom field.",
          choice.column, other.column);
  return message("The column '%1' is unknown; its values are kept as a custom field.",
                 choice.column);
}

}  // namespace

Result<ImportReport> importTable(Catalogue& catalogue, std::string_view bytes,
                                 const std::string& where, const ImportOptions& options,
                                 const Provenance& provenance, Progress& progress,
                                 std::stop_token stop) {
  Result<CsvTable> table = parseCsv(bytes, where);
  if (!table) return table.error();
  if (Result<void> good = checkColumns(*table, where); !good) return good.error();
  const Result<TableMapping> mapping = mapColumns(catalogue, *table, options.columns, where);
  if (!mapping) return mapping.error();
  ImportOptions named = options;
  if (named.source.empty()) named.source = where;
  const std::vector<Refusal> broken = takeBroken(*table);
  const bool guessed = std::any_of(mapping->columns.begin(), mapping->columns.end(),
                                   [](const ColumnChoice& choice) { return choice.unit_guessed; });
  const bool held = guessed && options.guessed_units == GuessedUnits::Hold;
  if (held) named.mode = ImportMode::Preview;
  const NumberRemarks unclear = unclearNumbers(*table, *mapping);
  const CsvTable own = mapped(*table, *mapping, unclear);
  Result<ImportReport> report =
      mapping->of_contexts
          ? importContexts(catalogue, own, unclear, named, provenance, progress, stop)
          : importSherds(catalogue, sherdRowsOf(own, unclear), named, provenance, progress, stop);
  if (!report) return report;
  addBroken(*report, broken);
  nameColumns(report->refusals, *mapping);
  nameColumns(report->questions, *mapping);
  for (const ColumnChoice& choice : mapping->columns)
    if (choice.by == ChosenBy::Nobody) report->warnings.push_back(ownField(choice, *mapping));
  report->held = held;
  if (named.mode == ImportMode::Enter)
    if (Result<void> saved = rememberColumns(catalogue, *mapping); !saved) return saved.error();
  report->mapping = *mapping;
  return report;
}

std::string refusalsCsv(const ImportReport& report) {
  std::string text = csvLine({"line", "column", "value", "reason"});
  for (const auto* list : {&report.refusals, &report.questions})
    for (const Refusal& refusal : *list)
      text += csvLine({std::to_string(refusal.line), guarded(refusal.column),
                       guarded(refusal.value), refusal.reason.english()});
  return text;
}

}  // namespace ostraka::tables
