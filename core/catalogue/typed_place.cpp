#include "catalogue/typed_place.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>
#include <vector>

#include "catalogue/places.h"
#include "store/database.h"
#include "store/names.h"

namespace ostraka::catalogue {
namespace {

using Parts = std::vector<std::string>;

// Of what is typed, and of a code or number that has such marks itself; as unique keys. The word
// bag between blanks is none.
Parts partsOf(const std::string& text) {
  Parts parts;
  std::string part;
  bool after_blank = false, only_blanks = true;
  const auto isBag = [&] { return after_blank && store::uniqueKey(part) == "bag"; };
  for (const char c : text + ' ') {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank && c != '-' && c != '/') {
      if (part.empty()) after_blank = only_blanks;
      part += c;
      continue;
    }
    if (!part.empty()) {
      if (!(blank && isBag() && !parts.empty())) parts.push_back(store::uniqueKey(part));
      part.clear();
      only_blanks = true;
    }
    only_blanks = only_blanks && blank;
  }
  return parts;
}

// The bag as the rest of the typed parts names it; only one that is known may have several parts.
std::string bagOf(const Catalogue& catalogue, store::ContextRow context,
                  std::span<const std::string> rest, const std::string& text) {
  for (const records::BagRecord& bag : store::valueOrThrow(Places(catalogue).bags(context)))
    if (std::ranges::equal(partsOf(bag.number), rest)) return bag.number;
  if (rest.size() != 1) return {};
  // As it was typed, for a new one.
  const std::string whole = store::trimmed(text);
  return whole.substr(whole.find_last_of("-/ \t") + 1);
}

}  // namespace

Result<std::optional<BagPlace>> typedPlace(const Catalogue& catalogue, const std::string& text,
                                           Named what) {
  return catalogue.database().asResult([&] {
    const Parts typed = partsOf(text);
    std::optional<BagPlace> found;
    std::size_t longest = 0;  // of 0012 and 0012-a, the second
    if (typed.size() < 2) return found;
    for (const records::ContextRecord& context :
         store::valueOrThrow(Places(catalogue).contexts())) {
      Parts start;
      for (const std::string* code : {&context.site_code, &context.trench_code, &context.number})
        std::ranges::move(partsOf(*code), std::back_inserter(start));
      if (start.size() <= longest || start.size() > typed.size() ||
          !std::equal(start.begin(), start.end(), typed.begin()))
        continue;
      const auto rest = std::span(typed).subspan(start.size());
      if (rest.empty() != (what == Named::Context)) continue;
      const std::string bag =
          rest.empty() ? std::string() : bagOf(catalogue, context.row, rest, text);
      if (bag.empty() && !rest.empty()) continue;
      longest = start.size();
      found = BagPlace{context.site_code, context.trench_code, context.number, bag};
    }
    return found;
  });
}

Result<store::ContextRow> onlyContext(const Catalogue& catalogue, const std::string& number) {
  return catalogue.database().asResult([&] {
    const auto rows =
        catalogue.database()
            .sql("SELECT row FROM context WHERE number_key = ?", store::uniqueKey(number))
            .all<store::ContextRow>();
    return rows.size() == 1 ? rows.front() : store::ContextRow();
  });
}

}  // namespace ostraka::catalogue
