// Places that a person found to be one place: in whichever project that was said, all that lies in
// them comes together. What both projects said is settled by the history, as of any field.
#include "merge/joined_places.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "catalogue/renamed_places.h"
#include "store/database.h"

namespace ostraka::merge {
namespace {

using catalogue::PlaceKind;

constexpr PlaceKind kKinds[] = {PlaceKind::Trench, PlaceKind::Context, PlaceKind::Bag};

std::optional<PlaceKind> kindOf(const std::string& table) {
  for (const PlaceKind kind : kKinds)
    if (table == nameOf(kind)) return kind;
  return {};
}

std::string keyColumn(const std::string& table) {
  return table == "trench" ? "code_key" : "number_key";
}

// Of two places with one name, which are one place: the other one beside it.
std::string besideIt(const std::string& table) {
  const std::string within = table == "trench"    ? "site"
                             : table == "context" ? "site, ifnull(trench, 0)"
                                                  : "context";
  return "SELECT row, id FROM " + table + " WHERE one_with IS NULL AND id <> ?1 AND " +
         keyColumn(table) + " = ?2 AND (" + within + ") = (SELECT " + within + " FROM " + table +
         " WHERE id = ?1)";
}

}  // namespace

std::string JoinedPlaces::now(const std::string& id) const {
  const auto found = now_.find(id);
  return found == now_.end() ? id : found->second;
}

// The key that stands in its place until all are known: with a blank, which no name's key has.
std::string JoinedPlaces::heldKey(const std::string& table, const Value& key, bool came_by_join,
                                  const std::string& id) {
  names_.push_back({table, id, key.value_or(""), came_by_join});
  return "held " + std::to_string(rows_.contains(id) ? rows_.at(id) : 0) + " " +
         std::to_string(names_.size());
}

// Where a place gets another name, comes to another place, or is one of its own again.
void JoinedPlaces::hold(const Table& table, std::int64_t row,
                        std::vector<std::pair<std::size_t, Value>>& changes) {
  const std::size_t one_with = table.column("one_with");
  if (one_with == table.columns.size()) return;
  const std::size_t key = table.column(table.unique.back());
  const Row& mine = content_.table(table.name).rows[content_.table(table.name).by_row.at(row)];
  Value name = mine.values[key];
  bool names = false;
  for (const auto& [i, value] : changes) {
    names |=
        i == one_with || std::ranges::find(table.unique, table.columns[i]) != table.unique.end();
    if (i == key) name = value;
  }
  if (!names) return;
  std::erase_if(changes, [&](const auto& change) { return change.first == key; });
  changes.emplace_back(key, heldKey(table.name, name, false, mine.id));
}

void JoinedPlaces::sort(const Table& table, std::vector<const Row*>& rows) {
  const std::size_t one_with = table.column("one_with");
  if (one_with == table.columns.size()) return;
  const auto depthOf = [&](const Row* row) {
    int depth = 0;
    for (; row && row->values[one_with] && depth < 100; ++depth)
      row = table.find(*row->values[one_with]);
    return depth;
  };
  std::ranges::stable_sort(rows, {}, depthOf);
}

// Places of one name are one place. The one that came from elsewhere goes, else the younger one: in
// each project and order the same.
void JoinedPlaces::settleNames() {
  const std::vector<Name> names = std::exchange(names_, {});
  for (const Name& name : names) {
    const std::string set = "UPDATE " + name.table + " SET ";
    const bool live =
        database_.sql("SELECT 1 FROM " + name.table + " WHERE id = ? AND one_with IS NULL", name.id)
            .next();
    std::string other;
    std::int64_t row = 0;
    if (live) database_.sql(besideIt(name.table), name.id, name.key).read(row, other);
    if (!other.empty()) {
      const bool other_came = came_by_join_.contains(other);
      const bool goes = name.came_by_join != other_came ? name.came_by_join : name.id > other;
      const std::string& gone = goes ? name.id : other;
      const std::string& stays = goes ? other : name.id;
      database_.run(set + "one_with = ? WHERE id = ?", rows_.at(stays), gone);
      changed_ = true;
    }
    database_.run(set + keyColumn(name.table) + " = ? WHERE id = ?", name.key, name.id);
  }
}

// Each project said that its place is the other's: the older one stays.
void JoinedPlaces::breakCircles(const std::string& table) {
  std::map<std::int64_t, std::pair<std::string, std::int64_t>> all;
  store::Statement rows =
      database_.sql("SELECT row, id, one_with FROM " + table + " WHERE one_with IS NOT NULL");
  std::int64_t row = 0, other = 0;
  for (std::string id; rows.read(row, id, other);) all[row] = {id, other};
  for (const auto& [start, place] : all) {
    std::vector<std::int64_t> circle = {start};
    while (all.contains(circle.back())) {
      const std::int64_t next = all.at(circle.back()).second;
      if (next == start) break;
      if (std::ranges::find(circle, next) != circle.end()) break;
      circle.push_back(next);
    }
    if (!all.contains(circle.back()) || all.at(circle.back()).second != start) continue;
    const auto oldest =
        *std::ranges::min_element(circle, {}, [&](std::int64_t one) { return all.at(one).first; });
    if (oldest != start) continue;
    const auto key =
        database_.sql("SELECT " + keyColumn(table) + " FROM " + table + " WHERE row = ?", start)
            .one<std::string>();
    database_.run(
        "UPDATE " + table + " SET one_with = NULL, " + keyColumn(table) + " = ? WHERE row = ?",
        heldKey(table, key, false, place.first), start);
  }
  settleNames();
}

// After a table of places: what still lies in one that is another by now comes to that one, and
// what A and B say of it is of that one.
void JoinedPlaces::settle(const Table& table, std::vector<Deferred>& deferred) {
  if (!kindOf(table.name)) return;
  std::erase_if(deferred, [&](const Deferred& one) {
    if (one.table != table.name || one.column != "one_with" || !rows_.contains(one.id))
      return false;
    database_.run("UPDATE " + table.name + " SET one_with = ? WHERE row = ?", rows_.at(one.id),
                  one.row);
    return true;
  });
  settleNames();
  breakCircles(table.name);
  std::vector<std::pair<std::int64_t, std::string>> gone;
  store::Statement rows =
      database_.sql("SELECT row, id FROM " + table.name + " WHERE one_with IS NOT NULL");
  std::int64_t row = 0;
  for (std::string id; rows.read(row, id);) gone.emplace_back(row, id);
  for (const auto& [of, id] : gone) bringTogether(table, id, of);
  for (Table& mine : content_.tables)
    for (std::size_t i = 0; i < mine.columns.size(); ++i) {
      if (mine.refers[i] != table.name || mine.name == table.name) continue;
      for (Row& one : mine.rows)
        if (one.values[i])
          if (const auto now = now_.find(*one.values[i]); now != now_.end())
            one.values[i] = now->second;
    }
}

void JoinedPlaces::bringTogether(const Table& table, const std::string& id, std::int64_t row) {
  const PlaceKind kind = *kindOf(table.name);
  const auto idOf = [&](const std::string& of, std::int64_t number) {
    return database_.sql("SELECT id FROM " + of + " WHERE row = ?", number).one<std::string>();
  };
  const std::int64_t into = catalogue::placeNow(a_, {kind, row});
  now_[id] = idOf(table.name, into);
  for (const catalogue::JoinedPlace& pair : catalogue::bringTogether(a_, kind, row, into)) {
    const std::string of = nameOf(pair.kind);
    for (const catalogue::Moved& moved : pair.moved)
      if (kindOf(moved.table)) came_by_join_.insert(idOf(moved.table, moved.row));
    changed_ |= !pair.moved.empty();
    if (pair.from == row && pair.kind == kind) continue;
    for (Table& mine : content_.tables)
      if (const auto found = mine.by_row.find(pair.from);
          mine.name == of && found != mine.by_row.end())
        mine.rows[found->second].values[mine.column("one_with")] = idOf(of, pair.into);
  }
}

}  // namespace ostraka::merge
