#include "metadata/json_fields.h"

#include <algorithm>
#include <cmath>

#include "store/names.h"
#include "store/values.h"

namespace ostraka::metadata {
namespace {

using nlohmann::ordered_json;

bool isText(std::string text) {
  std::erase(text, '\0');  // which JSON can write
  return store::isUtf8(text);
}

// The first value that JSON cannot hold; at: where it stands.
Result<void> checkHeld(const ordered_json& value, const std::string& at) {
  if (value.is_string() && !isText(value.get<std::string>()))
    return Error::unusable("The text is not valid UTF-8 or contains a zero byte.", at);
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    return Error::unusable("'" + store::numberText(value.get<double>()) +
                               "' is not a number; write 12.5 or 12,5, without a unit.",
                           at);
  if (!value.is_structured()) return {};
  for (const auto& [key, inner] : value.items()) {
    const std::string inside = at + "/" + key;
    if (!isText(key))
      return Error::unusable("The text is not valid UTF-8 or contains a zero byte.", inside);
    if (Result<void> held = checkHeld(inner, inside); !held) return held;
  }
  return {};
}

}  // namespace

Result<std::string> jsonText(const ordered_json& value, const std::string& where, int indent) {
  if (const Result<void> held = checkHeld(value, where); !held) return held.error();
  return value.dump(indent);
}

}  // namespace ostraka::metadata
