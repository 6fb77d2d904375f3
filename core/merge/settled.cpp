#include "merge/settled.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files/json.h"
#include "store/values.h"

namespace ostraka::merge {

const char* nameOf(Take take) {
  return take == Take::A ? "a" : take == Take::B ? "b" : take == Take::One ? "one" : "number";
}

bool Conflict::offers(Take take) const {
  return std::find(takes.begin(), takes.end(), take) != takes.end();
}

// As a number that is typed: places and persons may be called more, but need not.
Result<std::string> newName(const std::string& conflict_id, const Choice& choice) {
  Result<std::string> name = store::checkedText(choice.number);
  if (name) name = store::checkedNumber(*name);
  if (!name) return Error::unusable(name.error().what, conflict_id);
  if (name->empty())
    return Error::unusable(
        message("A new number cannot be empty; nothing was merged. Enter a number."), conflict_id);
  return name;
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
    const std::map<std::string, Take> takes = {
        {"a", Take::A}, {"b", Take::B}, {"one", Take::One}, {"", Take::Number}};
    const auto known = takes.find(take);
    if (id.empty() || known == takes.end() || (known->second == Take::Number && number.empty()) ||
        (known->second == Take::One && !number.empty()))
      return unusable(message(
          "An entry of this file does not have the form {\"id\": \"…\", \"take\": \"a\"} (or "
          "\"b\" or \"one\", or \"number\" with a new number): %1; nothing was merged. Correct "
          "the entry.",
          entry.dump()));
    const Choice choice{known->second, number};
    if (!settled.emplace(id, choice).second)
      return unusable(message(
          "The conflict %1 is settled twice in this file; nothing was merged. Keep one of the "
          "two entries.",
          id));
  }
  return settled;
}

}  // namespace ostraka::merge
