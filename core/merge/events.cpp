// What both projects did since they were one: the rows of the history that only one of them has.
#include <unordered_set>

#include "base/text.h"
#include "catalogue/history.h"
#include "merge/merging.h"
#include "merge/told.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::merge {
namespace {

std::string keyOf(const Event& event) {
  std::string key = std::to_string(event.at);
  for (const std::string* part : {&event.person, &event.row, &event.field, &event.old_value,
                                  &event.new_value, &event.why, &event.source})
    key += '\x1f' + *part;
  return key;
}

}  // namespace

std::string Merging::sameId(const std::string& id) const {
  const auto found = alias_.find(id);
  return found == alias_.end() ? id : found->second;
}

std::string Merging::canonicalId(const std::string& id) const {
  return places_.now(sameId(id));
}

void Merging::compareHistories(const std::string& table) {
  const auto canonicalIn = [&](const Event& event) {
    Event known = event;
    known.person = canonicalId(event.person);
    known.row = canonicalId(event.row);
    if (!event.refers.empty())
      for (std::string* value : {&known.old_value, &known.new_value}) {
        std::vector<std::string> ids;
        for (const std::string& id : store::splitTerms(*value)) ids.push_back(canonicalId(id));
        *value = joined(ids, "; ");
      }
    return known;
  };
  std::unordered_set<std::string> mine, theirs;
  for (const Event& event : a_.events)
    if (event.table == table) mine.insert(keyOf(canonicalIn(event)));
  for (const Event& event : b_.events) {
    if (event.table != table) continue;
    Event known = canonicalIn(event);
    std::string key = keyOf(known);
    if (!mine.contains(key)) {
      touched_b_[known.row][known.field] = &event;
      since_b_[table].push_back(&event);
      new_events_[known.row].push_back(std::move(known));
    }
    theirs.insert(std::move(key));
  }
  for (const Event& event : a_.events)
    if (event.table == table && !theirs.contains(keyOf(canonicalIn(event)))) {
      touched_a_[event.row][event.field] = &event;
      since_a_[table].push_back(&event);
    }
}

void Merging::copyEvents(const std::string& row) {
  const auto found = new_events_.find(row);
  if (found == new_events_.end()) return;
  for (const Event& event : found->second) {
    const auto at = rows_.find(row);
    std::string old_value = event.old_value, new_value = event.new_value;
    if (!event.refers.empty())
      for (std::string* value : {&old_value, &new_value}) {
        std::vector<std::string> numbers;
        for (const std::string& id : store::splitTerms(*value))
          if (const auto known = rows_.find(id); known != rows_.end())
            numbers.push_back(std::to_string(known->second));
        *value = joined(numbers, "; ");
      }
    const auto person = rows_.find(event.person);
    const store::PersonRow by{person == rows_.end() ? 0 : person->second};
    const std::int64_t number = at != rows_.end()          ? at->second
                                : event.table == "project" ? std::int64_t{1}
                                                           : std::int64_t{0};
    database_.run(
        "INSERT INTO history (at, person, table_name, row, field, old, new, why, source) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
        event.at, by, event.table, number, event.field, old_value, new_value, event.why,
        event.source);
  }
  new_events_.erase(found);
}

void Merging::remember(const std::string& table, std::int64_t row, const std::string& field,
                       const std::string& old_value, const std::string& new_value) {
  catalogue::remember(projects_.a, provenance_, table.c_str(), row, field, old_value, new_value);
}

void tellMembers(const Event& event, const std::function<void(const std::string&, bool)>& tell) {
  const std::vector<std::string> older = store::splitTerms(event.old_value),
                                 newer = store::splitTerms(event.new_value);
  const auto tellThoseOf = [&](const std::vector<std::string>& all,
                               const std::vector<std::string>& but, bool added) {
    const std::unordered_set<std::string> known(but.begin(), but.end());
    for (const std::string& member : all)
      if (!known.contains(member)) tell(member, added);
  };
  tellThoseOf(older, newer, false);
  tellThoseOf(newer, older, true);
}

bool isGone(const Told& here, const Told& there,
            const std::pair<std::string, std::string>& member) {
  const auto own = here.find(member), other = there.find(member);
  return own != here.end() && !own->second && (other == there.end() || !other->second);
}

bool Merging::touches(const Touched& touched, const std::string& row,
                      const std::vector<std::string>& fields) {
  const auto found = touched.find(row);
  if (found == touched.end()) return false;
  for (const std::string& field : fields)
    if (found->second.contains(field)) return true;
  return false;
}

}  // namespace ostraka::merge
