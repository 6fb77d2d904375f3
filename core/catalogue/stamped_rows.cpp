#include "catalogue/stamped_rows.h"

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/history.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

Message gone(std::string_view table) {
  if (table == "batch") return message("This batch is no longer in the catalogue.");
  if (table == "photograph") return message("This photograph is no longer in the catalogue.");
  if (table == "scan") return message("This scan is no longer in the catalogue.");
  if (table == "file") return message("This file is no longer in the catalogue.");
  if (table == "person") return message("This person is no longer in the catalogue.");
  if (table == "site") return message("This site is no longer in the catalogue.");
  if (table == "trench") return message("This trench is no longer in the catalogue.");
  if (table == "context") return message("This context is no longer in the catalogue.");
  if (table == "bag") return message("This bag is no longer in the catalogue.");
  return message("A sherd is no longer in the catalogue.");
}

void bindTo(store::Statement& statement, const Column& column) {
  std::visit([&](const auto& value) { statement.with(value); }, column.value.stored);
}

}  // namespace

std::string nextRow(const std::string& table) {
  return "1 + max(ifnull((SELECT max(row) FROM " + table +
         "), 0), ifnull((SELECT max(row) FROM history WHERE table_name = '" + table + "'), 0))";
}

std::string ColumnValue::told() const {
  if (const auto* text = std::get_if<std::string>(&stored)) return *text;
  if (const auto* number = std::get_if<double>(&stored)) return store::numberText(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&stored)) return std::to_string(*whole);
  return {};
}

bool rememberDifferences(const Catalogue& catalogue, const records::Provenance& provenance,
                         const char* table, std::int64_t row, const std::vector<Column>& columns) {
  std::string names;
  for (const Column& column : columns)
    names += std::string(names.empty() ? "" : ", ") + column.name;
  // Numbers are read with all their digits, so that only a real difference counts.
  std::vector<std::string> old_values(columns.size());
  {
    store::Statement rows =
        catalogue.database().sql("SELECT " + names + " FROM " + table + " WHERE row = ?", row);
    if (!rows.next()) store::refuse(gone(table));
    for (std::string& value : old_values) rows.readText(value);
  }
  bool any = false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string now = columns[i].value.told();
    if (columns[i].changes != Column::Changes::Told || old_values[i] == now) continue;
    remember(catalogue, provenance, table, row, columns[i].name, old_values[i], now);
    any = true;
  }
  return any;
}

void changeRow(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
               std::int64_t row, const std::vector<Column>& columns) {
  std::string names;
  for (const Column& column : columns)
    if (column.changes != Column::Changes::Never) names += std::string(column.name) + " = ?, ";
  store::Statement update = catalogue.database().sql(
      std::string("UPDATE ") + table + " SET " + names +
      "updated_at = ?, updated_by = ?, revision = revision + 1 WHERE row = ?");
  for (const Column& column : columns)
    if (column.changes != Column::Changes::Never) bindTo(update, column);
  update.with(catalogue.now(), provenance.person, row).run();
}

std::int64_t saveRow(const Catalogue& catalogue, const records::Provenance& provenance,
                     const char* table, std::int64_t row, const std::string& id,
                     const std::vector<Column>& columns) {
  if (row != 0) {
    if (rememberDifferences(catalogue, provenance, table, row, columns))
      changeRow(catalogue, provenance, table, row, columns);
    return row;
  }
  std::string names, marks;
  for (const Column& column : columns) {
    names += std::string(column.name) + ", ";
    marks += "?, ";
  }
  store::Statement insert =
      catalogue.database().sql(std::string("INSERT INTO ") + table + " (" + names +
                               "id, created_at, created_by, updated_at, updated_by, row) VALUES (" +
                               marks + "?, ?, ?, ?, ?, " + nextRow(table) + ")");
  for (const Column& column : columns) bindTo(insert, column);
  const std::int64_t now = catalogue.now();
  insert.with(id.empty() ? newId(now) : id, now, provenance.person, now, provenance.person).run();
  return catalogue.database().lastRow();
}

}  // namespace ostraka::catalogue
