#include "sherds/numbers.h"

#include <algorithm>
#include <map>

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

struct Counted {
  std::string counter;
  std::optional<std::int64_t> n;
};

// Which n of the project's count a number is, when it has the scheme's form.
Counted countedIn(const catalogue::Catalogue& catalogue, const records::Numbering& scheme,
                  const records::SherdRecord& sherd, const std::string& number) {
  const Result<std::string> counter = scheme.counter(numberTokens(catalogue, sherd));
  if (!counter) return {};
  const std::size_t at = counter->find("{n}");
  const std::string before = counter->substr(0, at), after = counter->substr(at + 3);
  if (number.size() <= before.size() + after.size() || !number.starts_with(before) ||
      !number.ends_with(after))
    return {};
  const std::string digits =
      number.substr(before.size(), number.size() - before.size() - after.size());
  if (digits.size() > 12 || digits.find_first_not_of("0123456789") != std::string::npos) return {};
  return {*counter, std::stoll(digits)};
}

// The block of numbers of this computer (settings numbering.first and numbering.last), so that two
// laptops in the field never give the same number.
std::int64_t settingNumber(const catalogue::Catalogue& catalogue, const char* key,
                           std::int64_t otherwise) {
  const std::string text = store::valueOrThrow(catalogue::Settings(catalogue).value(key));
  if (text.empty()) return otherwise;
  return static_cast<std::int64_t>(store::valueOrThrow(store::parsedNumber(text)));
}

// After the highest of the block that this computer gives.
std::int64_t nextOf(store::Database& database, const std::string& counter, std::int64_t first,
                    std::int64_t last) {
  return database
      .sql(
          "SELECT ifnull(max(n) + 1, ?2) FROM given_number WHERE counter = ?1 AND n BETWEEN ?2 AND "
          "?3",
          counter, first, last)
      .one<std::int64_t>();
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
  if (!taken.sherd) {
    const Counted counted = countedIn(catalogue, schemeOf(catalogue), sherd, number);
    database.run("INSERT INTO given_number VALUES (?, ?, ?, ?, ?, ?, ?)", store::uniqueKey(number),
                 store::uniqueKey(store::slug(number)), number, sherd.row, catalogue.now(),
                 counted.counter, counted.n);
  }
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
    const std::int64_t last = settingNumber(catalogue_, "numbering.last", 999'999'999);
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
      // A sherd that had a number of this count before gets it back: it is nobody else's.
      store::Statement own = database_->sql(
          "SELECT number FROM given_number WHERE sherd = ? AND counter = ? ORDER BY n DESC LIMIT "
          "1",
          sherd.row, counter);
      std::string number;
      if (own.read(number)) {
        numbers.push_back(number);
        continue;
      }
      if (!next.contains(counter)) next[counter] = nextOf(*database_, counter, first, last);
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
      [&] { return static_cast<int>(nextOf(*database_, counter, first, last)); });
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

Result<std::vector<int>> Numbers::gaps(store::ContextRow context) const {
  return database_->asResult([&] {
    std::vector<int> gaps;
    store::Statement rows = database_->sql(
        "SELECT counter, n FROM given_number WHERE n IS NOT NULL AND counter IN (SELECT g.counter "
        "FROM given_number g JOIN sherd s ON s.row = g.sherd WHERE s.context = ? AND g.counter <> "
        "'') ORDER BY counter, n",
        context);
    std::string last_counter;
    std::int64_t expected = 1;
    std::string counter;
    std::int64_t n = 0;
    while (rows.read(counter, n)) {
      if (counter != last_counter) {
        last_counter = counter;
        expected = settingNumber(catalogue_, "numbering.first", 1);
      }
      for (; expected < n && gaps.size() < 10'000; ++expected)
        gaps.push_back(static_cast<int>(expected));
      expected = n + 1;
    }
    return gaps;
  });
}

}  // namespace ostraka::sherds
