#include "merge/merging.h"

#include <algorithm>

#include "catalogue/stamped_rows.h"
#include "sherds/sherd_columns.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::merge {
namespace {

const std::set<std::string> kPlaces = {"person", "site", "trench", "context", "bag"};

std::string naturalKey(const Table& table, const std::vector<Value>& values) {
  std::string key;
  const std::size_t one_with = table.column("one_with");
  if (table.unique.empty() || (one_with < values.size() && values[one_with])) return key;
  for (const std::string& name : table.unique) {
    const Value& value = values[table.column(name)];
    if (table.name == "sherd" && !value) return {};
    key += value.value_or("") + '\x1f';
  }
  return key;
}

bool allEmpty(const std::vector<Value>& values, const Unit& unit) {
  return std::ranges::all_of(unit.columns,
                             [&](std::size_t i) { return values[i].value_or("").empty(); });
}

const Table* tableWith(const Content& content, const std::string& id) {
  for (const Table& table : content.tables)
    if (table.by_id.contains(id)) return &table;
  return nullptr;
}

// Whether a setting may call two rows the same. Places and persons that have different names were
// called otherwise since, as a history tells.
bool canBeSame(const Content& a, const std::string& mine, const Content& b,
               const std::string& theirs) {
  const Table &table = *tableWith(a, mine), &other = *tableWith(b, theirs);
  if (table.name != other.name || !kPlaces.contains(table.name)) return table.name == other.name;
  const std::string& key = table.unique.back();
  if (table.find(mine)->values[table.column(key)] == other.find(theirs)->values[other.column(key)])
    return true;
  const auto renamed = [&](const Content& content, const std::string& id) {
    return std::ranges::any_of(content.events, [&](const Event& event) {
      return event.table == table.name && event.row == id && event.field + "_key" == key;
    });
  };
  return renamed(a, mine) || renamed(b, theirs);
}

bool sameIn(const Unit& unit, const std::vector<Value>& a, const std::vector<Value>& b) {
  return std::ranges::all_of(unit.columns, [&](std::size_t i) { return a[i] == b[i]; });
}

}  // namespace

bool MergeReport::unsettled() const {
  return std::ranges::any_of(conflicts, [](const Conflict& conflict) { return !conflict.settled; });
}

Merging::Merging(Projects projects, const Settled& settled, const records::Provenance& provenance)
    : projects_(std::move(projects)),
      settled_(settled),
      provenance_(provenance),
      database_(projects_.a.database()),
      b_(projects_.b_content),
      places_(projects_.a, a_, rows_) {}

Outcome Merging::run() {
  a_ = readContent(database_);
  for (const Table& table : a_.tables)
    for (const Row& row : table.rows) {
      rows_[row.id] = row.row;
      label(table, row.id, row.values);
    }
  for (const Table& table : a_.tables) units_[table.name] = unitsOf(table);
  readAliases();
  for (std::size_t i = 0; i < a_.tables.size(); ++i) mergeTable(a_.tables[i], b_.tables[i]);
  setDeferred();
  mergeBags();
  renumberLosers();
  addGivenNumbers();
  mergeMeasurements();
  mergeJoins();
  mergeProject();
  mergeSettings();
  withdrawLosers();
  mergePeoplesFiles();
  finishBatches();
  assignNumbers();
  searchAnew();
  mergeTerms();
  return std::move(outcome_);
}

void Merging::readAliases() {
  for (const Content* content : {static_cast<const Content*>(&a_), &b_})
    for (const auto& [key, value] : content->settings) {
      if (!key.starts_with(kSameRow)) continue;
      const std::string other = key.substr(std::string_view(kSameRow).size());
      for (const auto& [mine, theirs] : {std::pair(value, other), {other, value}}) {
        if (!rows_.contains(mine) || rows_.contains(theirs) || !tableWith(b_, theirs)) continue;
        if (a_.table("sherd").find(mine) && b_.table("sherd").find(theirs))
          continue;  // readSameSherds
        // One of A's own that does not fit came with a merge, and means nothing.
        if (canBeSame(a_, mine, b_, theirs))
          alias_[theirs] = mine;
        else if (content == &b_)
          store::refuse(message("The setting %1 of project B says that two different things are "
                                "the same; nothing was merged. Ask for another copy of project B.",
                                key),
                        projects_.b.database().file().string());
      }
    }
  readSameSherds();
}

Merging::Values Merging::canonical(const Table& table, const Row& row) const {
  Values values = row.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    const std::string& column = table.columns[i];
    if (!table.refers[i].empty()) values[i] = canonicalId(*values[i]);
    if (column == "path" || column == "model_path" || column == "preview_path")
      values[i] = placed(*values[i]);
  }
  return values;
}

void Merging::aliasRows(const Table& a, const Table& b) {
  if (a.unique.empty()) return;
  std::unordered_map<std::string, const Row*> mine;
  for (const Row& row : a.rows)
    if (std::string key = naturalKey(a, row.values); !key.empty()) mine.emplace(key, &row);
  for (const Row& theirs : b.rows) {
    if (rows_.contains(canonicalId(theirs.id))) continue;
    const Values values = canonical(b, theirs);
    const auto found = mine.find(naturalKey(b, values));
    // One that B has under its own uuid, too, is called otherwise there by now.
    if (found == mine.end() || b.by_id.contains(found->second->id)) continue;
    if (!sameUnderAnotherId(a, *found->second, b, theirs, values)) continue;
    alias_[theirs.id] = found->second->id;
    if (a.name != "file" && a.name != "photograph")
      database_.run("INSERT OR IGNORE INTO setting VALUES (?, ?)", kSameRow + theirs.id,
                    found->second->id);
  }
}

// Places and persons of one name are one place and one person, unless somebody says otherwise:
// what they say differently is settled for all of it at once.
bool Merging::sameUnderAnotherId(const Table& a, const Row& mine, const Table& b, const Row& theirs,
                                 const Values& values) {
  if (!kPlaces.contains(a.name)) return true;
  Conflict conflict{a.name + "/" + theirs.id,        a.name, wholeName(a, mine.id), {}, {}, {},
                    {Take::A, Take::B, Take::Number}};
  for (const Unit& unit : units_.at(b.name)) {
    if (sameIn(unit, mine.values, values) || allEmpty(mine.values, unit) || allEmpty(values, unit))
      continue;
    // É-1 and é-1 are the same; the spelling of A stays.
    if (unit.name == "number" || unit.name == "code" || unit.name == "initials") continue;
    for (const auto& [version, row] :
         {std::pair(&conflict.a, &mine.values), {&conflict.b, &values}})
      for (auto& value : versionOf(a, unit, *row).values) version->values.push_back(value);
  }
  if (conflict.a.values.empty()) {
    of_row_[mine.id] = Take::A;  // a spelling, or what one of them does not say
    return true;
  }
  stampRow(conflict.a, a, mine.values, "updated_by", "updated_at");
  stampRow(conflict.b, b, values, "updated_by", "updated_at");
  const Take take = settle(std::move(conflict));
  if (take == Take::Number) return false;
  of_row_[mine.id] = take;
  return true;
}

void Merging::mergeTable(const Table& a, const Table& b) {
  aliasRows(a, b);
  if (a.name == "sherd") noteNumbers();
  compareHistories(a.name);
  if (a.name == "pair_decision") comparePairs();
  if (a.name == "piece_decision") comparePieces();
  if (a.name == "scan") noteOwnComputations();
  std::vector<const Row*> both, fresh;
  for (const Row& theirs : b.rows)
    (a.find(canonicalId(theirs.id)) ? both : fresh).push_back(&theirs);
  JoinedPlaces::sort(b, fresh);
  // First what both have: a name may be free once its old bearer is called otherwise. Names of
  // places are held until all are known, and a place may be one with one that is new.
  const bool names_are_held = a.column("one_with") < a.columns.size();
  if (names_are_held)
    for (const Row* theirs : fresh) insertRow(b, *theirs, canonical(b, *theirs));
  for (const Row* theirs : both) {
    const Row* mine = a.find(canonicalId(theirs->id));
    if (a.name == "batch")
      folder_of_[theirs->values[b.column("number")].value_or("")] = labelOf(mine->id);
    copyEvents(mine->id);
    mergeRow(a, *mine, *theirs);
  }
  if (!names_are_held)
    for (const Row* theirs : fresh) insertRow(b, *theirs, canonical(b, *theirs));
  places_.settle(a, deferred_);
}

void Merging::mergeRow(const Table& table, const Row& mine, const Row& theirs) {
  Values wanted = canonical(table, theirs);
  if (table.name == "file") restoreFile(table, mine, theirs);
  if (wanted == mine.values || isOfResults(table, wanted, computed_in_a_)) return;
  if (table.name == "sherd" && !takesNumber(mine.id, table, wanted))
    // Another sherd of A keeps the number that B gave to this one.
    for (const char* column : {"number", "number_sort", "state", "void_reason"})
      wanted[table.column(column)] = mine.values[table.column(column)];
  std::vector<std::pair<std::size_t, Value>> changes;
  for (const Unit& unit : units_.at(table.name)) {
    if (sameIn(unit, mine.values, wanted)) continue;
    const bool none_a = allEmpty(mine.values, unit), none_b = allEmpty(wanted, unit);
    const bool changed = !of_row_.contains(mine.id) && (touches(touched_a_, mine.id, unit.fields) ||
                                                        touches(touched_b_, mine.id, unit.fields));
    // Whose a file is follows from the models of the sherds: A's word, unless somebody changed it.
    const bool follows = table.name == "file" && unit.name == "sherd";
    Take take = none_a && !follows ? Take::B : Take::A;  // one of them does not say
    if (unit.name == "content" && isOfResults(table, wanted, computed_in_b_))
      take = Take::B;  // with the scans
    else if (changed || !(none_a || none_b || follows))
      take = decide(&table, saidOf(table, unit, mine, wanted));
    if (take != Take::B) continue;
    for (const std::size_t i : unit.columns) changes.emplace_back(i, wanted[i]);
    if (table.name == "sherd" && unit.name == "number")
      claimNumber(mine.id, wanted[table.column("number")].value_or(""));
    if (table.name == "file" && unit.name == "content")
      addFile(table, wanted, theirs.values[table.column("path")].value_or("")).replaces = true;
    if (table.name == "scan" && unit.name == "place")
      computed_in_b_.insert(wanted[table.column("batch")].value_or(""));
  }
  if (!changes.empty()) write(table, mine.row, changes);
  mergeCustomFields(table, mine, wanted);
}

Said Merging::saidOf(const Table& table, const Unit& unit, const Row& mine,
                     const Values& theirs) const {
  Said said{unit.name,
            mine.id,
            unit.fields,
            versionOf(table, unit, mine.values),
            versionOf(table, unit, theirs),
            unit.fields.front(),
            {},
            {}};
  for (const std::size_t i : unit.columns) {
    said.told_a = told(table, i, mine.values[i]);
    said.told_b = told(table, i, theirs[i]);
    said.field = table.columns[i];
    if (said.told_a != said.told_b) break;
  }
  return said;
}

// As the history has it: rows by their numbers, but the place of a sherd by its names.
std::string Merging::told(const Table& table, std::size_t column, const Value& value) const {
  if (!value) return {};
  const std::string& name = table.columns[column];
  const bool sherd = table.name == "sherd";
  if (sherd && (name == "part" || name == "decoration" || name == "condition"))
    return store::joinTerms(store::termsFromJson(*value));
  if (table.refers[column].empty()) return *value;
  if (sherd && (name == "context" || name == "bag")) return labelOf(*value);
  return stored(table, column, value).value_or("");
}

void Merging::mergeCustomFields(const Table& table, const Row& mine, const Values& theirs) {
  const std::size_t column = table.column("extra");
  if (column == table.columns.size() || mine.values[column] == theirs[column]) return;
  std::map<std::string, std::string> a, b;
  for (auto& [name, value] : customFields(mine.values[column])) a[name] = value;
  for (auto& [name, value] : customFields(theirs[column])) b[name] = value;
  std::map<std::string, std::string> merged = a;
  for (const auto& [name, value] : b) merged.emplace(name, "");
  for (auto& [name, value] : merged) {
    const std::string own = a.contains(name) ? a[name] : "",
                      other = b.contains(name) ? b[name] : "";
    if (own == other) continue;
    const std::string field = "extra." + name;
    const bool changed =
        touches(touched_a_, mine.id, {field}) || touches(touched_b_, mine.id, {field});
    const Take take = !changed && (own.empty() || other.empty())
                          ? (own.empty() ? Take::B : Take::A)
                          : decide(&table, saidText(field, mine.id, textOf(own), textOf(other)));
    value = take == Take::B ? other : own;
  }
  std::erase_if(merged, [](const auto& field) { return field.second.empty(); });
  if (merged == a) return;
  write(table, mine.row, {{column, customFieldsJson({merged.begin(), merged.end()})}});
}

void Merging::insertRow(const Table& table, const Row& theirs, const Values& given) {
  Values values = given;
  if (isOfResults(table, values, computed_in_a_)) return;
  std::string called_before, calling;
  if (kPlaces.contains(table.name)) {
    const std::string conflict = table.name + "/" + theirs.id;
    if (const Choice* choice = choiceOf(conflict); choice && choice->take == Take::Number) {
      calling = table.name == "person"                           ? "initials"
                : table.name == "site" || table.name == "trench" ? "code"
                                                                 : "number";
      Value& called = values[table.column(calling)];
      called_before = called.value_or("");
      called = store::valueOrThrow(newName(conflict, *choice));
      values[table.column(calling + "_key")] = store::codeKey(*called);
      if (!claimName(table, values))
        store::refuse(
            message("The number or code %1 is already in use; nothing was merged. Settle "
                    "the conflict %2 with another one.",
                    *called, conflict));
    }
  }
  if (table.name == "batch") numberBatch(table, theirs, values);
  if (table.name == "scan") placeScan(table, theirs, values);
  if (const std::size_t i = table.column("one_with"); i < values.size() && !values[i]) {
    const bool came = std::ranges::any_of(table.unique, [&](const std::string& column) {
      const Value& within = theirs.values[table.column(column)];
      return within && places_.now(sameId(*within)) != sameId(*within);
    });
    Value& key = values[table.column(table.unique.back())];
    key = places_.heldKey(table.name, key, came, theirs.id);
  }
  const bool numbered = table.name != "sherd" || takesNumber(theirs.id, table, values);
  if (!numbered) {
    values[table.column("number")] = "";
    values[table.column("number_sort")] = sherds::kBehindAllNumbers;
    if (values[table.column("state")] == "numbered") values[table.column("state")] = "draft";
  }
  std::string columns, marks;
  for (const std::string& column : table.columns) {
    columns += ", " + column;
    marks += ", ?";
  }
  store::Statement insert =
      database_.sql("INSERT INTO " + table.name + " (row, id" + columns + ") VALUES (" +
                    catalogue::nextRow(table.name) + ", ?" + marks + ")");
  insert.with(theirs.id);
  std::vector<Deferred> later;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool taken_in_turn =
        table.name == "sherd" && (table.columns[i] == "front" || table.columns[i] == "back");
    const bool unknown = !table.refers[i].empty() && values[i] && !rows_.contains(*values[i]);
    if (values[i] && (taken_in_turn || unknown)) {
      later.push_back({table.name, table.columns[i], *values[i], 0});
      insert.with(Value());
    } else if (table.name == "measurement" && table.columns[i] == "current") {
      insert.with(0);  // until it is known which one counts
    } else {
      insert.with(stored(table, i, values[i]));
    }
  }
  insert.run();
  const std::int64_t row = database_.lastRow();
  rows_[theirs.id] = row;
  label(table, theirs.id, values);
  for (Deferred& one : later) {
    one.row = row;
    deferred_.push_back(std::move(one));
  }
  ++outcome_.added;
  if (table.name == "sherd") ++outcome_.sherds;
  if (table.name == "batch") ++outcome_.batches;
  copyEvents(theirs.id);
  if (!calling.empty())
    remember(table.name, row, calling, called_before, values[table.column(calling)].value_or(""));
  if (const auto scan = demoted_.find(theirs.id); scan != demoted_.end())
    remember("scan", row, "name", scan->second, labelOf(theirs.id));
  if (table.name == "sherd") {
    database_.run("INSERT INTO sherd_measure (sherd) VALUES (?)", row);
    changed_sherds_.insert(row);
    if (numbered) claimNumber(theirs.id, values[table.column("number")].value_or(""));
  }
  if (table.name == "file")
    addFile(table, values, theirs.values[table.column("path")].value_or(""));
}

// False where another place or person has the name, or another conflict was settled with it.
bool Merging::claimName(const Table& table, const Values& values) {
  const std::string key = naturalKey(table, values);
  const auto is_called_so = [&](const Row& row) {
    return naturalKey(table, canonical(table, row)) == key;
  };
  const std::vector<Row>&mine = a_.table(table.name).rows, &theirs = table.rows;
  return std::none_of(mine.begin(), mine.end(), is_called_so) &&
         std::none_of(theirs.begin(), theirs.end(), is_called_so) &&
         new_places_.insert(table.name + key).second;
}

void Merging::write(const Table& table, std::int64_t row,
                    std::vector<std::pair<std::size_t, Value>> changes) {
  places_.hold(table, row, changes);
  std::string columns;
  for (const auto& [i, value] : changes) columns += table.columns[i] + " = ?, ";
  store::Statement update =
      database_.sql("UPDATE " + table.name + " SET " + columns +
                    "updated_at = ?, updated_by = ?, revision = revision + 1 WHERE row = ?");
  for (const auto& [i, value] : changes) {
    const bool taken_in_turn =
        table.name == "sherd" && (table.columns[i] == "front" || table.columns[i] == "back");
    const bool unknown = !table.refers[i].empty() && value && !rows_.contains(*value);
    if (value && (taken_in_turn || unknown)) {
      deferred_.push_back({table.name, table.columns[i], *value, row});
      update.with(Value());
    } else if (table.name == "scan" && table.columns[i] == "position") {
      scan_positions_.emplace_back(row, value);
      update.with(-1'000'000'000 - row);  // out of the way of the others
    } else {
      update.with(stored(table, i, value));
    }
  }
  update.with(projects_.a.now(), provenance_.person, row).run();
  ++outcome_.changed;
  if (table.name == "sherd") changed_sherds_.insert(row);
  places_changed_ |= kPlaces.contains(table.name) || table.name == "batch";
}

void Merging::setDeferred() {
  for (const auto& [row, position] : scan_positions_) {
    store::Statement held = database_.sql(
        "SELECT 1 FROM scan a JOIN scan b ON b.batch = a.batch AND b.side = a.side WHERE a.row = ? "
        "AND b.position = ?",
        row, position);
    if (!held.next()) database_.run("UPDATE scan SET position = ? WHERE row = ?", position, row);
  }
  for (const Deferred& one : deferred_) {
    const auto target = rows_.find(one.id);
    if (target == rows_.end()) continue;
    // A scan that another sherd has by now stays there: the decisions about its batch say whose.
    if (one.table == "sherd" &&
        database_.sql("SELECT 1 FROM sherd WHERE " + one.column + " = ?", target->second).next())
      continue;
    database_.run("UPDATE " + one.table + " SET " + one.column + " = ? WHERE row = ?",
                  target->second, one.row);
  }
}

Value Merging::stored(const Table& table, std::size_t column, const Value& value) const {
  if (!value || table.refers[column].empty()) return value;
  const auto found = rows_.find(*value);
  return found == rows_.end() ? Value() : Value(std::to_string(found->second));
}

Take Merging::decide(const Table* table, Said said) {
  const std::string name = table ? table->name : "vocabulary";
  const bool in_a = touches(touched_a_, said.row, said.fields),
             in_b = touches(touched_b_, said.row, said.fields);
  const auto all = of_row_.find(said.row);
  const bool same_before = all == of_row_.end();
  if (same_before && in_a && !in_b) return Take::A;
  if (same_before && in_b && !in_a) return Take::B;
  const std::string id = name + "/" + (table ? said.row + "/" : "") + said.name;
  std::vector<Take> takes = {Take::A};
  if (said.name != "results") takes.push_back(Take::B);  // they go with their scans: A's stay
  stamp(said.a, touched_a_, said);
  stamp(said.b, touched_b_, said);
  const std::string who = !table                     ? said.name
                          : rows_.contains(said.row) ? wholeName(*table, said.row)
                                                     : std::string();
  const std::string field = table ? said.name : std::string();
  const Take take =
      same_before ? settle({id, name, who, field, said.a, said.b, takes}) : all->second;
  // The history ends with what holds, and tells the next merge that this one has seen both.
  const std::int64_t row = rows_.contains(said.row) ? rows_.at(said.row) : table ? 1 : 0;
  if (take == Take::B) remember(name, row, said.field, said.told_a, said.told_b);
  if (take == Take::A) remember(name, row, said.field, said.told_b, said.told_a);
  return take;
}

const Choice* Merging::choiceOf(const std::string& conflict_id) const {
  const auto found = settled_.find(conflict_id);
  return found == settled_.end() ? nullptr : &found->second;
}

Take Merging::settle(Conflict conflict) {
  if (const auto known = takes_.find(conflict.id); known != takes_.end()) return known->second;
  const Choice* choice = choiceOf(conflict.id);
  if (choice) {
    const bool calls_one = !choice->number.empty() && choice->take != Take::Number;
    if (!conflict.offers(choice->take) || (calls_one && !conflict.isOfTwoSherds()))
      store::refuse(message(
          "The conflict %1 (%2) cannot be settled with '%3'; nothing was merged. Choose one "
          "of the ways that the list of conflicts offers.",
          conflict.id, conflict.name, nameOf(choice->take)));
    conflict.settled = true;
  }
  const Take take = choice ? choice->take : Take::A;
  takes_[conflict.id] = take;
  outcome_.conflicts.push_back(std::move(conflict));
  return take;
}

}  // namespace ostraka::merge
