#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace ostraka::exchange {

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

}  // namespace ostraka::exchange
