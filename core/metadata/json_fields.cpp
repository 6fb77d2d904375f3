#include "metadata/json_fields.h"

#include "base/message.h"
#include "base/text.h"
#include "files/json.h"
#include "store/values.h"

namespace ostraka::metadata {
namespace {

using nlohmann::ordered_json;

using TextCheck = Result<void> (*)(std::string_view);

Result<void> checkWritten(std::string_view text) {
  std::string held(text);
  std::erase(held, '\0');  // which JSON can write
  if (isUtf8(held)) return {};
  return Error::unusable(message("The text is not valid UTF-8 or contains a zero byte."));
}

// The first value that must not be there; at: where it stands.
template <class Json>
Result<void> checkHeld(const Json& value, const std::string& at, TextCheck check) {
  if (value.is_string())
    if (const auto good = check(value.template get_ref<const std::string&>()); !good)
      return Error::unusable(good.error().what, at);
  if (value.is_number_float())
    if (const auto good = store::checkFinite(value.template get<double>()); !good)
      return Error::unusable(good.error().what, at);
  if (!value.is_structured()) return {};
  for (const auto& [key, inner] : value.items()) {
    const std::string inside = at + "/" + key;
    if (const auto good = check(key); !good) return Error::unusable(good.error().what, inside);
    if (Result<void> held = checkHeld(inner, inside, check); !held) return held;
  }
  return {};
}

}  // namespace

Result<std::string> jsonText(const ordered_json& value, const std::string& where, int indent) {
  if (const Result<void> held = checkHeld(value, where, checkWritten); !held) return held.error();
  return value.dump(indent);
}

Result<nlohmann::json> parseFields(std::string_view text, const std::string& where) {
  Result<nlohmann::json> value = parseJson(text, where);
  if (!value) return value;
  if (const Result<void> held = checkHeld(*value, where, checkText); !held) return held.error();
  return value;
}

}  // namespace ostraka::metadata
