#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

/// The part of JSON Schema (draft 2020-12) in which docs/schemas is written: $schema, $defs, $ref
/// within the file, description, type, properties, required, additionalProperties, items, enum,
/// minimum, maximum, pattern and oneOf.
namespace ostraka::schema {

/// What would go unchecked or cannot hold: other keywords, values that a keyword does not take, a
/// $ref that leads nowhere. One line each, with its place in the schema.
std::vector<std::string> faults(const nlohmann::json& schema);

/// Where a value departs from a schema without faults, one line each, with its place in the value.
std::vector<std::string> violations(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace ostraka::schema
