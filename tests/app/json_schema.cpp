#include "json_schema.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

namespace ostraka::schema {
namespace {

using nlohmann::json;
using Lines = std::vector<std::string>;

constexpr const char* kDraft = "https://json-schema.org/draft/2020-12/schema";

bool isOfType(const json& value, const std::string& type) {
  if (type == "integer")
    return value.is_number_integer() ||
           (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
  return (type == "number" && value.is_number()) || (type == "string" && value.is_string()) ||
         (type == "boolean" && value.is_boolean()) || (type == "null" && value.is_null()) ||
         (type == "array" && value.is_array()) || (type == "object" && value.is_object());
}

bool isType(const json& name) {
  return name == "integer" || name == "number" || name == "string" || name == "boolean" ||
         name == "null" || name == "array" || name == "object";
}

bool allOf(const json& list, bool (*is)(const json&)) {
  return list.is_array() && !list.empty() && std::all_of(list.begin(), list.end(), is);
}

bool isExpression(const json& value) {
  if (!value.is_string()) return false;
  try {
    const std::regex expression(value.get<std::string>());
    return true;
  } catch (const std::regex_error&) {
    return false;
  }
}

bool leadsSomewhere(const json& root, const json& value) {
  if (!value.is_string() || !value.get<std::string>().starts_with("#/")) return false;
  return root.contains(json::json_pointer(value.get<std::string>().substr(1)));
}

// Whether a keyword that holds no schema may have this value.
bool isKnown(const json& root, const std::string& keyword, const json& value) {
  if (keyword == "$schema") return value == kDraft;
  if (keyword == "$ref") return leadsSomewhere(root, value);
  if (keyword == "description") return value.is_string();
  if (keyword == "type") return isType(value) || allOf(value, isType);
  if (keyword == "required") return allOf(value, [](const json& name) { return name.is_string(); });
  if (keyword == "enum") return allOf(value, [](const json&) { return true; });
  if (keyword == "minimum" || keyword == "maximum") return value.is_number();
  if (keyword == "pattern") return isExpression(value);
  return false;
}

void addFaults(const json& root, const json& schema, const std::string& at, Lines& lines) {
  if (!schema.is_object()) {
    lines.push_back(at + ": no schema: " + schema.dump());
    return;
  }
  for (const auto& [keyword, value] : schema.items()) {
    const std::string here = at + "/" + keyword;
    const bool named = keyword == "properties" || keyword == "$defs";
    if ((named && value.is_object()) || (keyword == "oneOf" && value.is_array()))
      for (const auto& [name, part] : value.items())
        addFaults(root, part, here + "/" + name, lines);
    else if (keyword == "items" || (keyword == "additionalProperties" && !value.is_boolean()))
      addFaults(root, value, here, lines);
    else if (keyword != "additionalProperties" && !isKnown(root, keyword, value))
      lines.push_back(here + ": not supported: " + value.dump());
  }
}

class Check {
 public:
  Check(const json& root, Lines& lines) : root_(root), lines_(lines) {}

  void check(const json& schema, const json& value, const std::string& at) {
    if (schema.contains("$ref"))
      check(root_.at(json::json_pointer(schema["$ref"].get<std::string>().substr(1))), value, at);
    if (schema.contains("oneOf")) checkOneOf(schema["oneOf"], value, at);
    if (schema.contains("type")) checkType(schema["type"], value, at);
    if (schema.contains("enum"))
      expect(std::count(schema["enum"].begin(), schema["enum"].end(), value) > 0, at,
             value.dump() + " is not in " + schema["enum"].dump());
    if (value.is_number()) checkNumber(schema, value.get<double>(), at);
    if (value.is_string() && schema.contains("pattern"))
      expect(std::regex_search(value.get<std::string>(),
                               std::regex(schema["pattern"].get<std::string>())),
             at, value.dump() + " is not like " + schema["pattern"].dump());
    if (value.is_array() && schema.contains("items"))
      for (std::size_t i = 0; i < value.size(); ++i)
        check(schema["items"], value[i], at + "/" + std::to_string(i));
    if (value.is_object()) checkObject(schema, value, at);
  }

 private:
  void expect(bool holds, const std::string& at, const std::string& words) {
    if (!holds) lines_.push_back((at.empty() ? "/" : at) + ": " + words);
  }

  void checkType(const json& type, const json& value, const std::string& at) {
    const json types = type.is_array() ? type : json::array({type});
    expect(std::any_of(types.begin(), types.end(),
                       [&](const json& one) { return isOfType(value, one.get<std::string>()); }),
           at, value.dump() + " is not of type " + type.dump());
  }

  void checkNumber(const json& schema, double value, const std::string& at) {
    if (schema.contains("minimum"))
      expect(value >= schema["minimum"].get<double>(), at,
             std::to_string(value) + " is below " + schema["minimum"].dump());
    if (schema.contains("maximum"))
      expect(value <= schema["maximum"].get<double>(), at,
             std::to_string(value) + " is above " + schema["maximum"].dump());
  }

  void checkObject(const json& schema, const json& value, const std::string& at) {
    const json none = json::object();
    const json& properties = schema.contains("properties") ? schema["properties"] : none;
    if (schema.contains("required"))
      for (const json& name : schema["required"])
        expect(value.contains(name.get<std::string>()), at, name.dump() + " is missing");
    for (const auto& [name, part] : value.items()) {
      const std::string here = at + "/" + name;
      if (properties.contains(name))
        check(properties[name], part, here);
      else if (const auto more = schema.find("additionalProperties"); more == schema.end())
        continue;
      else if (more->is_boolean())
        expect(more->get<bool>(), here, "unknown");
      else
        check(*more, part, here);
    }
  }

  void checkOneOf(const json& schemas, const json& value, const std::string& at) {
    Lines all;
    int hold = 0;
    for (const json& schema : schemas) {
      Lines found;
      Check(root_, found).check(schema, value, at);
      hold += found.empty() ? 1 : 0;
      all.insert(all.end(), found.begin(), found.end());
    }
    expect(hold == 1, at, std::to_string(hold) + " schemas of oneOf hold");
    if (hold == 0) lines_.insert(lines_.end(), all.begin(), all.end());
  }

  const json& root_;
  Lines& lines_;
};

}  // namespace

Lines faults(const json& schema) {
  Lines lines;
  addFaults(schema, schema, "#", lines);
  return lines;
}

Lines violations(const json& schema, const json& value) {
  Lines lines;
  Check(schema, lines).check(schema, value, "");
  return lines;
}

}  // namespace ostraka::schema
