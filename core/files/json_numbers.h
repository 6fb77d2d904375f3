#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/result.h"

namespace ostraka {

/// A value of a JSON text that is rejected: not a number, not whole, out of its range, or beyond a
/// limit. what() is a sentence that says so.
class JsonValueError final : public nlohmann::json::exception {
 public:
  explicit JsonValueError(Message sentence_)
      : exception(600, sentence_.english().c_str()), sentence(std::move(sentence_)) {}
  Message sentence;
};

[[noreturn]] void refuseWhole(const std::string& name, std::int64_t least, std::int64_t most);
[[noreturn]] void refuseNumber(const std::string& name, double least, double most);

/// The sentence of a JsonValueError, or else `otherwise`, which says what the reader needs.
Error unusableJson(const nlohmann::json::exception& refused, const Message& otherwise,
                   const std::string& where);

constexpr std::int64_t kMostInt = 2'147'483'647;
constexpr double kMostNumber = std::numeric_limits<double>::max();  ///< where there is no limit

/// A whole number from least to most; 9.0 is one, but 9.5, true and "9" are not. name: for the
/// sentence. Throws JsonValueError.
template <class Json>
std::int64_t wholeIn(const Json& value, const std::string& name, std::int64_t least,
                     std::int64_t most) {
  if (value.is_number_unsigned()) {
    const auto number = value.template get<std::uint64_t>();
    if (number <= static_cast<std::uint64_t>(INT64_MAX) &&
        static_cast<std::int64_t>(number) >= least && static_cast<std::int64_t>(number) <= most)
      return static_cast<std::int64_t>(number);
  } else if (value.is_number_integer()) {
    const auto number = value.template get<std::int64_t>();
    if (number >= least && number <= most) return number;
  } else if (value.is_number_float()) {
    const auto number = value.template get<double>();
    if (std::trunc(number) == number && std::abs(number) <= 9e15 &&
        number >= static_cast<double>(least) && number <= static_cast<double>(most))
      return static_cast<std::int64_t>(number);
  }
  refuseWhole(name, least, most);
}

/// A finite number from least to most. Throws JsonValueError.
template <class Json>
double numberIn(const Json& value, const std::string& name, double least = -kMostNumber,
                double most = kMostNumber) {
  const double number = value.is_number() ? value.template get<double>() : NAN;
  if (!(number >= least && number <= most)) refuseNumber(name, least, most);
  return number;
}

/// The same for object[name]; an absent one throws as nlohmann's at() does.
template <class Json>
int wholeAt(const Json& object, const char* name, int least = -static_cast<int>(kMostInt),
            int most = static_cast<int>(kMostInt)) {
  return static_cast<int>(wholeIn(object.at(name), name, least, most));
}
template <class Json>
double numberAt(const Json& object, const char* name, double least = -kMostNumber,
                double most = kMostNumber) {
  return numberIn(object.at(name), name, least, most);
}

/// The same, with null for none.
template <class Json>
std::optional<double> numberOrNone(const Json& object, const char* name) {
  if (object.at(name).is_null()) return std::nullopt;
  return numberAt(object, name);
}

/// The same if the field may be absent.
template <class Json>
int wholeOr(const Json& object, const char* name, int otherwise,
            int least = -static_cast<int>(kMostInt), int most = static_cast<int>(kMostInt)) {
  return object.contains(name) ? wholeAt(object, name, least, most) : otherwise;
}
template <class Json>
double numberOr(const Json& object, const char* name, double otherwise, double least = -kMostNumber,
                double most = kMostNumber) {
  return object.contains(name) ? numberAt(object, name, least, most) : otherwise;
}

}  // namespace ostraka
