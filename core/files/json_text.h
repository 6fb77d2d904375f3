#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka {

/// As parseJson (files/json.h), with the keys in the order of the text.
Result<nlohmann::ordered_json> parseOrderedJson(std::string_view text, const std::string& where);

/// For texts within others, such as those in the catalogue: what parseJson rejects becomes a
/// discarded value, which is neither an object nor a list.
nlohmann::json jsonOrDiscarded(std::string_view text);
nlohmann::ordered_json orderedJsonOrDiscarded(std::string_view text);

}  // namespace ostraka
