#include "catalogue/given_numbers.h"

#include <algorithm>
#include <iterator>

#include "catalogue/places.h"
#include "catalogue/renamed_places.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::catalogue {

GivenNumbers::GivenNumbers(const Catalogue& catalogue, const records::Numbering& scheme,
                           const std::map<std::string, std::string>& tokens,
                           store::ContextRow context, store::BagRow bag)
    : catalogue_(catalogue) {
  const store::TrenchRow trench =
      context ? store::valueOrThrow(Places(catalogue).context(context)).trench : store::TrenchRow();
  std::vector<std::map<std::string, std::string>> called = {tokens};
  for (const auto& [token, place] : {std::pair("trench", PlaceId{PlaceKind::Trench, trench.value}),
                                     {"context", PlaceId{PlaceKind::Context, context.value}},
                                     {"bag", PlaceId{PlaceKind::Bag, bag.value}}}) {
    const std::size_t so_far = called.size();
    for (const std::string& name : namesOf(catalogue, place))
      for (std::size_t i = 0; i < so_far; ++i)
        if (called[i].contains(token) && called[i][token] != name) {
          called.push_back(called[i]);
          called.back()[token] = name;
        }
  }
  std::set<std::string> counters;
  for (const auto& values : called)
    if (const auto counter = scheme.counter(values); counter && counters.insert(*counter).second)
      counts_.emplace_back(*counter);
}

std::optional<std::int64_t> GivenNumbers::of(const std::string& number) const {
  for (const records::NumberCount& count : counts_)
    if (const auto n = count.of(number)) return n;
  return {};
}

std::set<std::int64_t> GivenNumbers::all() const {
  std::set<std::int64_t> given;
  const std::string key = "replace(replace(number_key, ' ', ''), char(160), '')";  // indexed
  for (const records::NumberCount& count : counts_) {
    store::Statement rows =
        catalogue_.database().sql("SELECT number FROM given_number WHERE " + key + " >= ?1 AND " +
                                      key + " < ?1 || char(1114111)",
                                  count.before());
    for (std::string number; rows.read(number);)
      if (const auto n = count.of(number)) given.insert(*n);
  }
  return given;
}

std::int64_t GivenNumbers::next(std::int64_t first, std::int64_t last) const {
  const std::set<std::int64_t> given = all();
  const auto behind = given.upper_bound(last);
  return behind == given.begin() ? first : std::max(first, *std::prev(behind) + 1);
}

std::string GivenNumbers::ownOf(store::SherdRow sherd) const {
  std::string own;
  std::int64_t highest = -1;
  store::Statement rows =
      catalogue_.database().sql("SELECT number FROM given_number WHERE sherd = ?", sherd);
  for (std::string number; rows.read(number);)
    if (const auto n = of(number); n && *n > highest) {
      highest = *n;
      own = number;
    }
  return own;
}

}  // namespace ostraka::catalogue
