// What a catalogue's history says of rows that came from an older backup; whose each number is.

#include <algorithm>
#include <set>

#include "catalogue/history.h"
#include "catalogue/search.h"
#include "catalogue/settings.h"
#include "decisions/mask_strokes.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"
#include "upkeep/row_repair.h"

namespace ostraka::upkeep {
namespace {

using From = RepairedRow::From;

struct Change {
  std::string field, value;
  store::PersonRow by;
};

// What lies in tables of its own, which may be whole.
bool isOfAnotherTable(const std::string& table, const std::string& field) {
  if (table == "batch") return field == "bags" || field.starts_with(decisions::kStrokesField);
  return table == "sherd" && (field == "joins" || !records::unitOf(field).empty());
}

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
    if (!change.field.empty() && !isOfAnotherTable(row.table, change.field)) all.push_back(change);
  return all;
}

// False where the change itself is refused. A full disk ends everything.
template <class Value>
bool isDone(const Result<Value>& change) {
  if (!change && change.error().code == ErrorCode::CannotWrite)
    throw store::Refused(change.error());
  return change.has_value();
}

// A column of another table: numbers are stored as such, and nothing as NULL where that may be.
bool setColumn(store::Database& database, const RepairedRow& row, const Change& change) {
  store::Statement known = database.sql(
      "SELECT \"notnull\" FROM pragma_table_info(?) WHERE name = ? AND name NOT IN ('row', 'id')",
      row.table, change.field);
  bool filled = false;
  if (!known.read(filled)) return false;
  const std::string value = filled ? "?1" : "nullif(?1, '')";
  const std::string key = change.field + "_key";  // what it is unique by
  const bool has_key =
      database.sql("SELECT 1 FROM pragma_table_info(?) WHERE name = ?", row.table, key).next();
  return isDone(database.inTransaction([&] {
    database.run("UPDATE " + row.table + " SET " + change.field + " = " + value + " WHERE row = ?2",
                 change.value, row.row);
    if (has_key)
      database.run("UPDATE " + row.table + " SET " + key + " = ? WHERE row = ?",
                   store::codeKey(change.value), row.row);
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

struct Told {
  std::int64_t row = 0;
  std::string field, before, after;
};

// Oldest first; an empty field stands for all.
std::vector<Told> toldSince(store::Database& database, const std::string& table,
                            const std::string& field, std::int64_t last_known) {
  std::vector<Told> all;
  store::Statement rows = database.sql(
      "SELECT row, field, old, new FROM history WHERE table_name = ?1 AND (?2 = '' OR field = ?2) "
      "AND number > ?3 ORDER BY number",
      table, field, last_known);
  for (Told told; rows.read(told.row, told.field, told.before, told.after);) all.push_back(told);
  return all;
}

bool isThere(store::Database& database, std::int64_t sherd) {
  return database.sql("SELECT 1 FROM sherd WHERE row = ?", sherd).next();
}

// Those that a sherd had before, too.
void keepNumbersTaken(catalogue::Catalogue& repaired) {
  store::Database& database = repaired.database();
  for (const Told& told : toldSince(database, "sherd", "number", 0)) {
    if (told.after.empty() || sherds::takenBy(database, told.after).sherd ||
        !isThere(database, told.row))
      continue;
    const store::SherdRow row{told.row};
    sherds::giveNumber(repaired, store::valueOrThrow(sherds::Sherds(repaired).get(row)),
                       told.after);
  }
}

// Terms that were deleted since go, new ones come, and each is called as it was last.
void replayVocabularies(store::Database& database, std::int64_t last_known, RepairReport& report) {
  std::set<std::string> changed;
  for (const Told& told : toldSince(database, "vocabulary", {}, last_known)) {
    if (const std::size_t end = told.field.find('/'); end != std::string::npos) {
      const catalogue::ToldTerm term = catalogue::toldTermFrom(told.after);
      database.run("UPDATE vocabulary SET labels = ?, uri = ? WHERE name = ? AND term = ?",
                   term.labels_json, term.uri, told.field.substr(0, end),
                   told.field.substr(end + 1));
      changed.insert(told.field.substr(0, end));
      continue;
    }
    const std::vector<std::string> terms = store::splitTerms(told.after);
    for (const std::string& term : store::splitTerms(told.before))
      if (std::find(terms.begin(), terms.end(), term) == terms.end())
        database.run("DELETE FROM vocabulary WHERE name = ? AND term = ?", told.field, term);
    for (std::size_t i = 0; i < terms.size(); ++i)
      database.run(
          "INSERT INTO vocabulary (name, term, position) VALUES (?, ?, ?) ON CONFLICT DO UPDATE "
          "SET position = excluded.position",
          told.field, terms[i], static_cast<std::int64_t>(i));
    changed.insert(told.field);
  }
  for (const std::string& name : changed)
    report.rows.push_back({"vocabulary", 0, name, {}, From::History});
}

void replaySettings(store::Database& database, std::int64_t last_known, RepairReport& report) {
  std::set<std::string> changed;
  for (const Told& told : toldSince(database, "setting", {}, last_known)) {
    database.run("INSERT OR REPLACE INTO setting VALUES (?, ?)", told.field, told.after);
    changed.insert(told.field);
  }
  for (const std::string& key : changed)
    report.rows.push_back({"setting", 0, key, {}, From::History});
}

// By any number that was ever its own, or by its uuid.
store::SherdRow sherdCalled(store::Database& database, const std::string& name) {
  const sherds::Taken taken = sherds::takenBy(database, name);
  if (taken.sherd && !taken.slug_only) return taken.sherd;
  return database.sql("SELECT row FROM sherd WHERE id = ?", name).one<store::SherdRow>();
}

// What each change joined and parted.
void replayJoins(store::Database& database, std::int64_t last_known, RepairReport& report) {
  std::set<std::int64_t> changed;
  for (const Told& told : toldSince(database, "sherd", "joins", last_known)) {
    if (!isThere(database, told.row)) continue;
    const auto each = [&](const std::string& names, const char* sql) {
      for (const std::string& name : store::splitTerms(names)) {
        const store::SherdRow other = sherdCalled(database, name);
        if (!other) continue;
        database.run(sql, told.row, other);
        database.run(sql, other, told.row);
      }
    };
    each(told.before, "DELETE FROM sherd_join WHERE sherd = ? AND other = ?");
    each(told.after, "INSERT OR IGNORE INTO sherd_join VALUES (?, ?)");
    changed.insert(told.row);
  }
  for (const std::int64_t row : changed)
    report.rows.push_back({"sherd", row, {}, "joins", From::History});
}

void replayBags(store::Database& database, std::int64_t last_known, RepairReport& report) {
  std::set<std::int64_t> changed;
  for (const Told& told : toldSince(database, "batch", "bags", last_known)) {
    database.run("DELETE FROM batch_bag WHERE batch = ?", told.row);
    std::int64_t position = 0;
    for (const std::string& bag : store::splitTerms(told.after))
      database.run(
          "INSERT OR IGNORE INTO batch_bag SELECT batch.row, ?, bag.row FROM batch, bag WHERE "
          "batch.row = ? AND bag.row = CAST(? AS INTEGER)",
          position++, told.row, bag);
    changed.insert(told.row);
  }
  for (const std::int64_t row : changed)
    report.rows.push_back({"batch", row, {}, "bags", From::History});
}

struct ToldMeasure {
  std::int64_t sherd = 0;
  std::string kind, value, source;
  store::PersonRow by;
};

// The last one of each kind of each sherd.
std::vector<ToldMeasure> toldMeasures(store::Database& database) {
  std::vector<ToldMeasure> all;
  store::Statement rows = database.sql(
      "SELECT row, field, new, source, person, max(number) FROM history WHERE table_name = 'sherd' "
      "AND row IN (SELECT row FROM sherd) GROUP BY row, field");
  for (ToldMeasure told; rows.read(told.sherd, told.kind, told.value, told.source, told.by);)
    if (!records::unitOf(told.kind).empty()) all.push_back(told);
  return all;
}

// How it was measured is not in the history, unless the program did it.
void refill(catalogue::Catalogue& repaired, const ToldMeasure& told, RepairReport& report) {
  const std::size_t sign = told.value.find("±");  // 12.5 ± 0.4
  const Result<double> value = store::parsedNumber(told.value.substr(0, sign));
  std::optional<double> uncertainty;
  if (sign != std::string::npos)
    if (const Result<double> half = store::parsedNumber(told.value.substr(sign + 2)); half)
      uncertainty = *half;
  const bool of_program = !told.by && told.source == "process";
  const bool set = value && isDone(repaired.database().inTransaction([&] {
                     sherds::setMeasure(repaired,
                                        {store::SherdRow{told.sherd},
                                         told.kind,
                                         {},
                                         *value,
                                         uncertainty,
                                         of_program ? "program" : "imported",
                                         told.by,
                                         {}},
                                        {told.by, of_program ? "process" : "repair", {}},
                                        sherds::MeasureRank::Always);
                   }));
  report.rows.push_back({"sherd", told.sherd, {}, told.kind, set ? From::History : From::Nowhere});
}

// Where the measurement that counts is lost, or is older than the one that was.
void refillMeasures(catalogue::Catalogue& repaired, RepairReport& report) {
  std::set<std::int64_t> of_backup;
  bool any_lost = false;
  for (const RepairedRow& row : report.rows) {
    if (row.table != "measurement") continue;
    any_lost = true;
    if (row.from == From::Backup) of_backup.insert(row.row);
  }
  if (!any_lost) return;
  store::Database& database = repaired.database();
  for (const ToldMeasure& told : toldMeasures(database)) {
    std::int64_t row = 0;
    double value = 0;
    std::optional<double> uncertainty;
    database
        .sql(
            "SELECT row, value, uncertainty FROM measurement WHERE sherd = ? AND kind = ? AND "
            "current = 1",
            told.sherd, told.kind)
        .read(row, value, uncertainty);
    if (row > 0 &&
        (!of_backup.contains(row) || told.value == sherds::measurementText(value, uncertainty)))
      continue;
    if (!told.value.empty())
      refill(repaired, told, report);
    else if (row > 0)
      sherds::clearMeasure(repaired, store::SherdRow{told.sherd}, told.kind,
                           {told.by, "repair", {}});
  }
}

}  // namespace

Result<void> replayHistory(catalogue::Catalogue& repaired, std::int64_t last_known,
                           RepairReport& report) {
  store::Database& database = repaired.database();
  std::vector<RepairedRow> unknown;
  const Result<void> done = database.asResult([&] {
    if (report.cut_tables.contains("setting")) replaySettings(database, last_known, report);
    if (report.cut_tables.contains("vocabulary")) replayVocabularies(database, last_known, report);
    for (const RepairedRow& row : report.rows) {
      if (row.row == 0 || !row.field.empty() || row.from == From::Nowhere) continue;
      const bool sherd = row.table == "sherd";
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
  return database.inTransaction([&] {
    settleNumbers(repaired, report);
    keepNumbersTaken(repaired);
    if (report.cut_tables.contains("sherd_join")) replayJoins(database, last_known, report);
    if (report.cut_tables.contains("batch_bag")) replayBags(database, last_known, report);
    refillMeasures(repaired, report);
  });
}

}  // namespace ostraka::upkeep
