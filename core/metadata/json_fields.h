#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::metadata {

/// What is empty is left out of a record.
inline void put(nlohmann::ordered_json& object, const char* key, const std::string& value) {
  if (!value.empty()) object[key] = value;
}
template <class T>
void put(nlohmann::ordered_json& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = *value;
}
inline void put(nlohmann::ordered_json& object, const char* key, nlohmann::ordered_json inner) {
  if (!inner.empty()) object[key] = std::move(inner);
}

/// The text of a file. JSON knows neither texts that are no UTF-8 nor numbers that are not finite;
/// a catalogue from elsewhere may hold both. Error: UnusableInput, which says which value:
/// metadata/places.json/sites/0/name.
Result<std::string> jsonText(const nlohmann::ordered_json& value, const std::string& where,
                             int indent = 1);

/// What a file of an export says. Each of its texts must be one that this program could have
/// written (checkText): some enter the catalogue as they are. Error: UnusableInput, which
/// says which value, as that of jsonText.
Result<nlohmann::json> parseFields(std::string_view text, const std::string& where);

}  // namespace ostraka::metadata
