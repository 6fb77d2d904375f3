#include "upkeep/row_repair.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "catalogue/search.h"
#include "store/database.h"

namespace ostraka::upkeep {
namespace {

using From = RepairedRow::From;

// Written with each saved sherd, from other tables.
const std::set<std::string> kDerived = {"sherd_term", "sherd_measure"};

struct CatalogueTable {
  std::string name;
  std::string key;  ///< column of the row's number; empty for tables without
  std::vector<std::string> columns;
};

std::vector<CatalogueTable> tablesOf(store::Database& database) {
  std::vector<CatalogueTable> all;
  store::Statement tables = database.sql(
      "SELECT name, wr FROM pragma_table_list WHERE schema = 'main' AND type = 'table' AND name "
      "NOT LIKE 'sqlite_%' ORDER BY name");
  std::string table_name;
  bool without_rows = false;
  while (tables.read(table_name, without_rows)) {
    if (kDerived.contains(table_name)) continue;
    CatalogueTable table{table_name, {}, {}};
    if (!without_rows) table.key = "rowid";
    store::Statement columns =
        database.sql("SELECT name, type, pk FROM pragma_table_info(?)", table.name);
    std::string name, type;
    for (int place_in_key = 0; columns.read(name, type, place_in_key);) {
      const bool is_row = !without_rows && place_in_key == 1 && type == "INTEGER";
      if (is_row) table.key = name;
      if (!is_row) table.columns.push_back(name);
    }
    all.push_back(std::move(table));
  }
  return all;
}

class Collecting {
 public:
  Collecting(store::Database& damaged, store::Database& backup, store::Database& fresh,
             RepairReport& report)
      : damaged_(damaged), backup_(backup), fresh_(fresh), report_(report) {}

  void rowsOf(const CatalogueTable& table) {
    columns_ = joined(table.columns, ", ");
    std::string marks = "?";
    const std::size_t values = table.columns.size() + (table.key.empty() ? 0 : 1);
    for (std::size_t i = 1; i < values; ++i) marks += ", ?";
    const std::string named = (table.key.empty() ? "" : table.key + ", ") + columns_;
    insert_ = "INSERT OR IGNORE INTO " + table.name + " (" + named + ") VALUES (" + marks + ")";
    select_ = "SELECT " + named + " FROM " + table.name;
    table.key.empty() ? pairsOf(table) : numberedRowsOf(table);
  }

 private:
  // What cannot be written is no damage: everything ends here, instead of passing rows over.
  bool insertRow(const store::Statement& row) {
    store::valueOrThrow(fresh_.asResult([&] { fresh_.sql(insert_).withRow(row).run(); }));
    return fresh_.changes() > 0;
  }

  // Both ends of the table as far as they can be read; the middle as the backup has it.
  void pairsOf(const CatalogueTable& table) {
    bool whole = true;
    for (const char* order : {"", " DESC"}) {
      try {
        store::Statement rows = damaged_.sql(select_ + " ORDER BY " + table.columns[0] + order +
                                             ", " + table.columns[1] + order);
        while (rows.next()) insertRow(rows);
        if (whole) return;
      } catch (const store::SqlFailure&) {
        whole = false;
      }
    }
    // Between the two may have been rows that nothing else speaks of.
    report_.rows.push_back({table.name, 0, {}, {}, From::Nowhere});
    report_.cut_tables.insert(table.name);
    store::Statement rows = backup_.sql(select_);
    while (rows.next())
      if (insertRow(rows)) report_.rows.push_back({table.name, 0, {}, {}, From::Backup});
  }

  std::int64_t lastOf(store::Database& database, const std::string& sql) {
    try {
      return database.sql(sql).one<std::int64_t>();
    } catch (const store::SqlFailure&) {
      return 0;
    }
  }

  void numberedRowsOf(const CatalogueTable& table) {
    const std::string last = "SELECT max(" + table.key + ") FROM " + table.name;
    const std::string told = "SELECT max(row) FROM history WHERE table_name = '" + table.name + "'";
    const std::int64_t in_backup = lastOf(backup_, last);
    const std::int64_t end = std::max(
        {in_backup, lastOf(damaged_, last), lastOf(damaged_, told), lastOf(backup_, told)});
    std::vector<std::int64_t> unread;
    std::int64_t next = 1;
    while (!readOn(table, next)) {
      // The row is on a page that cannot be read, or it is the first of such a page.
      bool read = false;
      for (; next <= end && !read; ++next) {
        read = readOne(table, next);
        if (!read) unread.push_back(next);
      }
      if (read) continue;
      // A page at the table's end may have held rows that nothing else speaks of.
      report_.rows.push_back({table.name, next, {}, {}, From::Nowhere});
      break;
    }
    // An older row must not take the place of a newer one that can be read.
    for (const std::int64_t row : unread) takeFromBackup(table, row, in_backup);
  }

  // From `next` on; false where a page cannot be read, and then next is the first row missing.
  bool readOn(const CatalogueTable& table, std::int64_t& next) {
    try {
      store::Statement rows =
          damaged_.sql(select_ + " WHERE " + table.key + " >= ? ORDER BY " + table.key, next);
      while (rows.next()) {
        rows >> next;
        takeReadable(table, rows, next);
        ++next;
      }
      return true;
    } catch (const store::SqlFailure&) {
      return false;
    }
  }

  // Whether the damaged file says what row this is, or that there is none.
  bool readOne(const CatalogueTable& table, std::int64_t row) {
    try {
      store::Statement rows = damaged_.sql(select_ + " WHERE " + table.key + " = ?", row);
      if (rows.next()) takeReadable(table, rows, row);
      return true;
    } catch (const store::SqlFailure&) {
      return false;
    }
  }

  // One that breaks a rule of its table, as where an index failed to find another of its name, is
  // named; a page may also hold a row that was read from another one before.
  void takeReadable(const CatalogueTable& table, const store::Statement& found, std::int64_t row) {
    if (insertRow(found)) return;
    store::Statement same =
        fresh_.sql("SELECT 1 FROM " + table.name + " WHERE " + table.key + " = ?", row);
    if (!same.next()) report_.rows.push_back({table.name, row, {}, {}, From::Nowhere});
  }

  void takeFromBackup(const CatalogueTable& table, std::int64_t row, std::int64_t in_backup) {
    store::Statement rows = backup_.sql(select_ + " WHERE " + table.key + " = ?", row);
    const bool kept = rows.next();
    if (kept && insertRow(rows))
      report_.rows.push_back({table.name, row, {}, {}, From::Backup});
    else if (kept || row > in_backup)
      report_.rows.push_back({table.name, row, {}, {}, From::Nowhere});
  }

  store::Database& damaged_;
  store::Database& backup_;
  store::Database& fresh_;
  RepairReport& report_;
  std::string columns_, insert_, select_;
};

void deriveAnew(store::Database& fresh) {
  fresh.script(
      "INSERT INTO sherd_measure (sherd) SELECT row FROM sherd;"
      "INSERT INTO sherd_term SELECT DISTINCT term, field, sherd FROM sherd_terms;");
  for (const std::string& kind :
       fresh.sql("SELECT name FROM pragma_table_info('sherd_measure') WHERE pk = 0")
           .all<std::string>())
    fresh.script("UPDATE sherd_measure SET " + kind +
                 " = (SELECT value FROM measurement m WHERE "
                 "m.sherd = sherd_measure.sherd AND m.kind = '" +
                 kind + "' AND m.current = 1)");
  fresh.script(std::string("INSERT INTO sherd_text (rowid, words) SELECT sherd, ") +
               catalogue::kSearchedWords + " FROM sherd_words");
}

// Rows that point at what is gone: unset where that is allowed, else they go too.
void dropWhatPointsAtNothing(store::Database& fresh, RepairReport& report) {
  for (;;) {
    std::string table, parent, column, target;
    std::int64_t fitting = 0;
    {
      store::Statement broken = fresh.sql(
          "SELECT c.\"table\", c.parent, k.\"from\", ifnull(k.\"to\", 'rowid') FROM "
          "pragma_foreign_key_check c JOIN pragma_foreign_key_list(c.\"table\") k ON k.id = c.fkid "
          "LIMIT 1");
      if (!broken.next()) return;
      broken >> table >> parent >> column >> target;
    }
    const std::string where = " WHERE " + column + " IS NOT NULL AND " + column +
                              " NOT IN (SELECT " + target + " FROM " + parent + ")";
    fitting = fresh.sql("SELECT count(*) FROM " + table + where).one<std::int64_t>();
    const Result<void> unset = fresh.asResult(
        [&] { fresh.script("UPDATE " + table + " SET " + column + " = NULL" + where); });
    if (!unset && unset.error().code == ErrorCode::CannotWrite) throw store::Refused(unset.error());
    if (!unset) fresh.script("DELETE FROM " + table + where);
    for (std::int64_t i = 0; i < fitting; ++i)
      report.rows.push_back({table, 0, {}, unset ? column : std::string(), From::Nowhere});
  }
}

}  // namespace

Result<void> collectRows(store::Database& damaged, store::Database& backup, store::Database& fresh,
                         RepairReport& report) {
  if (Result<void> off = fresh.asResult([&] { fresh.script("PRAGMA foreign_keys = OFF"); }); !off)
    return off;
  const Result<void> done = fresh.inTransaction([&] {
    // Rows of the history are only added to, but for a repair.
    std::vector<std::string> triggers =
        fresh.sql("SELECT sql FROM sqlite_schema WHERE type = 'trigger'").all<std::string>();
    for (const std::string& name :
         fresh.sql("SELECT name FROM sqlite_schema WHERE type = 'trigger'").all<std::string>())
      fresh.script("DROP TRIGGER " + name);
    Collecting collecting(damaged, backup, fresh, report);
    for (const CatalogueTable& table : tablesOf(fresh)) collecting.rowsOf(table);
    makeLostRowsAnew(fresh, report);
    dropWhatPointsAtNothing(fresh, report);
    deriveAnew(fresh);
    for (const std::string& trigger : triggers) fresh.script(trigger);
  });
  if (!done) return done;
  return fresh.asResult([&] { fresh.script("PRAGMA foreign_keys = ON"); });
}

}  // namespace ostraka::upkeep
