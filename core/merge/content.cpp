#include "merge/content.h"

#include <map>

#include "base/text.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::merge {
namespace {

struct Known {
  const char* name;
  std::vector<std::string> unique;
};

// A table stands behind those that it refers to.
const std::vector<Known>& knownTables() {
  static const std::vector<Known> kTables = {
      {"person", {"initials_key"}},
      {"site", {"code_key"}},
      {"trench", {"site", "code_key"}},
      {"context", {"site", "trench", "number_key"}},
      {"bag", {"context", "number_key"}},
      {"batch", {}},
      {"photograph", {"batch", "side", "camera", "stop", "take"}},
      // Computed twice from the same photographs, by the same program.
      {"scan",
       {"batch", "side", "position", "name", "path", "points", "coverage_pct", "plate_x_mm",
        "plate_y_mm"}},
      {"pair_decision", {}},
      {"piece_decision", {}},
      {"sherd", {"front"}},
      {"measurement", {}},
      {"file", {"path"}}};
  return kTables;
}

Table describe(store::Database& database, const Known& known) {
  Table table;
  table.name = known.name;
  table.unique = known.unique;
  std::map<std::string, std::string> refers;
  store::Statement keys =
      database.sql("SELECT \"from\", \"table\" FROM pragma_foreign_key_list(?)", table.name);
  for (std::string from, to; keys.read(from, to);) refers[from] = to;
  store::Statement columns = database.sql("SELECT name FROM pragma_table_info(?)", table.name);
  for (std::string name; columns.read(name);) {
    if (name == "row" || name == "id") continue;
    table.refers.push_back(refers.contains(name) ? refers[name] : std::string());
    table.columns.push_back(name);
  }
  return table;
}

void readRows(store::Database& database, Table& table) {
  std::string columns;
  for (const std::string& column : table.columns) columns += ", " + column + " IS NULL, " + column;
  store::Statement rows =
      database.sql("SELECT row, id" + columns + " FROM " + table.name + " ORDER BY row");
  while (rows.next()) {
    Row row;
    rows >> row.row >> row.id;
    row.values.resize(table.columns.size());
    for (Value& value : row.values) {
      bool none = false;
      std::string text;
      rows >> none;
      rows.readText(text);
      if (!none) value = std::move(text);
    }
    table.by_id.emplace(row.id, table.rows.size());
    table.by_row.emplace(row.row, table.rows.size());
    table.rows.push_back(std::move(row));
  }
}

// By row number, as the tables have it; "#7" for a row that is gone.
std::string idOf(const Table& table, const std::string& row) {
  if (row.empty()) return row;
  const auto found = table.by_row.find(std::strtoll(row.c_str(), nullptr, 10));
  return found == table.by_row.end() ? "#" + row : table.rows[found->second].id;
}

void nameReferences(Content& content) {
  for (Table& table : content.tables)
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (table.refers[i].empty()) continue;
      const Table& target = content.table(table.refers[i]);
      for (Row& row : table.rows)
        if (row.values[i]) row.values[i] = idOf(target, *row.values[i]);
    }
}

// The history names the rows that a field refers to by their numbers; of a sherd's place it keeps
// the codes.
std::string referredBy(const Content& content, const std::string& table_name,
                       const std::string& field) {
  if (table_name == "batch" && field == "bags") return "bag";
  for (const Table& table : content.tables) {
    if (table.name != table_name) continue;
    const std::size_t i = table.column(field);
    if (i == table.columns.size()) return {};
    const bool code = table_name == "sherd" && (field == "context" || field == "bag");
    return code ? std::string() : table.refers[i];
  }
  return {};
}

std::string idsIn(const Table& table, const std::string& rows) {
  std::vector<std::string> ids;
  for (const std::string& row : store::splitTerms(rows)) ids.push_back(idOf(table, row));
  return joined(ids, "; ");
}

void readEvents(store::Database& database, Content& content) {
  std::map<std::string, const Table*> by_name;
  for (const Table& table : content.tables) by_name[table.name] = &table;
  store::Statement rows = database.sql(
      "SELECT at, person, table_name, row, field, old, new, why, source FROM history ORDER BY "
      "number");
  const Table& people = content.table("person");
  Event event;
  for (std::string person, row;
       rows.read(event.at, person, event.table, row, event.field, event.old_value, event.new_value,
                 event.why, event.source);) {
    event.person = idOf(people, person);
    const auto table = by_name.find(event.table);
    event.row = table == by_name.end() ? "#" + row : idOf(*table->second, row);
    if (event.row.starts_with("#")) event.row = event.table + event.row;
    event.refers = referredBy(content, event.table, event.field);
    if (!event.refers.empty())
      for (std::string* value : {&event.old_value, &event.new_value})
        *value = idsIn(*by_name.at(event.refers), *value);
    content.events.push_back(event);
  }
}

void readPairs(store::Database& database, Content& content) {
  store::Statement bags = database.sql(
      "SELECT batch.id, bag.id FROM batch_bag JOIN batch ON batch.row = batch JOIN bag ON bag.row "
      "= bag ORDER BY batch, position");
  for (std::string batch, bag; bags.read(batch, bag);) content.bags[batch].push_back(bag);
  using Texts = std::pair<std::string, std::string>;
  content.joins =
      database
          .sql(
              "SELECT a.id, b.id FROM sherd_join j JOIN sherd a ON a.row = j.sherd JOIN sherd b ON "
              "b.row = j.other ORDER BY j.sherd, j.other")
          .all(&Texts::first, &Texts::second);
  store::Statement given = database.sql(
      "SELECT number_key, slug_key, g.number, s.id, at FROM given_number g JOIN sherd s ON s.row = "
      "g.sherd ORDER BY number_key");
  while (given.next()) {
    std::vector<Value> row(5);
    for (Value& value : row) given >> value;
    content.given.push_back(std::move(row));
  }
  store::Statement terms =
      database.sql("SELECT name, term, labels, uri FROM vocabulary ORDER BY name, position, term");
  while (terms.next()) {
    std::vector<std::string> row(4);
    for (std::string& value : row) terms >> value;
    content.terms.push_back(std::move(row));
  }
  content.settings = database.sql("SELECT key, value FROM setting ORDER BY key")
                         .all(&Texts::first, &Texts::second);
}

}  // namespace

const Row* Table::find(const std::string& id) const {
  const auto found = by_id.find(id);
  return found == by_id.end() ? nullptr : &rows[found->second];
}

std::size_t Table::column(const std::string& of_name) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] == of_name) return i;
  return columns.size();
}

const Table& Content::table(const std::string& name) const {
  for (const Table& table : tables)
    if (table.name == name) return table;
  store::refuse(message("The catalogue's tables, indexes or triggers differ from those that "
                        "Ostraka creates; nothing was written."),
                name);
}

Content readContent(store::Database& database) {
  Content content;
  content.project_id = database.sql("SELECT id FROM project").one<std::string>();
  for (const Known& known : knownTables()) {
    content.tables.push_back(describe(database, known));
    readRows(database, content.tables.back());
  }
  readEvents(database, content);
  nameReferences(content);
  readPairs(database, content);
  return content;
}

}  // namespace ostraka::merge
