// What a person sees of a conflict: names instead of ids, and who entered what when.
#include <cstdlib>

#include "merge/merging.h"
#include "store/values.h"

namespace ostraka::merge {
namespace {

bool holdsTerms(const std::string& column) {
  return column == "part" || column == "decoration" || column == "condition";
}

std::int64_t numberIn(const Value& value) {
  return std::strtoll(value.value_or("0").c_str(), nullptr, 10);
}

}  // namespace

void Merging::label(const Table& table, const std::string& id, const Values& values) {
  for (const char* name : {"number", "code", "initials", "name", "path"})
    if (const std::size_t i = table.column(name); i < table.columns.size())
      if (!values[i].value_or("").empty()) {
        labels_[id] = *values[i];
        return;
      }
}

std::string Merging::labelOf(const std::string& id) const {
  const auto found = labels_.find(id);
  return found == labels_.end() ? id : found->second;
}

// A place with those that it lies in: ARM1-T3-0012. A sherd without a number by its front.
std::string Merging::wholeName(const Table& table, const std::string& id) const {
  const Row* row = table.find(id);
  if (!row) row = b_.table(table.name).find(id);
  std::vector<const char*> within;
  if (table.name == "trench" || table.name == "context" || table.name == "bag")
    within = {"context", "trench", "site"};
  if (table.name == "sherd" && !labels_.contains(id)) within = {"front"};
  if (table.name == "scan") within = {"batch"};
  for (const char* name : within)
    if (const std::size_t i = table.column(name); row && i < table.columns.size())
      if (const Value& outer = row->values[i]) {
        const std::string whole = wholeName(a_.table(table.refers[i]), canonicalId(*outer));
        return table.name == "sherd" ? whole : whole + "-" + labelOf(id);
      }
  return labelOf(id);
}

std::string Merging::shown(const Table& table, std::size_t column, const Value& value) const {
  if (!value) return {};
  if (holdsTerms(table.columns[column])) return store::joinTerms(store::termsFromJson(*value));
  if (table.refers[column].empty()) return *value;
  return wholeName(a_.table(table.refers[column]), *value);
}

Version Merging::versionOf(const Table& table, const Unit& unit, const Values& values) const {
  if (table.name == "batch" && unit.name == "results") return computed(table, values);
  Version version;
  for (const std::size_t i : unit.columns) {
    const std::string& column = table.columns[i];
    const std::string text = shown(table, i, values[i]);
    if (!text.empty() && !column.ends_with("_key") && column != "number_sort")
      version.values.emplace_back(column, text);
  }
  return version;
}

// Of two sherds with one number: what tells them apart.
Version Merging::sherdSeen(const Table& table, const Values& values) const {
  Version version;
  for (const char* field : {"front", "context", "part", "ware", "note"}) {
    const std::size_t i = table.column(field);
    if (const std::string text = shown(table, i, values[i]); !text.empty() && text != "[]")
      version.values.emplace_back(field, text);
  }
  stampRow(version, table, values, "created_by", "created_at");
  return version;
}

// Results are told apart by when they were computed.
Version Merging::computed(const Table& batches, const Values& values) {
  Version version;
  if (const Value& program = values[batches.column("program")]; !program.value_or("").empty())
    version.values.emplace_back("program", *program);
  version.at_ms = numberIn(values[batches.column("ended_ms")]);
  return version;
}

std::string Merging::initialsOf(const std::string& person) const {
  const auto found = labels_.find(canonicalId(person));
  return found == labels_.end() ? std::string() : found->second;
}

void Merging::stamp(Version& version, const Touched& touched, const Said& said) const {
  const auto row = touched.find(said.row);
  if (row == touched.end()) return;
  for (const std::string& field : said.fields)
    if (const auto last = row->second.find(field); last != row->second.end())
      if (last->second->at >= version.at_ms) {
        version.at_ms = last->second->at;
        version.by = initialsOf(last->second->person);
      }
}

// By the row itself, where it is younger than what the version has.
void Merging::stampRow(Version& version, const Table& table, const Values& values,
                       const char* person, const char* at) const {
  const std::int64_t at_ms = numberIn(values[table.column(at)]);
  if (at_ms < version.at_ms) return;
  version.at_ms = at_ms;
  version.by = initialsOf(values[table.column(person)].value_or(""));
}

}  // namespace ostraka::merge
