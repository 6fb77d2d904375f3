#include "store/schema_check.h"

#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/message.h"
#include "store/file_header.h"
#include "store/migrations.h"
#include "store/page_checksums.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

struct Closing {
  void operator()(sqlite3* handle) const { sqlite3_close(handle); }
};
using Connection = std::unique_ptr<sqlite3, Closing>;

// What the schema calls it, and its SQL in the form of plainSql; empty for SQLite's own indexes.
using Part = std::pair<std::string, std::string>;  // "trigger history_stays", its table
using Schema = std::map<Part, std::string>;
struct OurSchema {
  Schema parts;
  std::set<std::string> shadows;  ///< tables of the full text, worded by the SQLite that made them
};

// Without comments and with single blanks, but for what stands in quotes: a comment that is worded
// anew in an old migration makes no other table of it.
std::string plainSql(std::string_view sql) {
  std::string out;
  for (std::size_t i = 0; i < sql.size();) {
    const std::string_view rest = sql.substr(i);
    const char c = sql[i];
    std::size_t end = i + 1;
    if (c == '\'' || c == '"' || c == '`' || c == '[') {
      end = sql.find(c == '[' ? ']' : c, i + 1);
      end = end == std::string_view::npos ? sql.size() : end + 1;
      out += sql.substr(i, end - i);
    } else if (rest.starts_with("--") || rest.starts_with("/*") || c == ' ' || c == '\n' ||
               c == '\r' || c == '\t') {
      if (rest.starts_with("--")) end = sql.find('\n', i);
      if (rest.starts_with("/*")) end = sql.find("*/", i + 2);
      if (end == std::string_view::npos)
        end = sql.size();
      else if (rest.starts_with("/*"))
        end += 2;
      if (!out.ends_with(' ')) out += ' ';
    } else {
      out += c;
    }
    i = end;
  }
  return out;
}

std::string columnText(sqlite3_stmt* row, int column) {
  const unsigned char* text = sqlite3_column_text(row, column);
  if (!text) return {};
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(row, column))};
}

template <class Use>
int eachRow(sqlite3* database, const char* sql, Use use) {
  sqlite3_stmt* rows = nullptr;
  int code = sqlite3_prepare_v2(database, sql, -1, &rows, nullptr);
  if (code == SQLITE_OK)
    while ((code = sqlite3_step(rows)) == SQLITE_ROW) use(rows);
  sqlite3_finalize(rows);
  return code == SQLITE_DONE ? SQLITE_OK : code;
}

constexpr const char* kSchema = "SELECT type, name, tbl_name, sql FROM sqlite_schema";

int readSchema(sqlite3* database, Schema& schema) {
  return eachRow(database, kSchema, [&](sqlite3_stmt* row) {
    // Two of one name: none of ours.
    schema[{columnText(row, 0) + " " + columnText(row, 1), columnText(row, 2)}] +=
        plainSql(columnText(row, 3)) + ";";
  });
}

// Columns and a primary key: no expression, of which each has its parentheses, and no module.
bool isPlainTable(std::string_view sql) {
  std::ptrdiff_t open = std::count(sql.begin(), sql.end(), '(');
  for (const std::string_view key : {"PRIMARY KEY(", "PRIMARY KEY ("})
    for (std::size_t at = sql.find(key); at != std::string_view::npos; at = sql.find(key, at + 1))
      --open;
  return sql.starts_with("CREATE TABLE ") && open == 1;
}

// As the migrations make it in an empty catalogue.
Result<OurSchema> ourSchema(int version) {
  sqlite3* opened = nullptr;
  int code =
      sqlite3_open_v2(":memory:", &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  const Connection database(opened);
  for (const Migration& step : migrations())
    if (code == SQLITE_OK && step.number <= version)
      code = sqlite3_exec(opened, std::string(step.sql).c_str(), nullptr, nullptr, nullptr);
  OurSchema ours;
  if (code == SQLITE_OK) code = readSchema(opened, ours.parts);
  if (code == SQLITE_OK)
    code = eachRow(opened, "SELECT name FROM pragma_table_list WHERE type = 'shadow'",
                   [&](sqlite3_stmt* row) { ours.shadows.insert(columnText(row, 0)); });
  if (code == SQLITE_OK) return ours;
  return Error{ErrorCode::Failed,
               message("The catalogue rejects this operation (%1).", sqlite3_errmsg(opened)),
               {}};
}

Error notOurs(const std::string& part) {
  return Error::unusable(message("The catalogue's tables, indexes or triggers differ from those "
                                 "that Ostraka creates; nothing was written."),
                         part);
}

struct Found {
  int version = 0;
  Schema schema;
};

// The schema alone is read, and nothing of what it says is run. It stays trusted: SQLite 3.40 holds
// the json_valid() of our own checks for unsafe.
Result<Found> foreignSchema(const fs::path& file) {
  if (const Result<void> good = checkHeader(file); !good) return good.error();
  sqlite3* opened = nullptr;
  int code = sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE,
                             checkedPagesVfs());
  const Connection database(opened);
  for (const auto& [setting, on] :
       {std::pair(SQLITE_DBCONFIG_DEFENSIVE, 1), std::pair(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0),
        std::pair(SQLITE_DBCONFIG_ENABLE_VIEW, 0)})
    if (code == SQLITE_OK) code = sqlite3_db_config(opened, setting, on, nullptr);
  Found found;
  if (code == SQLITE_OK)
    code = eachRow(opened, "PRAGMA user_version",
                   [&](sqlite3_stmt* row) { found.version = sqlite3_column_int(row, 0); });
  if (code == SQLITE_OK) code = readSchema(opened, found.schema);
  if (code == SQLITE_OK) return found;
  if (code == SQLITE_IOERR_DATA) return damagedCatalogue(message("a page was changed"), file);
  // SQLite calls a schema corrupt whose SQL it cannot read.
  if ((code & 0xFF) == SQLITE_CORRUPT || (code & 0xFF) == SQLITE_ERROR)
    return notOurs(file.string());
  return damagedCatalogue(message("its pages are inconsistent"), file);
}

Result<void> compared(const Found& found, const fs::path& file) {
  if (found.version > migrations().back().number) return {};
  if (found.version < 1) return notOurs(file.string());
  static const Result<OurSchema> kNewest = ourSchema(migrations().back().number);
  const Result<OurSchema> ours =
      found.version == migrations().back().number ? kNewest : ourSchema(found.version);
  if (!ours) return ours.error();
  for (const auto& [part, sql] : found.schema) {
    const auto same = ours->parts.find(part);
    if (same == ours->parts.end()) return notOurs(part.first);
    if (ours->shadows.contains(part.second) ? !isPlainTable(sql) : same->second != sql)
      return notOurs(part.first);
  }
  for (const auto& [part, sql] : ours->parts)
    if (!found.schema.contains(part)) return notOurs(part.first);
  return {};
}

}  // namespace

Result<void> checkSchema(const fs::path& file) {
  const Result<Found> found = foreignSchema(file);
  return found ? compared(*found, file) : found.error();
}

Result<void> checkSchema(Database& database) {
  const Result<Found> found = database.asResult([&] {
    Found there;
    Statement version = database.sql("PRAGMA user_version");
    version.read(there.version);
    Statement parts = database.sql(kSchema);
    for (std::string type, name, table, sql; parts.read(type, name, table, sql);) {
      there.schema[{type + " " + name, table}] += plainSql(sql) + ";";
    }
    return there;
  });
  return found ? compared(*found, database.file()) : found.error();
}

}  // namespace ostraka::store
