#include "merge/units.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "files/json_text.h"

namespace ostraka::merge {
namespace {

const std::set<std::string> kStamps = {"created_at", "created_by", "updated_at",
                                       "updated_by", "revision",   "extra"};

// Which unit a column belongs to; empty: none.
std::string unitNamed(const std::string& table, const std::string& column) {
  if (kStamps.contains(column)) return {};
  static const std::map<std::string, std::map<std::string, std::string>> kNamed = {
      {"person", {{"initials_key", "initials"}}},
      {"site", {{"code_key", "code"}, {"latitude_deg", "location"}, {"longitude_deg", "location"}}},
      {"trench", {{"site", "code"}, {"code_key", "code"}}},
      {"context", {{"site", "number"}, {"trench", "number"}, {"number_key", "number"}}},
      {"bag", {{"context", "number"}, {"number_key", "number"}}},
      {"batch",
       {{"number", ""},  // names its folders, in each project
        {"state", "results"},
        {"started_ms", "results"},
        {"ended_ms", "results"},
        {"reprojection_px", "results"},
        {"scale_error_pct", "results"},
        {"scale", "results"},
        {"scale_doubts", "results"},
        {"rig_sha256", "results"},
        {"program", "results"},
        {"settings_sha256", "results"}}},
      {"scan",
       {{"position", "place"},
        {"side", "place"},
        {"name", "place"},
        {"path", "place"},
        {"points", "place"},
        {"coverage_pct", "place"},
        {"plate_x_mm", "place"},
        {"plate_y_mm", "place"},
        {"batch", "place"},
        {"state", ""}}},
      {"sherd",
       {{"number_sort", "number"},
        {"state", "number"},
        {"void_reason", "number"},
        {"context", "place"},
        {"bag", "place"},
        {"model_path", "model"},
        {"preview_path", "model"}}},
      {"file",
       {{"path", "content"},
        {"sha256", "content"},
        {"bytes", "content"},
        {"media_type", "content"},
        {"role", "content"},
        {"state", ""}}}};
  if (const auto of_table = kNamed.find(table); of_table != kNamed.end())
    if (const auto named = of_table->second.find(column); named != of_table->second.end())
      return named->second;
  return column;
}

}  // namespace

std::vector<Unit> unitsOf(const Table& table) {
  std::vector<Unit> units;
  // Decisions are only added to, and which measurement counts is told sherd by sherd.
  for (const char* added : {"pair_decision", "piece_decision", "measurement"})
    if (table.name == added) return units;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string name = unitNamed(table.name, table.columns[i]);
    if (name.empty()) continue;
    auto unit = std::find_if(units.begin(), units.end(),
                             [&](const Unit& known) { return known.name == name; });
    if (unit == units.end()) unit = units.insert(units.end(), Unit{name, {}, {}});
    unit->columns.push_back(i);
    unit->fields.push_back(table.columns[i]);
  }
  for (Unit& unit : units) {
    if (table.name != "sherd") continue;
    if (unit.name == "place") unit.fields = {"context", "bag", "site", "trench"};
    if (unit.name == "model")
      unit.fields.insert(unit.fields.end(), {"front", "back", "area", "volume", "filled_pct"});
  }
  return units;
}

std::vector<std::pair<std::string, std::string>> customFields(const Value& extra) {
  std::vector<std::pair<std::string, std::string>> fields;
  const nlohmann::json json = jsonOrDiscarded(extra.value_or("{}"));
  if (!json.is_object()) return fields;
  for (const auto& [name, value] : json.items()) fields.emplace_back(name, value.dump());
  return fields;
}

std::string textOf(const std::string& json) {
  const nlohmann::json parsed = jsonOrDiscarded(json);
  return parsed.is_string() ? parsed.get<std::string>() : json;
}

std::string customFieldsJson(const std::vector<std::pair<std::string, std::string>>& fields) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [name, value] : fields) json[name] = jsonOrDiscarded(value);
  return json.dump();
}

}  // namespace ostraka::merge
