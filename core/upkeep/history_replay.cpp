// What a catalogue's history says of rows that came from an older backup; whose each number is.

#include "catalogue/history.h"
#include "catalogue/search.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "upkeep/row_repair.h"

namespace ostraka::upkeep {
namespace {

using From = RepairedRow::From;

struct Change {
  std::string field, value;
  store::PersonRow by;
};

// The last value of each field, in the order in which they were changed last.
std::vector<Change> changesOf(store::Database& database, const RepairedRow& row,
                              std::int64_t after) {
  std::vector<Change> all;
  store::Statement rows = database.sql(
      "SELECT field, new, person FROM history h WHERE table_name = ?1 AND row = ?2 AND number > ?3 "
      "AND number = (SELECT max(number) FROM history WHERE table_name = ?1 AND row = ?2 AND field "
      "= h.field) ORDER BY number",
      row.table, row.row, after);
  for (Change change; rows.read(change.field, change.value, change.by);)
    if (!change.field.empty()) all.push_back(change);
  return all;
}

// False where the change itself is refused. A full disk ends everything.
template <class Value>
bool isDone(const Result<Value>& change) {
  if (!change && change.error().code == ErrorCode::CannotWrite)
    throw store::Refused(change.error());
  return change.has_value();
}

// Its uuid is what the history says first of a new sherd.
bool addSherdOfHistory(catalogue::Catalogue& repaired, std::int64_t row) {
  store::Database& database = repaired.database();
  store::Statement first = database.sql(
      "SELECT new, at, person FROM history WHERE table_name = 'sherd' AND row = ? AND field = ''",
      row);
  std::string id;
  std::int64_t at = 0;
  store::PersonRow by;
  if (!first.read(id, at, by)) return false;
  const Result<void> added = database.inTransaction([&] {
    database.run(
        "INSERT INTO sherd (row, id, created_at, created_by, updated_at, updated_by, "
        "number_sort) VALUES (?, ?, ?, ?, ?, ?, ?)",
        row, id, at, by, at, by, sherds::kBehindAllNumbers);
    database.run("INSERT INTO sherd_measure (sherd) VALUES (?)", row);
    catalogue::searchAnew(database, store::SherdRow{row});
  });
  return isDone(added);
}

// A column of another table: numbers are stored as such, and nothing as NULL where that may be.
bool setColumn(store::Database& database, const RepairedRow& row, const Change& change) {
  store::Statement known = database.sql(
      "SELECT \"notnull\" FROM pragma_table_info(?) WHERE name = ? AND name NOT IN ('row', 'id')",
      row.table, change.field);
  bool filled = false;
  if (!known.read(filled)) return false;
  const std::string value = filled ? "?1" : "nullif(?1, '')";
  return isDone(database.inTransaction([&] {
    database.run("UPDATE " + row.table + " SET " + change.field + " = " + value + " WHERE row = ?2",
                 change.value, row.row);
  }));
}

// A place is named by several fields.
bool changeTogether(catalogue::Catalogue& repaired, const RepairedRow& row,
                    const std::vector<Change>& changes) {
  std::vector<records::FieldChange> fields;
  for (const Change& change : changes)
    fields.push_back({store::SherdRow{row.row}, change.field, change.value});
  const store::PersonRow by = changes.empty() ? store::PersonRow{} : changes.back().by;
  return isDone(sherds::SherdChanges(repaired).apply(fields, {by, "repair", {}}));
}

// Each number is that of one sherd: of the one to which it was given, else of the first.
void settleNumbers(catalogue::Catalogue& repaired, RepairReport& report) {
  store::Database& database = repaired.database();
  for (const store::SherdRow& row :
       database.sql("SELECT row FROM sherd WHERE number <> '' ORDER BY row")
           .all<store::SherdRow>()) {
    const auto number =
        database.sql("SELECT number FROM sherd WHERE row = ?", row).one<std::string>();
    const sherds::Taken taken = sherds::takenBy(database, number);
    if (taken.sherd == row) continue;
    const records::SherdRecord sherd = store::valueOrThrow(sherds::Sherds(repaired).get(row));
    if (!taken.sherd) {
      sherds::giveNumber(repaired, sherd, number);
      continue;
    }
    sherds::setNumber(repaired, sherd, {});
    catalogue::remember(repaired, {{}, "repair", {}}, "sherd", row.value, "number", number, {});
    catalogue::searchAnew(database, row);
    report.rows.push_back(
        {"sherd", row.value, number, "number", From::Nowhere,
         "sherd " + std::to_string(taken.sherd.value) + " (" + taken.number + ")"});
  }
}

}  // namespace

Result<void> replayHistory(catalogue::Catalogue& repaired, std::int64_t last_known,
                           RepairReport& report) {
  store::Database& database = repaired.database();
  std::vector<RepairedRow> unknown;
  const Result<void> done = database.asResult([&] {
    for (RepairedRow& row : report.rows) {
      if (row.row == 0 || !row.field.empty()) continue;
      const bool sherd = row.table == "sherd";
      if (row.from == From::Nowhere) {
        if (!sherd || !addSherdOfHistory(repaired, row.row)) continue;
        row.from = From::History;
      }
      const std::int64_t after = row.from == From::Backup ? last_known : 0;
      const std::vector<Change> changes = changesOf(database, row, after);
      if (sherd && changeTogether(repaired, row, changes)) continue;
      for (const Change& change : changes) {
        const bool set =
            sherd ? changeTogether(repaired, row, {change}) : setColumn(database, row, change);
        if (!set) unknown.push_back({row.table, row.row, {}, change.field, From::Nowhere});
      }
    }
  });
  if (!done) return done;
  report.rows.insert(report.rows.end(), unknown.begin(), unknown.end());
  return database.inTransaction([&] { settleNumbers(repaired, report); });
}

}  // namespace ostraka::upkeep
