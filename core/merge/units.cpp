#include "merge/units.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "files/json_text.h"

namespace ostraka::merge {
namespace {

const std::set<std::string> kStamps = {"created_at", "created_by", "updated_at",
                                       "updated_by", "revision",   "extra"};

// Columns of a unit that is not called like them; without a name they belong to none.
struct Named {
  const char *table, *unit;
  std::vector<std::string> columns;
};

const std::vector<Named>& namedUnits() {
  static const std::vector<Named> kAll = {
      {"person", "initials", {"initials_key"}},
      {"site", "code", {"code_key"}},
      {"site", "location", {"latitude_deg", "longitude_deg"}},
      {"trench", "code", {"site", "code_key"}},
      {"context", "number", {"site", "trench", "number_key"}},
      {"bag", "number", {"context", "number_key"}},
      {"batch", "", {"number"}},  // names its folders, in each project
      {"batch",
       "results",
       {"state", "started_ms", "ended_ms", "reprojection_px", "scale_error_pct", "scale",
        "scale_doubts", "rig_sha256", "program", "settings_sha256"}},
      {"scan",
       "place",
       {"position", "side", "name", "path", "points", "coverage_pct", "plate_x_mm", "plate_y_mm",
        "batch"}},
      {"scan", "", {"state"}},
      {"sherd", "number", {"number_sort", "state", "void_reason"}},
      {"sherd", "place", {"context", "bag"}},
      {"sherd", "model", {"model_path", "preview_path"}},
      {"file", "content", {"path", "sha256", "bytes", "media_type", "role"}},
      {"file", "", {"state"}}};
  return kAll;
}

// Which unit a column belongs to; empty: none.
std::string unitNamed(const std::string& table, const std::string& column) {
  if (kStamps.contains(column)) return {};
  for (const Named& named : namedUnits())
    if (table == named.table && std::ranges::count(named.columns, column) > 0) return named.unit;
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
    auto unit = std::ranges::find(units, name, &Unit::name);
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
