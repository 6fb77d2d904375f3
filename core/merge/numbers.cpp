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

// Records of one sherd may know each other through those of other projects only. What is known is
// kept: later a project may come that has one of these records, and no word on the others.
void Merging::readSameSherds() {
  std::unordered_map<std::string, std::vector<std::string>> same;
  for (const Content* content : {static_cast<const Content*>(&a_), &b_})
    for (const auto& [key, value] : content->settings) {
      if (!key.starts_with(kSameRow)) continue;
      const std::string other = key.substr(std::string_view(kSameRow).size());
      same[other].push_back(value);
      same[value].push_back(other);
    }
  const Table &mine = a_.table("sherd"), &theirs = b_.table("sherd");
  std::set<std::string> found;
  for (const Row& row : theirs.rows) {
    if (mine.find(row.id) || !same.contains(row.id)) continue;
    std::vector<std::string> reached = {row.id};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const std::string id = reached[i];
      // Two sherds of which only one project says that they are one stay two.
      if (mine.find(id) && !theirs.find(id) && found.insert(id).second) {
        alias_[row.id] = id;
        database_.run("INSERT OR IGNORE INTO setting VALUES (?, ?)", kSameRow + row.id, id);
        break;
      }
      for (const std::string& next : same[id])
        if (std::ranges::find(reached, next) == reached.end()) reached.push_back(next);
    }
  }
}

void Merging::noteNumbers() {
  for (const std::vector<Value>& given : a_.given)
    number_owner_[slugOfNumber(given[2].value_or(""))] = given[3].value_or("");
  for (const Row& theirs : b_.table("sherd").rows) sherds_of_b_[canonicalId(theirs.id)] = &theirs;
  // Each project entered the same sherd, as a person says: from here on its two records are one row
  // under two uuids, and what they say differently is settled field by field.
  const Table& table = b_.table("sherd");
  for (const Row& theirs : table.rows) {
    const Choice* choice = choiceOf(kTwoSherds + theirs.id);
    const auto owner = number_owner_.find(slugOfNumber(numberInB(theirs.id)));
    if (!choice || choice->take != Take::One || owner == number_owner_.end()) continue;
    const std::string& mine = owner->second;
    const Conflict conflict = twoSherds(mine, theirs.id, canonical(table, theirs));
    if (!conflict.offers(Take::One)) continue;
    settle(conflict);
    alias_[theirs.id] = mine;
    sherds_of_b_.erase(theirs.id);
    sherds_of_b_[mine] = &theirs;
    database_.run("INSERT OR IGNORE INTO setting VALUES (?, ?)", kSameRow + theirs.id, mine);
    remember("sherd", rows_.at(mine), "one_with", "", theirs.id);
  }
  for (const Event& event : b_.events)
    if (event.table == "sherd" && event.field == "number")
      for (const std::string* number : {&event.old_value, &event.new_value})
        numbers_in_b_.emplace(slugOfNumber(*number), canonicalId(event.row));
}

// values: of the sherd of B, as it would be in A. The two can be one, but not where one of the
// projects knows both as sherds of their own, nor where both were photographed: the scans of two
// batches are those of two sherds.
Conflict Merging::twoSherds(const std::string& mine, const std::string& theirs,
                            const Values& values) const {
  const Table& table = a_.table("sherd");
  const std::size_t number = table.column("number"), state = table.column("state"),
                    front = table.column("front");
  Conflict conflict{
      kTwoSherds + theirs,      "sherd",           values[number].value_or(""), "number", {},
      sherdSeen(table, values), {Take::A, Take::B}};
  const Row* own = table.find(mine);
  if (!own) return conflict;
  const Values& a = own->values;
  conflict.a = sherdSeen(table, a);
  const bool apart = sherds_of_b_.contains(mine) || table.find(theirs);
  if (!apart && a[state] == "numbered" && values[state] == "numbered" &&
      !(a[front] && values[front]) &&
      slugOfNumber(a[number].value_or("")) == slugOfNumber(values[number].value_or("")))
    conflict.takes.push_back(Take::One);
  return conflict;
}

// What a person calls the sherd that loses its number; empty where nobody says, or where it is
// called so anyway.
std::string Merging::freeNumber(const Conflict& conflict, const std::string& loser) const {
  const Choice* choice = choiceOf(conflict.id);
  if (!choice || choice->number.empty()) return {};
  const std::string wanted = store::valueOrThrow(newName(conflict.id, *choice));
  const bool known = rows_.contains(loser);
  if (known &&
      (wanted == numberNow(loser) || (choice->take == Take::B && wanted == numberInB(loser))))
    return {};
  const auto owner = number_owner_.find(slugOfNumber(wanted));
  if (owner != number_owner_.end() && owner->second != loser)
    store::refuse(
        message("The number %1 was assigned before and is never reused; nothing was merged. Settle "
                "the conflict %2 with another number.",
                wanted, conflict.id));
  return wanted;
}

std::string Merging::numberNow(const std::string& sherd) const {
  return database_.sql("SELECT number FROM sherd WHERE row = ?", rows_.at(sherd))
      .one<std::string>();
}

std::string Merging::numberInB(const std::string& sherd) const {
  const auto theirs = sherds_of_b_.find(sherd);
  return theirs == sherds_of_b_.end()
             ? std::string()
             : theirs->second->values[b_.table("sherd").column("number")].value_or("");
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
  return winsNumber(sherd, table, values);
}

// Whatever A called it since.
bool Merging::winsNumber(const std::string& sherd, const Table& table, Values& values) {
  const std::string number = values[table.column("number")].value_or("");
  const auto owner = number_owner_.find(slugOfNumber(number));
  if (owner == number_owner_.end() || owner->second == sherd) return true;
  const std::string other_sherd = owner->second;
  const bool bears = slugOfNumber(numberNow(other_sherd)) == owner->first;
  // B calls it otherwise, and nobody in A had a word on that since.
  const bool leaves = bears && sherds_of_b_.contains(other_sherd) &&
                      slugOfNumber(numberInB(other_sherd)) != owner->first &&
                      !lost_numbers_.contains(other_sherd) &&
                      touches(touched_b_, other_sherd, {"number"}) &&
                      !touches(touched_a_, other_sherd, {"number", "state", "void_reason"});
  if (leaves) takeNumberAway(other_sherd, {});
  // Settled before: B knows that the other sherd had the number, and it is called otherwise by now.
  if (leaves || (!bears && numbers_in_b_.contains(*owner))) return true;
  const Conflict conflict = twoSherds(other_sherd, sherd, values);
  contested_[conflict.id] = other_sherd;
  const Take take = settle(conflict);
  if (take == Take::B) {
    if (bears) takeNumberAway(other_sherd, freeNumber(conflict, other_sherd));
    return true;
  }
  const std::string wanted = freeNumber(conflict, sherd);
  if (wanted.empty()) {
    lost_numbers_.insert(sherd);
    return false;
  }
  new_numbers_[sherd] = {number, wanted};
  values[table.column("number")] = wanted;
  values[table.column("number_sort")] = store::sortKey(wanted);
  return true;
}

void Merging::takeNumberAway(const std::string& sherd, const std::string& wanted) {
  const store::SherdRow row{rows_.at(sherd)};
  const records::SherdRecord loser = store::valueOrThrow(sherds::Sherds(projects_.a).get(row));
  taken_away_.push_back(
      {sherd, loser.number, loser.state == records::SherdState::Numbered, wanted});
  sherds::setNumber(projects_.a, loser, {});
  changed_sherds_.insert(row.value);
}

// A sherd whose number went to another is called as a person says, or takes the one that it has in
// B, which may stand on its label: if a third one bears that, a person says whose it is.
void Merging::renumberLosers() {
  const Table& table = b_.table("sherd");
  // B's number came in its turn.
  std::erase_if(taken_away_, [&](const TakenNumber& one) { return !numberNow(one.sherd).empty(); });
  for (std::size_t i = 0; i < taken_away_.size(); ++i) {  // one may take it from the next
    const TakenNumber loser = taken_away_[i];
    const std::int64_t row = rows_.at(loser.sherd);
    remember("sherd", row, "number", loser.number, "");
    const std::string number = loser.wanted.empty() ? numberInB(loser.sherd) : loser.wanted;
    if (!loser.numbered || number.empty()) continue;
    Values values(table.columns.size());
    if (loser.wanted.empty()) {
      values = canonical(table, *sherds_of_b_.at(loser.sherd));
      if (!winsNumber(loser.sherd, table, values)) continue;
    } else {
      values[table.column("number")] = number;
      values[table.column("number_sort")] = store::sortKey(number);
    }
    values[table.column("state")] = "numbered";
    std::vector<std::pair<std::size_t, Value>> changes;
    for (const char* name : {"number", "number_sort", "state"})
      changes.emplace_back(table.column(name), values[table.column(name)]);
    write(table, row, changes);
    remember("sherd", row, "number", "", number);
    claimNumber(loser.sherd, values[table.column("number")].value_or(""));
  }
}

void Merging::claimNumber(const std::string& sherd, const std::string& number) {
  if (number.empty()) return;
  number_owner_[slugOfNumber(number)] = sherd;
  claimed_[sherd] = number;
}

void Merging::addGivenNumbers() {
  constexpr const char* kAdd =
      " INTO given_number (number_key, slug_key, number, sherd, at) VALUES (?1, ?2, ?3, ?4, ?5)";
  for (const std::vector<Value>& given : b_.given) {
    const std::string number = given[2].value_or("");
    const std::string sherd = canonicalId(given[3].value_or(""));
    if (!rows_.contains(sherd)) continue;
    // One that was given in both projects stays with the sherd of A, or goes to the one that a
    // person chose.
    database_.run(std::string("INSERT OR IGNORE") + kAdd, store::uniqueKey(number),
                  slugOfNumber(number), number, rows_.at(sherd), given[4]);
  }
  for (const auto& [sherd, number] : claimed_)
    database_.run(std::string("INSERT") + kAdd +
                      " ON CONFLICT DO UPDATE SET number_key = ?1, number = ?3, sherd = ?4",
                  store::uniqueKey(number), slugOfNumber(number), number, rows_.at(sherd),
                  projects_.a.now());
  for (const auto& [sherd, numbers] : new_numbers_)
    remember("sherd", rows_.at(sherd), "number", numbers.first, numbers.second);
}

// Sherds whose number went to another and that have none in B get the next one that is free.
void Merging::assignNumbers() {
  const Table& sherds = b_.table("sherd");
  std::vector<store::SherdRow> rows;
  std::vector<std::pair<std::string, std::string>> before;  // sherd, number
  for (const TakenNumber& loser : taken_away_) {
    before.emplace_back(loser.sherd, loser.number);
    if (loser.numbered && numberNow(loser.sherd).empty()) rows.push_back({rows_.at(loser.sherd)});
  }
  for (const std::string& id : lost_numbers_) {
    const std::string number = numberInB(id);
    remember("sherd", rows_.at(id), "number", number, numberNow(id));
    if (a_.table("sherd").find(id)) continue;
    before.emplace_back(id, number);
    if (sherds_of_b_.at(id)->values[sherds.column("state")] == "numbered")
      rows.push_back({rows_.at(id)});
  }
  if (outcome_.unsettled()) return proposeNumbers();
  if (!rows.empty()) store::valueOrThrow(sherds::Numbers(projects_.a).assign(rows, provenance_));
  for (const auto& [sherd, numbers] : new_numbers_) before.emplace_back(sherd, numbers.first);
  for (const auto& [sherd, number] : before)
    if (const std::string now = numberNow(sherd); !now.empty())
      outcome_.new_numbers.try_emplace(sherd, number, now);
}

// Each conflict has numbers of its own, so that a person may settle them in any way. They are kept
// from each other by being given, which is taken back with all else, as a conflict is open.
void Merging::proposeNumbers() {
  const sherds::Sherds all(projects_.a);
  const auto next = [&](store::SherdRow row) -> std::string {
    const auto numbers = sherds::Numbers(projects_.a).propose(std::span(&row, 1));
    if (!numbers) return {};  // the scheme has none for it: a person types one
    sherds::giveNumber(projects_.a, store::valueOrThrow(all.get(row)), numbers->front());
    return numbers->front();
  };
  for (Conflict& conflict : outcome_.conflicts) {
    if (conflict.settled || !conflict.isOfTwoSherds()) continue;
    const std::string theirs = conflict.id.substr(std::string_view(kTwoSherds).size());
    const std::string& mine = contested_.at(conflict.id);
    const store::SherdRow other{rows_.at(theirs)};
    conflict.new_b = numberNow(theirs);
    conflict.new_a = numberInB(mine);
    const std::string now = numberNow(mine);
    if (conflict.new_a.empty() && slugOfNumber(now) != slugOfNumber(conflict.name))
      conflict.new_a = now;
    if (!conflict.new_b.empty()) continue;
    conflict.new_b = next(other);
    if (!conflict.new_a.empty()) continue;
    database_.run(
        "UPDATE sherd SET (context, bag, batch) = (SELECT context, bag, batch FROM sherd WHERE row "
        "= ?) WHERE row = ?",
        rows_.at(mine), other);
    conflict.new_a = next(other);
  }
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
    // One of a record that A made one with another sherd stays with that.
    if (b &&
        database_.sql("SELECT 1 FROM measurement WHERE id = ? AND sherd <> ?", b->id, row).next())
      continue;
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
  if (places_changed_ || places_.changed()) {
    const auto all = database_.sql("SELECT row FROM sherd").all<std::int64_t>();
    changed_sherds_.insert(all.begin(), all.end());
  }
  for (const std::int64_t row : changed_sherds_)
    catalogue::searchAnew(database_, store::SherdRow{row});
}

}  // namespace ostraka::merge
