#include "sherds/numbers.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/given_numbers.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "records/numbering.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::sherds {

records::Numbering schemeOf(const catalogue::Catalogue& catalogue) {
  return store::valueOrThrow(records::Numbering::parse(
      store::valueOrThrow(catalogue::Settings(catalogue).project()).numbering));
}

std::map<std::string, std::string> numberTokens(const catalogue::Catalogue& catalogue,
                                                const records::SherdRecord& sherd) {
  std::int64_t at = catalogue.now();
  if (sherd.batch) {
    const auto started = catalogue.database()
                             .sql("SELECT started_ms FROM batch WHERE row = ?", sherd.batch)
                             .one<std::int64_t>();
    if (started > 0) at = started;
  }
  const std::string year = utcDay(at).substr(0, 4);
  std::map<std::string, std::string> tokens = {{"site", sherd.site},
                                               {"trench", sherd.trench},
                                               {"context", sherd.context_number},
                                               {"bag", sherd.bag_number},
                                               {"batch", sherd.batch_number},
                                               {"yyyy", year},
                                               {"yy", year.substr(year.size() - 2)}};
  std::erase_if(tokens, [](const auto& token) { return token.second.empty(); });
  if (sherd.trench.empty() && !sherd.context_number.empty() &&
      !store::valueOrThrow(catalogue::Places(catalogue).hasTrenches(sherd.site)))
    tokens["trench"] = "";
  return tokens;
}

namespace {

// 12 of 12.0, which a spreadsheet makes of it.
std::string withoutPointZero(const std::string& number) {
  const std::size_t digits = std::min(number.find_first_not_of("0123456789"), number.size());
  const std::string rest = number.substr(digits);
  return digits > 0 && (rest == ".0" || rest == ",0") ? number.substr(0, digits) : number;
}

}  // namespace

Taken takenBy(store::Database& database, const std::string& number) {
  Taken taken;
  const std::string key = store::uniqueKey(number);
  store::Statement rows = database.sql(
      "SELECT sherd, number, number_key <> ?1 FROM given_number WHERE number_key = ?1 OR slug_key "
      "= ?2 ORDER BY number_key <> ?1",
      key, store::uniqueKey(store::slug(number)));
  rows.read(taken.sherd, taken.number, taken.slug_only);
  return taken;
}

void giveNumber(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd,
                const std::string& number) {
  store::Database& database = catalogue.database();
  const Taken taken = takenBy(database, number);
  if (taken.sherd && (taken.sherd != sherd.row || taken.slug_only))
    store::refuse(message("The number %1 was assigned before; numbers are never reused.", number),
                  number);
  if (!taken.sherd)
    database.run(
        "INSERT INTO given_number (number_key, slug_key, number, sherd, at) VALUES (?, ?, ?, ?, ?)",
        store::uniqueKey(number), store::uniqueKey(store::slug(number)), number, sherd.row,
        catalogue.now());
}

void setNumber(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd,
               const std::string& number) {
  store::Database& database = catalogue.database();
  if (number.empty()) {
    database.run(
        "UPDATE sherd SET number = '', number_sort = ?, state = CASE state WHEN 'numbered' THEN "
        "'draft' ELSE state END WHERE row = ?",
        kBehindAllNumbers, sherd.row);
    return;
  }
  giveNumber(catalogue, sherd, number);
  database.run("UPDATE sherd SET number = ?, number_sort = ?, state = 'numbered' WHERE row = ?",
               number, store::sortKey(number), sherd.row);
}

Result<records::NumberBlock> numberBlock(const catalogue::Catalogue& catalogue) {
  const catalogue::Settings settings(catalogue);
  const Result<std::string> first = settings.value("numbering.first"),
                            last = settings.value("numbering.last");
  if (!first || !last) return first ? last.error() : first.error();
  return records::NumberBlock::parse(*first, *last);
}

Result<std::vector<std::string>> Numbers::propose(std::span<const store::SherdRow> rows) const {
  return database_->asResult([&] {
    const records::Numbering scheme = schemeOf(catalogue_);
    const auto [first, last] = store::valueOrThrow(numberBlock(catalogue_));
    std::map<std::string, std::int64_t> next;  // of each counter
    std::map<std::tuple<std::string, std::int64_t, std::int64_t>, catalogue::GivenNumbers> counts;
    std::vector<std::string> numbers;
    std::set<std::string> proposed;
    const std::set<std::string> typed = typedEverywhere(catalogue_);
    for (const records::SherdRecord& sherd : store::valueOrThrow(Sherds(catalogue_).of(rows))) {
      if (!sherd.number.empty()) {
        numbers.push_back(sherd.number);
        continue;
      }
      const auto tokens = numberTokens(catalogue_, sherd);
      const std::string counter = store::valueOrThrow(scheme.counter(tokens));
      const auto [count, is_new] =
          counts.try_emplace({counter, sherd.context.value, sherd.bag.value}, catalogue_, scheme,
                             tokens, sherd.context, sherd.bag);
      // A sherd that had a number of this count before gets it back: it is nobody else's.
      std::string number = count->second.ownOf(sherd.row);
      if (!number.empty()) {
        numbers.push_back(number);
        continue;
      }
      if (is_new) next[counter] = std::max(next[counter], count->second.next(first, last));
      do {
        const std::int64_t n = next[counter]++;
        if (n > last)
          store::refuse(message("The block of numbers up to %1 is used up; assign this computer a "
                                "new block in the settings.",
                                last),
                        counter);
        number = store::valueOrThrow(scheme.number(tokens, static_cast<int>(n)));
        // Typed by hand in another form, or on a plate that is not computed yet.
      } while (takenBy(*database_, number).sherd || typed.contains(store::uniqueKey(number)) ||
               !store::valueOrThrow(similar(sherd.row, number)).empty() ||
               !proposed.insert(store::sortKey(number)).second);
      numbers.push_back(number);
    }
    return numbers;
  });
}

Result<std::vector<std::string>> Numbers::assign(std::span<const store::SherdRow> rows,
                                                 const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    std::vector<std::string> numbers = store::valueOrThrow(propose(rows));
    std::vector<records::FieldChange> changes;
    for (std::size_t i = 0; i < rows.size(); ++i)
      changes.push_back({rows[i], "number", numbers[i]});
    store::valueOrThrow(SherdChanges(catalogue_).apply(changes, provenance));
    return numbers;
  });
}

Result<int> Numbers::next(const records::Numbering& scheme,
                          const std::map<std::string, std::string>& tokens,
                          store::ContextRow context, int first, int last) const {
  return database_->asResult([&] {
    const catalogue::GivenNumbers given(catalogue_, scheme, tokens, context, {});
    return static_cast<int>(given.next(first, last));
  });
}

Result<std::vector<std::string>> Numbers::similar(store::SherdRow sherd,
                                                  const std::string& number) const {
  const std::string whole = withoutPointZero(number);
  return database_->asResult([&] {
    auto numbers =
        database_
            ->sql("SELECT number FROM sherd WHERE number_sort IN (?, ?, ?) AND row IS NOT ?",
                  store::sortKey(number), store::sortKey(whole), store::sortKey(whole + ".0"),
                  sherd)
            .all<std::string>();
    std::erase_if(numbers, [&](const std::string& other) {
      return store::uniqueKey(other) == store::uniqueKey(number) ||
             (store::sortKey(other) != store::sortKey(number) &&
              store::sortKey(withoutPointZero(other)) != store::sortKey(whole));
    });
    return numbers;
  });
}

Result<Message> Numbers::doubt(store::SherdRow sherd, const std::string& number) const {
  const Result<std::vector<std::string>> numbers = similar(sherd, number);
  if (!numbers) return numbers.error();
  if (number.empty() || numbers->empty()) return Message();
  return message(
      "The number %1 differs from the existing number %2 only in zeros, letter case or "
      "punctuation; check which one is meant.",
      number, numbers->front());
}

Result<bool> Numbers::isFree(const std::string& number) const {
  return database_->asResult([&] { return !takenBy(*database_, number).sherd; });
}

Result<std::vector<int>> Numbers::gaps(store::ContextRow context) const {
  return database_->asResult([&] {
    constexpr std::size_t kMost = 10'000;
    const records::Numbering scheme = schemeOf(catalogue_);
    const auto [first, last] = store::valueOrThrow(numberBlock(catalogue_));
    // One sherd for all that share what a scheme may name.
    const auto rows =
        database_->sql("SELECT min(row) FROM sherd WHERE context = ? GROUP BY bag, batch", context)
            .all<store::SherdRow>();
    std::map<std::string, catalogue::GivenNumbers> counts;
    for (const records::SherdRecord& sherd : store::valueOrThrow(Sherds(catalogue_).of(rows)))
      if (const auto tokens = numberTokens(catalogue_, sherd);
          const auto counter = scheme.counter(tokens))
        counts.try_emplace(*counter, catalogue_, scheme, tokens, sherd.context, sherd.bag);
    std::vector<int> gaps;
    for (const auto& [counter, count] : counts) {
      std::int64_t expected = first;
      for (const std::int64_t n : count.all()) {
        if (n > last) break;
        for (; expected < n && gaps.size() < kMost; ++expected)
          gaps.push_back(static_cast<int>(expected));
        expected = std::max(expected, n + 1);
      }
    }
    return gaps;
  });
}

}  // namespace ostraka::sherds
