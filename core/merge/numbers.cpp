// Sherds: whose a number is, which measurement counts, and which sherds join.
#include "sherds/numbers.h"

#include <algorithm>
#include <map>

#include "catalogue/history.h"
#include "catalogue/search.h"
#include "merge/merging.h"
#include "merge/told.h"
#include "records/sherd.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::merge {
namespace {

// Numbers with one file name are one number: they differ in case or punctuation at most.
std::string slugOfNumber(const std::string& number) {
  return number.empty() ? std::string() : store::uniqueKey(store::slug(number));
}

// What a merge joined or parted is no word of a person: a later one asks who said so.
constexpr const char* kMergeSource = "merge";

// Of one project's history, by pair. It names sherds by the numbers that they had then.
template <class Canonical>
Told toldJoins(const Content& content, const std::vector<const Event*>& since,
               Canonical canonical) {
  std::unordered_map<std::string, std::string> by_number;
  for (const std::vector<Value>& given : content.given)
    by_number[slugOfNumber(given[2].value_or(""))] = given[3].value_or("");
  Told told;
  for (const Event* event : since)
    if (event->field == "joins" && event->source != kMergeSource)
      tellMembers(*event, [&](const std::string& name, bool added) {
        const auto numbered = by_number.find(slugOfNumber(name));
        const std::string sherd = canonical(event->row),
                          other = canonical(numbered == by_number.end() ? name : numbered->second);
        told[std::minmax(sherd, other)] = added;
      });
  return told;
}

}  // namespace

void Merging::readGivenNumbers() {
  for (const std::vector<Value>& given : a_.given)
    number_owner_[slugOfNumber(given[2].value_or(""))] = given[3].value_or("");
}

void Merging::noteNumbersOfB() {
  for (const Event& event : b_.events)
    if (event.table == "sherd" && event.field == "number")
      for (const std::string* number : {&event.old_value, &event.new_value})
        numbers_in_b_.emplace(slugOfNumber(*number), canonicalId(event.row));
}

// False where another sherd of A keeps the number. values: of the sherd as it would be.
bool Merging::takesNumber(const std::string& sherd, const Table& table, Values& values) {
  const std::string number = values[table.column("number")].value_or("");
  if (number.empty()) return true;
  const Row* mine = a_.table("sherd").find(sherd);
  if (mine && mine->values[table.column("number")] == number) return true;
  // What A called otherwise since is A's word on it.
  if (mine && touches(touched_a_, sherd, {"number"}) && !touches(touched_b_, sherd, {"number"}))
    return true;
  const auto owner = number_owner_.find(slugOfNumber(number));
  if (owner == number_owner_.end() || owner->second == sherd) return true;
  const std::int64_t owner_row = rows_.at(owner->second);
  const auto now =
      database_.sql("SELECT number FROM sherd WHERE row = ?", owner_row).one<std::string>();
  const bool bears = slugOfNumber(now) == owner->first;
  // Settled before: B knows that the other sherd had the number, and it is called otherwise by now.
  if (!bears && numbers_in_b_.contains(*owner)) return true;
  const std::string conflict = "number/" + sherd;
  const Row* other = a_.table("sherd").find(owner->second);
  const Take take = settle({conflict,
                            "sherd",
                            number,
                            "number",
                            other ? sherdSeen(table, other->values) : Version(),
                            sherdSeen(table, values),
                            {Take::A, Take::B, Take::Number}});
  if (take == Take::Number) {
    const std::string wanted = store::valueOrThrow(newName(conflict, *choiceOf(conflict)));
    if (number_owner_.contains(slugOfNumber(wanted)))
      store::refuse(message(
          "The number %1 was assigned before and is never reused; nothing was merged. Settle "
          "the conflict number/%2 with another number.",
          wanted, sherd));
    new_numbers_[sherd] = {number, wanted};
    values[table.column("number")] = wanted;
    values[table.column("number_sort")] = store::sortKey(wanted);
    return true;
  }
  if (take == Take::A) lost_numbers_.insert(sherd);
  if (take == Take::B && bears) takeNumberAway(owner_row, now);
  return take == Take::B;
}

void Merging::takeNumberAway(std::int64_t sherd, const std::string& number) {
  const records::SherdRecord loser =
      store::valueOrThrow(sherds::Sherds(projects_.a).get(store::SherdRow{sherd}));
  if (loser.state == records::SherdState::Numbered) to_number_.push_back(sherd);
  sherds::setNumber(projects_.a, loser, {});
  remember("sherd", sherd, "number", number, "");
}

void Merging::claimNumber(const std::string& sherd, const std::string& number) {
  if (number.empty()) return;
  number_owner_[slugOfNumber(number)] = sherd;
  claimed_[sherd] = number;
}

void Merging::addGivenNumbers() {
  std::unordered_map<std::string, const std::vector<Value>*> of_b;
  for (const std::vector<Value>& given : b_.given) {
    const std::string number = given[2].value_or(""), key = store::uniqueKey(number);
    of_b[key] = &given;
    const std::string sherd = canonicalId(given[3].value_or(""));
    if (!rows_.contains(sherd)) continue;
    // One that was given in both projects stays with the sherd of A, or goes to the one that a
    // person chose.
    database_.run("INSERT OR IGNORE INTO given_number VALUES (?, ?, ?, ?, ?, ?, ?)", key,
                  slugOfNumber(number), number, rows_.at(sherd), given[4], given[5], given[6]);
  }
  for (const auto& [sherd, number] : claimed_) {
    const std::string key = store::uniqueKey(number);
    const auto found = of_b.find(key);
    const bool counted = found != of_b.end();
    database_.run(
        "INSERT INTO given_number VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7) ON CONFLICT DO UPDATE SET "
        "number_key = ?1, number = ?3, sherd = ?4",
        key, slugOfNumber(number), number, rows_.at(sherd), projects_.a.now(),
        counted ? (*found->second)[5].value_or("") : std::string(),
        counted ? (*found->second)[6] : Value());
  }
  for (const auto& [sherd, numbers] : new_numbers_)
    remember("sherd", rows_.at(sherd), "number", numbers.first, numbers.second);
}

// Sherds whose number went to another get the next one that is free.
void Merging::assignNumbers() {
  const Table& sherds = b_.table("sherd");
  for (const std::string& id : lost_numbers_) {
    const Row* mine = a_.table("sherd").find(id);
    const Row* theirs = sherds.find(id);
    const std::string number =
        theirs ? theirs->values[sherds.column("number")].value_or("") : std::string();
    const std::string now =
        mine ? mine->values[sherds.column("number")].value_or("") : std::string();
    remember("sherd", rows_.at(id), "number", number, now);
    if (!mine && theirs && theirs->values[sherds.column("state")] == "numbered")
      to_number_.push_back(rows_.at(id));
  }
  if (to_number_.empty() || outcome_.unsettled()) return;
  std::vector<store::SherdRow> rows;
  for (const std::int64_t row : to_number_) rows.push_back({row});
  store::valueOrThrow(sherds::Numbers(projects_.a).assign(rows, provenance_));
}

void Merging::mergeMeasurements() {
  const Table &mine = a_.table("measurement"), &theirs = b_.table("measurement");
  const std::size_t sherd = theirs.column("sherd"), kind = theirs.column("kind"),
                    current = theirs.column("current"), value = theirs.column("value"),
                    unit = theirs.column("unit"), method = theirs.column("method");
  // By sherd and kind: what counts in each project.
  std::map<std::pair<std::string, std::string>, std::pair<const Row*, const Row*>> counts;
  for (const Row& row : mine.rows)
    if (row.values[current] == "1") counts[{*row.values[sherd], *row.values[kind]}].first = &row;
  for (const Row& row : theirs.rows)
    if (row.values[current] == "1")
      counts[{canonicalId(*row.values[sherd]), *row.values[kind]}].second = &row;
  const auto version = [&](const Row* row) {
    Version made;
    if (!row) return made;
    made.values = {{*row->values[kind], *row->values[value]}, {"method", *row->values[method]}};
    stampRow(made, theirs, row->values, "person", "at");
    return made;
  };
  const auto words = [&](const Row* row) {
    return row ? *row->values[value] + " " + *row->values[unit] + ", " + *row->values[method]
               : std::string();
  };
  // The history names values; their methods only where nothing else differs.
  const auto toldOf = [&](const Row* row, const Row* other) {
    if (!row) return std::string();
    return other && other->values[value] == row->values[value] ? words(row) : *row->values[value];
  };
  for (const auto& [of, rows] : counts) {
    const auto& [a, b] = rows;
    const auto& [id, name] = of;
    if (records::unitOf(name).empty())
      store::refuse(message("There is no measurement of this kind."), name);
    if ((a && b && a->id == b->id) || !rows_.contains(id)) continue;
    // A sherd that only A has, or whose measures B never had.
    if (!b && !touches(touched_b_, id, {name})) continue;
    const bool told = touches(touched_a_, id, {name}) || touches(touched_b_, id, {name});
    Take take = Take::B;
    if (a && b && words(a) == words(b))
      take = Take::A;
    else if (told || (a && b))
      take = decide(&a_.table("sherd"),
                    {name, id, {name}, version(a), version(b), name, toldOf(a, b), toldOf(b, a)});
    if (take != Take::B) continue;
    const std::int64_t row = rows_.at(id);
    if (a) database_.run("UPDATE measurement SET current = 0 WHERE id = ?", a->id);
    if (b) database_.run("UPDATE measurement SET current = 1 WHERE id = ?", b->id);
    database_.run("UPDATE sherd_measure SET " + name + " = ? WHERE sherd = ?",
                  b ? b->values[value] : Value(), row);
    changed_sherds_.insert(row);
  }
}

// A set of pairs: what one of the projects joined or parted since holds; a pair that one parted and
// the other joined stays.
void Merging::mergeJoins() {
  std::set<std::pair<std::string, std::string>> mine(a_.joins.begin(), a_.joins.end()), theirs;
  for (const auto& [sherd, other] : b_.joins)
    theirs.emplace(canonicalId(sherd), canonicalId(other));
  const auto canonical = [&](const std::string& id) { return canonicalId(id); };
  const Told in_a = toldJoins(a_, since_a_["sherd"], canonical),
             in_b = toldJoins(b_, since_b_["sherd"], canonical);
  const auto parted = [](const Told& here, const Told& there,
                         const std::pair<std::string, std::string>& pair) {
    return isGone(here, there, std::minmax(pair.first, pair.second));
  };
  const auto joinsOf = [&](std::int64_t sherd) {
    return store::joinTerms(
        database_
            .sql("SELECT iif(s.number = '', s.id, s.number) FROM sherd_join j JOIN sherd s ON "
                 "s.row = j.other WHERE j.sherd = ? ORDER BY s.number_sort, s.row",
                 sherd)
            .all<std::string>());
  };
  std::map<std::int64_t, std::string> before;
  for (const auto& pair : theirs) {
    if (mine.contains(pair) || parted(in_a, in_b, pair)) continue;
    if (!rows_.contains(pair.first) || !rows_.contains(pair.second) || pair.first == pair.second)
      continue;
    const std::int64_t sherd = rows_.at(pair.first);
    if (!before.contains(sherd)) before[sherd] = joinsOf(sherd);
    database_.run("INSERT OR IGNORE INTO sherd_join VALUES (?, ?)", rows_.at(pair.first),
                  rows_.at(pair.second));
  }
  for (const auto& pair : mine) {
    if (theirs.contains(pair) || !parted(in_b, in_a, pair)) continue;
    const std::int64_t sherd = rows_.at(pair.first);
    if (!before.contains(sherd)) before[sherd] = joinsOf(sherd);
    database_.run("DELETE FROM sherd_join WHERE sherd = ? AND other = ?", sherd,
                  rows_.at(pair.second));
  }
  for (const auto& [sherd, joins] : before)
    catalogue::remember(projects_.a, {provenance_.person, kMergeSource, provenance_.why}, "sherd",
                        sherd, "joins", joins, joinsOf(sherd));
}

void Merging::searchAnew() {
  if (places_changed_) {
    const auto all = database_.sql("SELECT row FROM sherd").all<std::int64_t>();
    changed_sherds_.insert(all.begin(), all.end());
  }
  for (const std::int64_t row : changed_sherds_)
    catalogue::searchAnew(database_, store::SherdRow{row});
}

}  // namespace ostraka::merge
