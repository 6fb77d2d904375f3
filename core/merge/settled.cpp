#include "merge/settled.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files/json.h"

namespace ostraka::merge {

const char* nameOf(Take take) {
  return take == Take::A ? "a" : take == Take::B ? "b" : "number";
}

bool Conflict::offers(Take take) const {
  return std::find(takes.begin(), takes.end(), take) != takes.end();
}

Result<Settled> readSettled(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  const auto unusable = [&](const Message& what) { return Error::unusable(what, file.string()); };
  if (!json->is_array())
    return unusable(message(
        "This file must be a JSON list of {\"id\": \"…\", \"take\": \"a\"} or {\"id\": \"…\", "
        "\"number\": \"…\"}; nothing was merged. Correct the file."));
  Settled settled;
  for (const nlohmann::json& entry : *json) {
    const auto text = [&](const char* key) {
      return entry.is_object() && entry.contains(key) && entry[key].is_string()
                 ? entry[key].get<std::string>()
                 : std::string();
    };
    const std::string id = text("id"), take = text("take"), number = text("number");
    const bool one_side = (take == "a" || take == "b") && number.empty();
    if (id.empty() || (!one_side && (number.empty() || !take.empty())))
      return unusable(message(
          "An entry of this file does not have the form {\"id\": \"…\", \"take\": \"a\"} (or "
          "\"b\", or \"number\" with a new number): %1; nothing was merged. Correct the entry.",
          entry.dump()));
    const Choice choice{one_side ? (take == "a" ? Take::A : Take::B) : Take::Number, number};
    if (!settled.emplace(id, choice).second)
      return unusable(message(
          "The conflict %1 is settled twice in this file; nothing was merged. Keep one of the "
          "two entries.",
          id));
  }
  return settled;
}

}  // namespace ostraka::merge
