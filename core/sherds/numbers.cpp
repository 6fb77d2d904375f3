#include "sherds/numbers.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "base/message.h"
#include "base/text.h"
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

using records::NumberCount;

// Those of a count that were ever given, to whichever sherd.
std::set<std::int64_t> givenIn(store::Database& database, const NumberCount& count) {
  std::set<std::int64_t> all;
  const std::string key = "replace(replace(number_key, ' ', ''), char(160), '')";  // indexed
  store::Statement rows = database.sql("SELECT number FROM given_number WHERE " + key +
                                           " >= ?1 AND " + key + " < ?1 || char(1114111)",
                                       count.before());
  for (std::string number; rows.read(number);)
    if (const auto n = count.of(number)) all.insert(*n);
  return all;
}

constexpr std::int64_t kLastNumber = 999'999'999;

// The block of numbers of this computer (settings numbering.first and numbering.last), so that two
// laptops in the field never give the same number.
std::int64_t settingNumber(const catalogue::Catalogue& catalogue, const char* key,
                           std::int64_t otherwise) {
  const std::string text = store::valueOrThrow(catalogue::Settings(catalogue).value(key));
  if (text.empty()) return otherwise;
  return static_cast<std::int64_t>(store::valueOrThrow(store::parsedNumber(text)));
}

// After the highest of the block that this computer gives.
std::int64_t nextOf(store::Database& database, const NumberCount& count, std::int64_t first,
                    std::int64_t last) {
  const std::set<std::int64_t> given = givenIn(database, count);
  const auto behind = given.upper_bound(last);
  return behind == given.begin() ? first : std::max(first, *std::prev(behind) + 1);
}

// A sherd that had a number of this count before gets it back: it is nobody else's.
std::string ownOf(store::Database& database, const NumberCount& count, store::SherdRow sherd) {
  std::string own;
  std::int64_t highest = -1;
  store::Statement rows = database.sql("SELECT number FROM given_number WHERE sherd = ?", sherd);
  for (std::string number; rows.read(number);)
    if (const auto n = count.of(number); n && *n > highest) {
      highest = *n;
      own = number;
    }
  return own;
}

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

Result<std::vector<std::string>> Numbers::propose(std::span<const store::SherdRow> rows) const {
  return database_->asResult([&] {
    const records::Numbering scheme = schemeOf(catalogue_);
    const std::int64_t first = settingNumber(catalogue_, "numbering.first", 1);
    const std::int64_t last = settingNumber(catalogue_, "numbering.last", kLastNumber);
    std::map<std::string, std::int64_t> next;
    std::vector<std::string> numbers;
    const std::set<std::string> typed = typedEverywhere(catalogue_);
    for (const records::SherdRecord& sherd : store::valueOrThrow(Sherds(catalogue_).of(rows))) {
      if (!sherd.number.empty()) {
        numbers.push_back(sherd.number);
        continue;
      }
      const auto tokens = numberTokens(catalogue_, sherd);
      const std::string counter = store::valueOrThrow(scheme.counter(tokens));
      const NumberCount count(counter);
      std::string number = ownOf(*database_, count, sherd.row);
      if (!number.empty()) {
        numbers.push_back(number);
        continue;
      }
      if (!next.contains(counter)) next[counter] = nextOf(*database_, count, first, last);
      do {
        const std::int64_t n = next[counter]++;
        if (n > last)
          store::refuse(message("The block of numbers up to %1 is used up; assign this computer a "
                                "new block in the settings.",
                                last),
                        counter);
        number = store::valueOrThrow(scheme.number(tokens, static_cast<int>(n)));
        // Typed by hand in another form, or on a plate that is not computed yet.
      } while (takenBy(*database_, number).sherd || typed.contains(store::uniqueKey(number)));
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

Result<int> Numbers::next(const std::string& counter, int first, int last) const {
  return database_->asResult(
      [&] { return static_cast<int>(nextOf(*database_, NumberCount(counter), first, last)); });
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
    const std::int64_t first = settingNumber(catalogue_, "numbering.first", 1);
    const std::int64_t last = settingNumber(catalogue_, "numbering.last", kLastNumber);
    // One sherd for all that share what a scheme may name.
    const auto rows =
        database_->sql("SELECT min(row) FROM sherd WHERE context = ? GROUP BY bag, batch", context)
            .all<store::SherdRow>();
    std::set<std::string> counters;
    for (const records::SherdRecord& sherd : store::valueOrThrow(Sherds(catalogue_).of(rows)))
      if (const auto counter = scheme.counter(numberTokens(catalogue_, sherd)))
        counters.insert(*counter);
    std::vector<int> gaps;
    for (const std::string& counter : counters) {
      std::int64_t expected = first;
      for (const std::int64_t n : givenIn(*database_, NumberCount(counter))) {
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
