// Numbers typed onto the plate's picture follow their sherds by the places of the fronts.
#include "sherds/typed_numbers.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/message.h"
#include "catalogue/batches.h"
#include "catalogue/label_codes.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "records/numbering.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/photographed_again.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "store/names.h"

namespace ostraka::sherds {
namespace {

using nlohmann::json;

// The middle of an outline seen from the side lies a few mm from the middle of the scan; sherds lie
// further apart.
constexpr double kReach_mm = 20;
constexpr std::size_t kMostDigits = 6;

std::string keyOf(const catalogue::Catalogue& catalogue, store::BatchRow batch) {
  return kTypedNumbers + store::valueOrThrow(catalogue::Batches(catalogue).get(batch)).number;
}

std::vector<TypedNumber> parsed(const std::string& text) {
  std::vector<TypedNumber> numbers;
  const json list = jsonOrDiscarded(text);
  if (!list.is_array()) return numbers;
  for (const json& one : list)
    if (one.is_object())
      numbers.push_back(
          {{numberOr(one, "x_mm", 0.0), numberOr(one, "y_mm", 0.0)}, one.value("number", "")});
  return numbers;
}

std::string textOf(std::span<const TypedNumber> numbers) {
  json list = json::array();
  for (const TypedNumber& typed : numbers)
    list.push_back(
        {{"x_mm", typed.at_mm.x()}, {"y_mm", typed.at_mm.y()}, {"number", typed.number}});
  return list.empty() ? std::string() : list.dump();
}

int nearest(const Eigen::Vector2d& to, std::span<const Eigen::Vector2d> places) {
  int best = -1;
  double least = kReach_mm;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const double distance = (places[i] - to).norm(); distance < least) {
      least = distance;
      best = static_cast<int>(i);
    }
  return best;
}

// A sherd without a number is called by its place on its label, B0031-01; where the project's
// scheme gives such numbers, {batch}-{n:02}, it is one. Without an id only a place was printed.
bool namesNoNumber(const catalogue::Catalogue& catalogue, const catalogue::LabelCode& label) {
  if (!label.isPlaceOnPlate()) return false;
  if (label.id_end.empty()) return true;
  const std::size_t dash = label.number.find('-');
  const std::string batch = label.number.substr(0, dash), year = batch.substr(1);
  const std::string n = label.number.substr(dash + 1);
  if (n.size() > kMostDigits) return false;
  const Result<std::string> given =
      schemeOf(catalogue).number({{"batch", batch}, {"yyyy", year}, {"yy", year}}, std::stoi(n));
  return !given || store::uniqueKey(*given) != store::uniqueKey(label.number);
}

// What a sherd of this batch has that is known of it: where it is from, if its bag says so.
records::SherdRecord placeOnPlate(const catalogue::Catalogue& catalogue, store::BatchRow batch) {
  records::SherdRecord sherd;
  const records::BatchRecord record = store::valueOrThrow(catalogue::Batches(catalogue).get(batch));
  sherd.batch = batch;
  sherd.batch_number = record.number;
  for (const records::BagRecord& bag : store::valueOrThrow(catalogue::Places(catalogue).bags()))
    if (record.bags.size() == 1 && bag.row == record.bags.front()) {
      const records::ContextRecord place =
          store::valueOrThrow(catalogue::Places(catalogue).context(bag.context));
      sherd.site = place.site_code;
      sherd.trench = place.trench_code;
      sherd.context_number = place.number;
      sherd.bag_number = bag.number;
    }
  return sherd;
}

// Its number may be another, or there be one at all, since the label was printed.
std::string numberOfLabel(const catalogue::Catalogue& catalogue, const std::string& code) {
  const std::optional<catalogue::LabelCode> label = catalogue::readLabelCode(code);
  if (!label)
    store::refuse(message("This is only part of a sherd's label; scan its code again."), code);
  std::string number = namesNoNumber(catalogue, *label) ? std::string() : label->number;
  if (const store::SherdRow known =
          store::valueOrThrow(catalogue::sherdOfLabel(catalogue, *label))) {
    const records::SherdRecord sherd = store::valueOrThrow(Sherds(catalogue).get(known));
    if (!sherd.number.empty() || label->isPlaceOnPlate()) number = sherd.number;
  }
  if (number.empty()) store::refuse(message("The sherd of this label has no number yet."), code);
  return number;
}

std::string wholeOf(const catalogue::Catalogue& catalogue, const records::SherdRecord& place,
                    const std::string& typed) {
  const std::string text = store::trimmed(typed);
  if (catalogue::beginsAsSherdLabel(text)) return numberOfLabel(catalogue, text);
  if (text.starts_with('=')) {
    const std::string itself = store::trimmed(std::string_view(text).substr(1));
    if (itself.empty()) store::refuse(message("Enter a number after =."), text);
    return itself;
  }
  if (text.empty() || text.size() > kMostDigits ||
      text.find_first_not_of("0123456789") != std::string::npos)
    return text;
  return store::valueOrThrow(
      schemeOf(catalogue).number(numberTokens(catalogue, place), std::stoi(text)));
}

}  // namespace

std::set<std::string> typedEverywhere(const catalogue::Catalogue& catalogue) {
  std::set<std::string> keys;
  store::Statement rows = catalogue.database().sql(
      "SELECT value FROM setting WHERE key >= ?1 AND key < ?1 || char(1114111)",
      std::string(kTypedNumbers));
  for (std::string text; rows.read(text);)
    for (const TypedNumber& typed : parsed(text)) keys.insert(store::uniqueKey(typed.number));
  return keys;
}

std::map<std::string, std::string> typedAndWaiting(const catalogue::Catalogue& catalogue) {
  std::map<std::string, std::string> waiting;
  store::Statement rows = catalogue.database().sql(
      "SELECT b.number, s.value FROM batch b JOIN setting s ON s.key = ? || b.number WHERE b.state "
      "<> 'failed' AND NOT EXISTS (SELECT 1 FROM scan WHERE scan.batch = b.row)",
      std::string(kTypedNumbers));
  for (std::string batch, text; rows.read(batch, text);)
    for (const TypedNumber& typed : parsed(text)) waiting[store::uniqueKey(typed.number)] = batch;
  return waiting;
}

Result<std::vector<TypedNumber>> typedNumbers(const catalogue::Catalogue& catalogue,
                                              store::BatchRow batch) {
  return catalogue.database().asResult([&] {
    return parsed(
        store::valueOrThrow(catalogue::Settings(catalogue).value(keyOf(catalogue, batch))));
  });
}

Result<void> setTypedNumbers(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                             std::span<const TypedNumber> numbers,
                             const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    const std::string own = store::valueOrThrow(catalogue::Batches(catalogue).get(batch)).number;
    std::set<std::string> stood, seen;
    for (const TypedNumber& typed : store::valueOrThrow(typedNumbers(catalogue, batch)))
      stood.insert(store::uniqueKey(typed.number));
    const std::map<std::string, std::string> waiting = typedAndWaiting(catalogue);
    for (const TypedNumber& typed : numbers) {
      const std::string number = store::uniqueKey(typed.number);
      if (!seen.insert(number).second)
        store::refuse(message("The number %1 appears on two sherds of this plate.", typed.number),
                      typed.number);
      if (stood.contains(number)) continue;  // what is wrong with it hinders no other
      if (store::hasInvisible(typed.number))
        store::refuse(
            message("A number or code cannot contain invisible characters; type it again."),
            typed.number);
      const Taken taken = takenBy(database, typed.number);
      const records::SherdRecord holder =
          taken.sherd ? store::valueOrThrow(Sherds(catalogue).get(taken.sherd))
                      : records::SherdRecord();
      const bool may =
          !taken.sherd || holder.batch == batch ||
          (waitsForPhotographs(catalogue, holder) && store::uniqueKey(holder.number) == number);
      const auto elsewhere = waiting.find(number);
      if (!may || (elsewhere != waiting.end() && elsewhere->second != own))
        store::refuse(message("The number %1 already belongs to another sherd.", typed.number),
                      typed.number);
    }
    store::valueOrThrow(catalogue::Settings(catalogue).setValue(keyOf(catalogue, batch),
                                                                textOf(numbers), provenance));
  });
}

void forgetTyped(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                 const std::string& number, const records::Provenance& provenance) {
  std::vector<TypedNumber> left = store::valueOrThrow(typedNumbers(catalogue, batch));
  const std::size_t erased = std::erase_if(left, [&](const TypedNumber& typed) {
    return store::uniqueKey(typed.number) == store::uniqueKey(number);
  });
  if (erased > 0)
    store::valueOrThrow(
        catalogue::Settings(catalogue).setValue(keyOf(catalogue, batch), textOf(left), provenance));
}

Result<std::string> wholeNumber(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                                const std::string& typed) {
  return catalogue.database().asResult(
      [&] { return wholeOf(catalogue, placeOnPlate(catalogue, batch), typed); });
}

Result<std::string> wholeNumber(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                                const std::string& typed) {
  return catalogue.database().asResult(
      [&] { return wholeOf(catalogue, store::valueOrThrow(Sherds(catalogue).get(sherd)), typed); });
}

Result<bool> fitsTheBatch(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                          const std::string& number) {
  return catalogue.database().asResult([&] {
    return store::valueOrThrow(fitsThePlace(catalogue, placeOnPlate(catalogue, batch), number));
  });
}

Result<bool> fitsThePlace(const catalogue::Catalogue& catalogue, const records::SherdRecord& place,
                          const std::string& number) {
  return catalogue.database().asResult([&] {
    std::string digits;
    for (std::size_t i = 0; i <= number.size(); ++i) {
      if (i < number.size() && number[i] >= '0' && number[i] <= '9') {
        digits += number[i];
        continue;
      }
      if (!digits.empty() && digits.size() <= kMostDigits &&
          store::uniqueKey(wholeOf(catalogue, place, digits)) == store::uniqueKey(number))
        return true;
      digits.clear();
    }
    return false;
  });
}

std::vector<int> placesOf(std::span<const TypedNumber> numbers,
                          std::span<const Eigen::Vector2d> places_mm) {
  std::vector<Eigen::Vector2d> typed;
  for (const TypedNumber& number : numbers) typed.push_back(number.at_mm);
  std::vector<int> found;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    const int place = nearest(typed[i], places_mm);
    const bool mutual = place >= 0 && nearest(places_mm[static_cast<std::size_t>(place)], typed) ==
                                          static_cast<int>(i);
    found.push_back(mutual ? place : -1);
  }
  return found;
}

std::map<store::ScanRow, Eigen::Vector2d> typedOn(const catalogue::Catalogue& catalogue,
                                                  store::BatchRow batch) {
  std::map<std::string, Eigen::Vector2d> places;
  for (const TypedNumber& typed : store::valueOrThrow(typedNumbers(catalogue, batch)))
    places[store::uniqueKey(typed.number)] = typed.at_mm;
  std::map<store::ScanRow, Eigen::Vector2d> typed_on;
  if (places.empty()) return typed_on;
  for (const records::SherdRecord& sherd : store::valueOrThrow(
           Sherds(catalogue).of(store::valueOrThrow(Sherds(catalogue).rows(batch)))))
    if (const auto place = places.find(store::uniqueKey(sherd.number));
        place != places.end() && sherd.front)
      typed_on[sherd.front] = place->second;
  return typed_on;
}

Result<std::vector<std::string>> giveTypedNumbers(const catalogue::Catalogue& catalogue,
                                                  store::BatchRow batch,
                                                  const records::Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    std::vector<std::string> left;
    const std::vector<TypedNumber> typed = store::valueOrThrow(typedNumbers(catalogue, batch));
    if (typed.empty()) return left;
    std::vector<Eigen::Vector2d> places;
    std::vector<store::ScanRow> fronts;
    for (const records::ScanRecord& scan :
         store::valueOrThrow(catalogue::Batches(catalogue).scans(batch))) {
      if (!scan.isThere() || scan.side != batch::Side::Front) continue;
      if (!scan.plate_x_mm || !scan.plate_y_mm) continue;
      places.emplace_back(*scan.plate_x_mm, *scan.plate_y_mm);
      fronts.push_back(scan.row);
    }
    const std::vector<int> place_of = placesOf(typed, places);
    const auto sherds = store::valueOrThrow(
        Sherds(catalogue).of(store::valueOrThrow(Sherds(catalogue).rows(batch))));
    for (std::size_t i = 0; i < typed.size(); ++i) {
      const auto sherd = std::ranges::find_if(sherds, [&](const records::SherdRecord& s) {
        return place_of[i] >= 0 && s.front == fronts[static_cast<std::size_t>(place_of[i])];
      });
      if (sherd != sherds.end() && sherd->number.empty() &&
          sherd->state == records::SherdState::Draft) {
        const store::SherdRow holder = takenBy(catalogue.database(), typed[i].number).sherd;
        if (holder == sherd->row) continue;  // a person took it away again
        const records::SherdRecord known =
            holder ? store::valueOrThrow(Sherds(catalogue).get(holder)) : records::SherdRecord();
        if (waitsForPhotographs(catalogue, known) &&
            store::uniqueKey(known.number) == store::uniqueKey(typed[i].number)) {
          takeOver(catalogue, known, *sherd, provenance);
          continue;
        }
        const records::FieldChange number{sherd->row, "number", typed[i].number};
        if (SherdChanges(catalogue).apply(std::span(&number, 1), provenance)) continue;
      }
      if (sherd == sherds.end() ||
          store::uniqueKey(sherd->number) != store::uniqueKey(typed[i].number))
        left.push_back(typed[i].number);
    }
    return left;
  });
}

}  // namespace ostraka::sherds
