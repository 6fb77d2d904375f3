// From the codes of printed labels back to sherds and bags.
#include "catalogue/label_codes.h"

#include "catalogue/places.h"

#include <algorithm>
#include <cctype>

#include "store/database.h"
#include "store/names.h"

namespace ostraka::catalogue {
namespace {

constexpr std::string_view kSherdLabel = "ost1:s:", kBagLabel = "ost1:b:";
constexpr std::size_t kIdEnd = 8;  // as they are printed

bool beginsWith(std::string_view text, std::string_view start) {
  return text.size() > start.size() && store::uniqueKey(text.substr(0, start.size())) == start;
}

bool isPlace(std::string_view text) {
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t dash = text.find('-');
  return dash != std::string_view::npos && (text[0] == 'B' || text[0] == 'b') &&
         digits(text.substr(1, dash - 1)) && digits(text.substr(dash + 1));
}

std::optional<BagPlace> placeBy(const Catalogue& catalogue, const std::string& condition,
                                const auto& value) {
  store::Statement rows = catalogue.database().sql(
      "WITH RECURSIVE named AS (SELECT * FROM bag WHERE " + condition +
          " UNION ALL SELECT bag.* FROM named JOIN bag ON bag.row = named.one_with) SELECT "
          "site.code, trench.code, context.number, named.number FROM named JOIN context ON "
          "context.row = named.context JOIN site ON site.row = context.site LEFT JOIN trench ON "
          "trench.row = context.trench WHERE named.one_with IS NULL",
      value);
  BagPlace place;
  if (!rows.read(place.site, place.trench, place.context, place.bag)) return {};
  return place;
}

}  // namespace

bool LabelCode::isPlaceOnPlate() const {
  return of == Of::Sherd && isPlace(number);
}

bool beginsAsSherdLabel(std::string_view text) {
  return beginsWith(text, kSherdLabel);
}

std::optional<LabelCode> readLabelCode(std::string_view text) {
  const std::string whole = store::trimmed(text);
  LabelCode label;
  if (beginsWith(whole, kBagLabel))
    label.of = LabelCode::Of::Bag;
  else if (!beginsWith(whole, kSherdLabel))
    return {};
  label.number = whole.substr(kSherdLabel.size());
  // A number may hold colons of its own.
  if (const std::size_t colon = label.number.rfind(':'); colon != std::string::npos) {
    label.id_end = store::uniqueKey(label.number.substr(colon + 1));
    label.number.resize(colon);
  }
  const bool whole_end = label.id_end.size() == kIdEnd &&
                         std::all_of(label.id_end.begin(), label.id_end.end(), [](char c) {
                           return std::isalnum(static_cast<unsigned char>(c)) != 0;
                         });
  if (label.number.empty() || (!whole_end && !label.isPlaceOnPlate())) return {};
  if (!whole_end && !label.id_end.empty()) return {};
  return label;
}

Result<store::SherdRow> sherdOfLabel(const Catalogue& catalogue, const LabelCode& label) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    if (!label.id_end.empty())
      return database
          .sql("SELECT row FROM sherd WHERE substr(replace(id, '-', ''), -8) = ?", label.id_end)
          .one<store::SherdRow>();
    const std::size_t dash = label.number.find('-');
    if (dash == std::string::npos || !label.isPlaceOnPlate()) return store::SherdRow();
    return database
        .sql(
            "SELECT sherd.row FROM sherd JOIN scan ON scan.row = sherd.front JOIN batch ON "
            "batch.row = scan.batch WHERE batch.number = ? COLLATE NOCASE AND scan.position = "
            "CAST(? AS INTEGER)",
            label.number.substr(0, dash), label.number.substr(dash + 1))
        .one<store::SherdRow>();
  });
}

Result<std::optional<BagPlace>> placeOfLabel(const Catalogue& catalogue, const LabelCode& label) {
  return catalogue.database().asResult([&]() -> std::optional<BagPlace> {
    if (label.of != LabelCode::Of::Bag || label.id_end.empty()) return {};
    return placeBy(catalogue, "substr(replace(id, '-', ''), -8) = ?", label.id_end);
  });
}

Result<std::optional<BagPlace>> placeOf(const Catalogue& catalogue, store::BagRow bag) {
  return catalogue.database().asResult([&] { return placeBy(catalogue, "row = ?", bag); });
}

Result<std::optional<BagPlace>> placeOf(const Catalogue& catalogue,
                                        const records::BatchRecord& batch) {
  return catalogue.database().asResult([&]() -> std::optional<BagPlace> {
    if (batch.bags.empty()) return {};
    const store::BagRow first = batch.bags.front();
    int contexts = 0, at_first = 0, bags = 0, without_bag = 0;
    store::ContextRow context;
    store::BagRow bag;
    {
      store::Statement sherds = catalogue.database().sql(
          "SELECT count(DISTINCT context), count(CASE WHEN context = (SELECT context FROM bag "
          "WHERE row = ?2) THEN 1 END), count(DISTINCT bag), count(*) - count(bag), min(context), "
          "min(bag) FROM sherd WHERE batch = ?1 AND state <> 'void' AND context IS NOT NULL",
          batch.row, first);
      sherds.read(contexts, at_first, bags, without_bag, context, bag);
    }
    if (contexts != 1 || at_first > 0) return placeBy(catalogue, "row = ?", first);
    if (bags == 1 && without_bag == 0) return placeBy(catalogue, "row = ?", bag);
    const auto known = store::valueOrThrow(Places(catalogue).context(context));
    return BagPlace{known.site_code, known.trench_code, known.number, {}};
  });
}

Result<store::BagRow> bagAt(const Catalogue& catalogue, const BagPlace& place,
                            const records::Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    std::vector<std::string> made;
    const store::ContextRow context = store::valueOrThrow(
        Places(catalogue).contextAt(place.site, place.trench, place.context, provenance, made));
    return store::valueOrThrow(Places(catalogue).bagAt(context, place.bag, provenance));
  });
}

}  // namespace ostraka::catalogue
