#include "upkeep/value_check.h"

#include <string>
#include <vector>

#include "base/text.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::upkeep {
namespace {

struct CheckedColumns {
  std::string table;
  bool has_rows = true;  ///< else its rows have no numbers
  std::vector<std::string> texts, numbers;
};

std::vector<CheckedColumns> checkedColumns(store::Database& database) {
  std::vector<CheckedColumns> all;
  store::Statement tables = database.sql(
      "SELECT name, wr = 0 FROM pragma_table_list WHERE schema = 'main' AND type = 'table' AND "
      "name NOT LIKE 'sqlite_%' ORDER BY name");
  std::string table_name;
  for (bool has_rows = false; tables.read(table_name, has_rows);) {
    if (store::holdsSystemNames(table_name)) continue;
    CheckedColumns table{table_name, has_rows, {}, {}};
    store::Statement columns =
        database.sql("SELECT name, type FROM pragma_table_info(?)", table.table);
    for (std::string name, type; columns.read(name, type);) {
      if (type == "TEXT") table.texts.push_back(name);
      if (type == "REAL") table.numbers.push_back(name);
    }
    all.push_back(std::move(table));
  }
  return all;
}

void checkTable(store::Database& database, const CheckedColumns& table) {
  std::string sql = table.has_rows ? "SELECT rowid" : "SELECT 0";
  for (const auto* columns : {&table.texts, &table.numbers})
    for (const std::string& column : *columns) sql += ", \"" + column + "\"";
  store::Statement rows = database.sql(sql + " FROM \"" + table.table + "\"");
  for (std::int64_t row = 0; rows.read(row);) {
    const auto where = [&](const std::string& column) {
      return table.table + "." + column + (row == 0 ? "" : ", row " + std::to_string(row));
    };
    for (const std::string& column : table.texts) {
      std::string text;
      rows >> text;
      if (const Result<void> good = checkText(text); !good)
        store::refuse(good.error().what, where(column));
    }
    for (const std::string& column : table.numbers) {
      std::optional<double> number;
      rows >> number;
      if (const Result<void> good = store::checkFinite(number.value_or(0)); !good)
        store::refuse(good.error().what, where(column));
    }
  }
}

}  // namespace

Result<void> checkValues(const catalogue::Catalogue& catalogue) {
  return catalogue.database().asResult([&] {
    for (const CheckedColumns& table : checkedColumns(catalogue.database()))
      checkTable(catalogue.database(), table);
  });
}

}  // namespace ostraka::upkeep
