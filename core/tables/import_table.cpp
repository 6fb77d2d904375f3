#include "tables/import_table.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
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
std::vector<CsvRow> takeBroken(CsvTable& table) {
  const auto first = std::stable_partition(
      table.rows.begin(), table.rows.end(),
      [&](const CsvRow& row) { return row.values.size() == table.columns.size(); });
  std::vector<CsvRow> broken(std::make_move_iterator(first),
                             std::make_move_iterator(table.rows.end()));
  table.rows.erase(first, table.rows.end());
  return broken;
}

void addBroken(ImportReport& report, const std::vector<CsvRow>& broken, std::size_t columns) {
  for (const CsvRow& row : broken) {
    report.add(row.line, RowFate::Refused);
    report.refusals.push_back(
        {row.line,
         {},
         {},
         message("Values in the row: %1, columns in the header: %2; correct the row.",
                 row.values.size(), columns)});
  }
  std::sort(report.rows.begin(), report.rows.end());
  std::ranges::stable_sort(report.refusals, {}, &Refusal::line);
}

// The refused and the asked rows of the table, as it has them.
CsvTable leftOut(const CsvTable& table, std::vector<CsvRow> broken, const ImportReport& report) {
  std::set<int> lines;
  for (const auto* list : {&report.refusals, &report.questions})
    for (const Refusal& refusal : *list) lines.insert(refusal.line);
  CsvTable rows{table.columns, std::move(broken), table.separator};
  std::copy_if(table.rows.begin(), table.rows.end(), std::back_inserter(rows.rows),
               [&](const CsvRow& row) { return lines.contains(row.line); });
  std::ranges::sort(rows.rows, {}, &CsvRow::line);
  return rows;
}

// A refusal names the column as the table does, with the value in the column's unit.
void nameColumns(std::vector<Refusal>& refusals, const TableMapping& mapping,
                 const CsvTable& table) {
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < mapping.columns.size(); ++i)
    if (!mapping.columns[i].field.empty()) columns.emplace(mapping.columns[i].field, i);
  std::map<int, const CsvRow*> rows;
  for (const CsvRow& row : table.rows) rows[row.line] = &row;
  for (Refusal& refusal : refusals) {
    const auto column = columns.find(refusal.column);
    if (column == columns.end()) continue;
    refusal.column = mapping.columns[column->second].column;
    if (const auto row = rows.find(refusal.line); row != rows.end())
      refusal.value = unguarded(row->second->values[column->second]);
  }
}

// A column that has no field: its name says nothing, or another one has its field.
Message customField(const ColumnChoice& choice, const TableMapping& mapping) {
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
  if (!mapping->missing.empty()) {
    ImportReport nothing;
    nothing.mapping = *mapping;
    return nothing;
  }
  Provenance from_file = provenance;
  if (from_file.why.empty()) from_file.why = std::filesystem::path(where).filename().string();
  ImportOptions named = options;
  if (named.source.empty()) named.source = where;
  std::vector<CsvRow> broken = takeBroken(*table);
  const bool guessed = std::ranges::any_of(
      mapping->columns, [](const ColumnChoice& choice) { return choice.unit_guessed; });
  const bool held = guessed && options.guessed_units == GuessedUnits::Hold;
  if (held) named.mode = ImportMode::Preview;
  const NumberRemarks unclear = unclearNumbers(*table, *mapping);
  const CsvTable own = mapped(*table, *mapping, unclear);
  Result<ImportReport> report =
      mapping->of_contexts
          ? importContexts(catalogue, own, unclear, named, from_file, progress, stop)
          : importSherds(catalogue, sherdRowsOf(own, unclear), named, from_file, progress, stop);
  if (!report) return report;
  addBroken(*report, broken, table->columns.size());
  report->left_out = leftOut(*table, std::move(broken), *report);
  for (std::vector<Refusal>* list : {&report->refusals, &report->questions})
    nameColumns(*list, *mapping, *table);
  for (const ColumnChoice& choice : mapping->columns)
    if (choice.by == ChosenBy::Nobody) report->warnings.push_back(customField(choice, *mapping));
  report->held = held;
  if (named.mode == ImportMode::Enter)
    if (Result<void> saved = rememberColumns(catalogue, *mapping, provenance); !saved)
      return saved.error();
  report->mapping = *mapping;
  return report;
}

}  // namespace ostraka::tables
