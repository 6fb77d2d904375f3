#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ostraka::store {
class Database;
}  // namespace ostraka::store

/// What a project holds, as a merge compares it: rows are known by their uuids, and so are the rows
/// that they refer to.
namespace ostraka::merge {

/// Settings of rows that are one though each project made its own: this and the one's uuid.
inline constexpr const char* kSameRow = "merge.same.";

using Value = std::optional<std::string>;  ///< as text, independent of its type; none: NULL

struct Row {
  std::int64_t row = 0;
  std::string id;
  std::vector<Value> values;  ///< in the order of the table's columns; references are uuids
};

struct Table {
  std::string name;
  std::vector<std::string> columns;  ///< all but row and id
  std::vector<std::string> refers;   ///< by column: the table that it refers to, or empty
  std::vector<std::string> unique;   ///< columns by which a row is the same under another uuid
  std::vector<Row> rows;             ///< in the order of their numbers
  std::unordered_map<std::string, std::size_t> by_id;
  std::unordered_map<std::int64_t, std::size_t> by_row;

  const Row* find(const std::string& id) const;
  std::size_t column(const std::string& of_name) const;  ///< columns.size() where there is none
};

/// One row of the history. Rows that both projects contain are their common past.
struct Event {
  std::int64_t at = 0;
  std::string person, table, row;  ///< uuids; row: "vocabulary#0" where it has none
  std::string field, old_value, new_value, why, source;
  std::string refers;  ///< the table whose uuids are in old and new; empty: texts
};

struct Content {
  std::string project_id;
  std::vector<Table> tables;  ///< a table comes after those that it refers to
  std::vector<Event> events;
  std::unordered_map<std::string, std::vector<std::string>> bags;  ///< of a batch, in order
  std::vector<std::pair<std::string, std::string>> joins;          ///< of two sherds, both ways
  std::vector<std::vector<Value>> given;        ///< number_key slug_key number sherd at
  std::vector<std::vector<std::string>> terms;  ///< name term labels uri
  std::vector<std::pair<std::string, std::string>> settings;

  const Table& table(const std::string& name) const;
};

/// Everything, within the caller's transaction or snapshot; throws as Statement does.
Content readContent(store::Database& database);

}  // namespace ostraka::merge
