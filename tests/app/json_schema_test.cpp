#include "json_schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ostraka::schema {
namespace {

using nlohmann::json;

bool follows(const char* schema, const char* value) {
  const json read = json::parse(schema);
  EXPECT_TRUE(faults(read).empty()) << schema << faults(read).front();
  return violations(read, json::parse(value)).empty();
}

TEST(JsonSchema, EachKeywordHoldsForWhatFollowsItAndForNothingElse) {
  struct Case {
    const char *schema, *right, *wrong;
  };
  const Case cases[] = {
      {R"({"type": "number"})", "1.5", "\"1.5\""},
      {R"({"type": "integer"})", "2", "2.5"},
      {R"({"type": "integer"})", "2.0", "null"},
      {R"({"type": "string"})", "\"\"", "0"},
      {R"({"type": "boolean"})", "false", "0"},
      {R"({"type": "null"})", "null", "0"},
      {R"({"type": "array"})", "[]", "{}"},
      {R"({"type": "object"})", "{}", "[]"},
      {R"({"type": ["number", "null"]})", "null", "true"},
      {R"({"enum": ["a", 1, null]})", "null", "\"b\""},
      {R"({"enum": [1]})", "1", "\"1\""},
      {R"({"minimum": 0})", "0", "-0.1"},
      {R"({"maximum": 1})", "1", "1.1"},
      {R"({"pattern": "^[A-Z]+$"})", "\"ARM\"", "\"arm\""},
      {R"({"items": {"type": "integer"}})", "[1, 2]", "[1, \"2\"]"},
      {R"({"required": ["a"]})", R"({"a": null})", R"({"b": 1})"},
      {R"({"properties": {"a": {"type": "string"}}})", R"({"b": 1})", R"({"a": 1})"},
      {R"({"properties": {"a": {}}, "additionalProperties": false})", R"({"a": 1})",
       R"({"a": 1, "b": 1})"},
      {R"({"additionalProperties": {"type": "string"}})", R"({"a": "1"})", R"({"a": 1})"},
      {R"({"oneOf": [{"type": "string"}, {"type": "number"}]})", "1", "null"},
      {R"({"oneOf": [{"type": "integer"}, {"type": "number"}]})", "1.5", "1"},
      {R"({"$ref": "#/$defs/a", "$defs": {"a": {"type": "string"}}})", "\"\"", "1"},
      {R"({"$ref": "#/$defs/a", "minimum": 3, "$defs": {"a": {"maximum": 5}}})", "4", "2"}};
  for (const auto& [schema, right, wrong] : cases) {
    EXPECT_TRUE(follows(schema, right)) << schema << right;
    EXPECT_FALSE(follows(schema, wrong)) << schema << wrong;
  }
}

TEST(JsonSchema, NamesThePlaceOfWhatIsWrong) {
  const json schema =
      json::parse(R"({"properties": {"a": {"items": {"properties": {"b": {"minimum": 0}}}}}})");
  const auto lines = violations(schema, json::parse(R"({"a": [{"b": 1}, {"b": -1}]})"));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].starts_with("/a/1/b: ")) << lines[0];
}

// Wherever it stands, also where no value would ever lead.
TEST(JsonSchema, RefusesWhatItWouldNotCheck) {
  const std::pair<const char*, const char*> schemas[] = {
      {R"({"minLength": 1})", "#/minLength"},
      {R"({"properties": {"a": {"const": 1}}})", "#/properties/a/const"},
      {R"({"$defs": {"a": {"format": "date"}}})", "#/$defs/a/format"},
      {R"({"oneOf": [{}, {"not": {}}]})", "#/oneOf/1/not"},
      {R"({"items": [{}]})", "#/items"},
      {R"({"additionalProperties": {"Type": "string"}})", "#/additionalProperties/Type"},
      {R"({"type": "float"})", "#/type"},
      {R"({"type": ["number", "float"]})", "#/type"},
      {R"({"required": "a"})", "#/required"},
      {R"({"enum": []})", "#/enum"},
      {R"({"minimum": "0"})", "#/minimum"},
      {R"({"pattern": "("})", "#/pattern"},
      {R"({"$ref": "#/$defs/a"})", "#/$ref"},
      {R"({"$ref": "other.json"})", "#/$ref"},
      {R"({"$schema": "http://json-schema.org/draft-07/schema#"})", "#/$schema"},
      {R"({"properties": []})", "#/properties"}};
  for (const auto& [schema, place] : schemas) {
    const auto lines = faults(json::parse(schema));
    ASSERT_EQ(lines.size(), 1u) << schema;
    EXPECT_TRUE(lines[0].starts_with(std::string(place) + ": ")) << lines[0];
  }
}

}  // namespace
}  // namespace ostraka::schema
