#pragma once
#include <string>
#include <vector>

#include "merge/content.h"

namespace ostraka::merge {

/// Columns that change together: a person decides about all of them in one step.
struct Unit {
  std::string name;
  std::vector<std::size_t> columns;
  std::vector<std::string> fields;  ///< by which the history tells their changes
};
/// Of a table's columns. Not those that say who wrote the row and when, those that follow from
/// others (the state of a scan), and custom fields (`extra`), which are units by name.
std::vector<Unit> unitsOf(const Table& table);

/// Custom fields of a row, name and value as JSON.
std::vector<std::pair<std::string, std::string>> customFields(const Value& extra);
std::string textOf(const std::string& json);  ///< a string without its quotation marks
/// The JSON of such fields, in the order of their names.
std::string customFieldsJson(const std::vector<std::pair<std::string, std::string>>& fields);

}  // namespace ostraka::merge
