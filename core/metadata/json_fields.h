#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "base/result.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "records/words.h"
#include "store/database.h"

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

/// Ids by rows, of any tables.
template <class... Rows>
struct IdsOf {
  std::tuple<std::map<Rows, std::string>...> all;
  template <class Row>
  std::string& operator[](Row row) {
    return std::get<std::map<Row, std::string>>(all)[row];
  }
};
using Ids = IdsOf<store::PersonRow, store::SiteRow, store::TrenchRow, store::ContextRow,
                  store::BagRow, store::ScanRow, store::DecisionRow>;
using RowsById = std::map<std::string, std::int64_t>;

/// Writes the fields of a record that a function lists for both ways, and TakenFields reads them.
/// The operator leaves out what is empty, false or none; always() does not.
struct PutFields {
  static constexpr bool kWrites = true;
  nlohmann::ordered_json& object;
  Ids& ids;

  void always(const char* key, const auto& value) { object[key] = value; }
  void always(const char* key, char value) { object[key] = std::string(1, value); }
  void word(const char* key, const auto& value) { object[key] = records::wordOf(value); }
  void operator()(const char* key, const auto& value) { put(object, key, value); }
  void operator()(const char* key, bool value) {
    if (value) object[key] = true;
  }
  void operator()(const char* key, const std::optional<Eigen::Isometry3d>& value) {
    if (value) object[key] = toJson(*value);
  }
  void inner(const char* key, const std::string& json) {
    const nlohmann::ordered_json own = orderedJsonOrDiscarded(json);
    if (own.is_object() && !own.empty()) object[key] = own;
  }
  template <class Tag>
  void operator()(const char* key, const store::RowOf<Tag>& row) {
    if (row) put(object, key, ids[row]);
  }
};

/// Throws json::exception where something is not as written.
struct TakenFields {
  static constexpr bool kWrites = false;
  const nlohmann::json& object;
  const RowsById& rows;

  void always(const char* key, std::string& value) { (*this)(key, value); }
  void always(const char* key, char& value) {
    if (const std::string text = object.value(key, ""); !text.empty()) value = text[0];
  }
  void always(const char* key, bool& value) { (*this)(key, value); }
  void always(const char* key, int& value) { value = wholeAt(object, key); }
  void always(const char* key, std::int64_t& value) {
    value = wholeIn(object.at(key), key, 0, INT64_MAX);
  }
  template <class Enum>
  void word(const char* key, Enum& value) {
    value = records::fromWord<Enum>(object.value(key, ""));
  }
  void inner(const char* key, std::string& json) {
    if (object.contains(key)) json = object.at(key).dump();
  }
  void operator()(const char* key, std::string& value) { value = object.value(key, ""); }
  void operator()(const char* key, bool& value) { value = object.value(key, value); }
  void operator()(const char* key, std::optional<double>& value) {
    if (object.contains(key)) value = numberAt(object, key);
  }
  void operator()(const char* key, std::optional<int>& value) {
    if (object.contains(key)) value = wholeAt(object, key);
  }
  template <class T>
  void operator()(const char* key, std::optional<T>& value) {
    if (object.contains(key)) value = object.at(key).template get<T>();
  }
  void operator()(const char* key, std::optional<Eigen::Isometry3d>& value) {
    if (object.contains(key))
      value = store::valueOrThrow(isometryFromJson(object.at(key), "metadata/batches.json"));
  }
  template <class Tag>
  void operator()(const char* key, store::RowOf<Tag>& row) {
    const auto found = rows.find(object.value(key, ""));
    row = {found == rows.end() ? 0 : found->second};
  }
};

}  // namespace ostraka::metadata
