#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "records/sherd.h"

namespace ostraka::sherds {

/// All fields in the order of the CSV.
const std::vector<records::SherdField>& sherdFields();
/// All that a condition of the filter may name: these, and the days entered and excavated.
const std::vector<records::SherdField>& filterFields();
/// The one of this name; null: none, or a custom field.
const records::SherdField* sherdField(std::string_view name);
/// The value of a custom field as text; empty: none.
std::string customText(const std::string& extra_json, const std::string& name);
/// The field's value as text ('; ' between the terms of a list), as in CSV and in edits.
std::string textOf(const records::SherdRecord& sherd, const std::string& field);

}  // namespace ostraka::sherds
