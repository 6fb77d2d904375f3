#include "catalogue/places.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/history.h"
#include "catalogue/search.h"
#include "catalogue/stamped_rows.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

// As the catalogue's schema has them; empty: not said.
constexpr std::string_view kContextKinds[] = {"",          "layer",   "cut",         "fill",
                                              "structure", "surface", "unstratified"};

// A code or number that people read: composed, without blanks at its ends, not empty.
struct NeededText {
  Template<0> empty, too_long;
};
constexpr NeededText kPersonName{
    translatable<0>("The name of a person must not be empty."),
    translatable<0>("The name of a person must have at most 200 characters.")};
constexpr NeededText kInitials{
    translatable<0>("The person's initials must not be empty."),
    translatable<0>("The person's initials must have at most 200 characters.")};
constexpr NeededText kSiteCode{
    translatable<0>("The code of a site must not be empty."),
    translatable<0>("The code of a site must have at most 200 characters.")};
constexpr NeededText kTrenchCode{
    translatable<0>("The code of a trench must not be empty."),
    translatable<0>("The code of a trench must have at most 200 characters.")};
constexpr NeededText kContextNumber{
    translatable<0>("The number of a context must not be empty."),
    translatable<0>("The number of a context must have at most 200 characters.")};
constexpr NeededText kBagNumber{
    translatable<0>("The number of a bag must not be empty."),
    translatable<0>("The number of a bag must have at most 200 characters.")};

std::string needed(const std::string& text, const NeededText& words) {
  std::string checked = store::valueOrThrow(store::checkedText(text));
  if (checked.empty()) store::refuse(message(words.empty));
  if (checked.size() > 200) store::refuse(message(words.too_long), checked);
  return checked;
}

// What two places are told apart by; a person's name may need such letters.
std::string neededCode(const std::string& text, const NeededText& words) {
  std::string code = needed(text, words);
  if (store::hasInvisible(code) || code.find_first_of("\r\n\t") != std::string::npos)
    store::refuse(message("A number or code cannot contain invisible characters; type it again."),
                  code);
  return code;
}

std::string checked(const Result<std::string>& value, const char* where) {
  if (!value) throw store::Refused({value.error().code, value.error().what, where});
  return *value;
}

// The row that holds this key already, other than the one being saved.
void refuseDouble(store::Statement rows, std::int64_t own, const Message& what) {
  for (std::int64_t row = 0; rows.read(row);)
    if (row != own) store::refuse(what);
}

// Adds a row, which the history calls by its label, or changes the one that is there.
template <class Row>
Row saved(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
          Row row, const std::string& id, const std::string& label,
          const std::vector<Column>& columns) {
  if (!id.empty() && !isUuid(id)) store::refuse(message("The uuid is not well formed."), id);
  for (const Column& column : columns)
    checked(store::checkedText(column.value.told()), column.name);
  const Row now{saveRow(catalogue, provenance, table, row.value, id, columns)};
  if (!row) remember(catalogue, provenance, table, now.value, "", "", label);
  return now;
}
constexpr auto kFollows = Column::Changes::Untold;  // of keys: from the code or number

constexpr const char* kContexts =
    "SELECT context.row, context.site, context.trench, context.id, context.number, kind, "
    "excavated_on, period, date_edtf, note, closed, context.extra, site.code, trench.code FROM "
    "context "
    "JOIN site ON site.row = context.site LEFT JOIN trench ON trench.row = context.trench";

std::vector<records::ContextRecord> readContexts(store::Statement rows) {
  using C = records::ContextRecord;
  return rows.all(&C::row, &C::site, &C::trench, &C::id, &C::number, &C::kind, &C::excavated_on,
                  &C::period, &C::date_edtf, &C::note, &C::closed, &C::extra_json, &C::site_code,
                  &C::trench_code);
}

}  // namespace

Result<std::vector<records::PersonRecord>> People::all() const {
  return database_->asResult([&] {
    using P = records::PersonRecord;
    return database_->sql("SELECT row, id, name, initials, orcid FROM person ORDER BY initials_key")
        .all(&P::row, &P::id, &P::name, &P::initials, &P::orcid);
  });
}

Result<store::PersonRow> People::save(const records::PersonRecord& p,
                                      const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string name = needed(p.name, kPersonName);
    const std::string initials = needed(p.initials, kInitials);
    const std::string key = store::codeKey(initials);
    refuseDouble(database_->sql("SELECT row FROM person WHERE initials_key = ?", key), p.row.value,
                 message("The initials %1 already belong to another person.", initials));
    return saved(catalogue_, provenance, "person", p.row, p.id, initials,
                 {{"name", name},
                  {"initials", initials},
                  {"initials_key", key, kFollows},
                  {"orcid", p.orcid}});
  });
}

Result<store::PersonRow> People::byInitials(const std::string& initials,
                                            const records::Provenance& provenance) {
  const auto known = firstOf<store::PersonRow>("SELECT row FROM person WHERE initials_key = ?",
                                               store::codeKey(initials));
  if (!known || *known) return known;
  return save(records::PersonRecord{{}, {}, initials, initials, {}}, provenance);
}

Result<std::vector<records::SiteRecord>> Places::sites() const {
  return database_->asResult([&] {
    using S = records::SiteRecord;
    return database_
        ->sql(
            "SELECT row, id, code, name, gazetteer, latitude_deg, longitude_deg, location_public "
            "FROM site ORDER BY code_key")
        .all(&S::row, &S::id, &S::code, &S::name, &S::gazetteer, &S::latitude_deg,
             &S::longitude_deg, &S::location_public);
  });
}

Result<store::SiteRow> Places::save(const records::SiteRecord& s,
                                    const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string code = neededCode(s.code, kSiteCode), key = store::codeKey(code);
    if (s.latitude_deg && !(*s.latitude_deg >= -90 && *s.latitude_deg <= 90))
      store::refuse(message("The latitude must be between -90 and 90 degrees."), code);
    if (s.longitude_deg && !(*s.longitude_deg >= -180 && *s.longitude_deg <= 180))
      store::refuse(message("The longitude must be between -180 and 180 degrees."), code);
    refuseDouble(database_->sql("SELECT row FROM site WHERE code_key = ?", key), s.row.value,
                 message("The site %1 already exists.", code));
    const store::SiteRow row = saved(catalogue_, provenance, "site", s.row, s.id, code,
                                     {{"code", code},
                                      {"code_key", key, kFollows},
                                      {"name", s.name},
                                      {"latitude_deg", s.latitude_deg},
                                      {"longitude_deg", s.longitude_deg},
                                      {"location_public", s.location_public},
                                      {"gazetteer", s.gazetteer}});
    if (s.row) searchAnewIn(*database_, "site", row.value);
    return row;
  });
}

Result<std::vector<records::TrenchRecord>> Places::trenches() const {
  return database_->asResult([&] {
    using T = records::TrenchRecord;
    return database_
        ->sql(
            "SELECT row, site, id, code, name, parent FROM trench WHERE one_with IS NULL ORDER BY "
            "site, code_key")
        .all(&T::row, &T::site, &T::id, &T::code, &T::name, &T::parent);
  });
}

Result<bool> Places::hasTrenches(const std::string& site) const {
  return database_->asResult([&] {
    return database_
        ->sql(
            "SELECT EXISTS (SELECT 1 FROM trench JOIN site ON site.row = trench.site WHERE "
            "site.code_key = ? AND one_with IS NULL)",
            store::uniqueKey(site))
        .one<bool>();
  });
}

Result<store::TrenchRow> Places::save(const records::TrenchRecord& t,
                                      const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string code = neededCode(t.code, kTrenchCode), key = store::codeKey(code);
    if (!t.site) store::refuse(message("A trench needs a site."), code);
    if (t.parent && t.parent == t.row)
      store::refuse(message("A trench cannot contain itself."), code);
    refuseDouble(database_->sql(
                     "SELECT row FROM trench WHERE one_with IS NULL AND site = ? AND code_key = ?",
                     t.site, key),
                 t.row.value, message("The trench %1 already exists in this site.", code));
    const store::TrenchRow row = saved(catalogue_, provenance, "trench", t.row, t.id, code,
                                       {{"site", t.site},
                                        {"code", code},
                                        {"code_key", key, kFollows},
                                        {"name", t.name},
                                        {"parent", t.parent}});
    if (t.row) searchAnewIn(*database_, "trench", row.value);
    return row;
  });
}

Result<std::vector<records::ContextRecord>> Places::contexts() const {
  return database_->asResult([&] {
    return readContexts(
        database_->sql(std::string(kContexts) +
                       " WHERE context.one_with IS NULL ORDER BY site.code_key, trench.code_key, "
                       "context.number_key"));
  });
}

Result<records::ContextRecord> Places::context(store::ContextRow row) const {
  return database_->asResult([&] {
    const auto found =
        readContexts(database_->sql(std::string(kContexts) + " WHERE context.row = ?", row));
    if (found.empty()) store::refuse(message("This context is no longer in the catalogue."));
    return found.front();
  });
}

Result<store::ContextRow> Places::contextByPlace(const std::string& site, const std::string& trench,
                                                 const std::string& number) const {
  return firstOf<store::ContextRow>(
      "SELECT context.row FROM context JOIN site ON site.row = context.site LEFT JOIN trench ON "
      "trench.row = context.trench WHERE context.one_with IS NULL AND context.number_key = ? AND "
      "site.code_key = ? AND ifnull(trench.code_key, '') = ?",
      store::codeKey(number), store::codeKey(site), store::codeKey(trench));
}

Result<store::ContextRow> Places::contextAt(const std::string& site, const std::string& trench,
                                            const std::string& number,
                                            const records::Provenance& provenance,
                                            std::vector<std::string>& made) {
  return database_->inTransaction([&] {
    records::ContextRecord context;
    context.number = number;
    context.site = database_->sql("SELECT row FROM site WHERE code_key = ?", store::codeKey(site))
                       .one<store::SiteRow>();
    if (!context.site) {
      records::SiteRecord record;
      record.code = record.name = site;
      context.site = store::valueOrThrow(save(record, provenance));
      made.push_back(site);
    }
    if (!trench.empty())
      context.trench = database_
                           ->sql(
                               "SELECT row FROM trench WHERE one_with IS NULL AND site = ? AND "
                               "code_key = ?",
                               context.site, store::codeKey(trench))
                           .one<store::TrenchRow>();
    if (!trench.empty() && !context.trench) {
      records::TrenchRecord record;
      record.site = context.site;
      record.code = trench;
      context.trench = store::valueOrThrow(save(record, provenance));
      made.push_back(site + " " + trench);
    }
    const auto known = database_
                           ->sql(
                               "SELECT row FROM context WHERE one_with IS NULL AND site = ? AND "
                               "ifnull(trench, 0) = ifnull(?, 0) AND number_key = ?",
                               context.site, context.trench, store::codeKey(number))
                           .one<store::ContextRow>();
    return known ? known : store::valueOrThrow(save(context, provenance));
  });
}

Result<store::BagRow> Places::bagByNumber(store::ContextRow context,
                                          const std::string& number) const {
  return firstOf<store::BagRow>(
      "SELECT row FROM bag WHERE one_with IS NULL AND context = ? AND number_key = ?", context,
      store::codeKey(number));
}

Result<store::BagRow> Places::bagAt(store::ContextRow context, const std::string& number,
                                    const records::Provenance& provenance) {
  const Result<store::BagRow> known = bagByNumber(context, number);
  if (!known || *known) return known;
  records::BagRecord bag;
  bag.context = context;
  bag.number = number;
  return save(bag, provenance);
}

Result<store::ContextRow> Places::save(const records::ContextRecord& c,
                                       const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string number = neededCode(c.number, kContextNumber), key = store::codeKey(number);
    if (!c.site) store::refuse(message("A context needs a site."), number);
    if (std::find(std::begin(kContextKinds), std::end(kContextKinds), c.kind) ==
        std::end(kContextKinds))
      store::refuse(
          message("'%1' is not a kind of context; use layer, cut, fill, structure, surface or "
                  "unstratified.",
                  c.kind));
    const std::string day = checked(store::checkedDay(c.excavated_on), "excavated_on");
    const std::string edtf = checked(store::checkedEdtf(c.date_edtf), "date_edtf");
    if (c.trench) {
      store::Statement inside =
          database_->sql("SELECT 1 FROM trench WHERE row = ? AND site = ?", c.trench, c.site);
      if (!inside.next())
        store::refuse(message("The trench and the context belong to different sites."), number);
    }
    refuseDouble(database_->sql("SELECT row FROM context WHERE one_with IS NULL AND site = ? AND "
                                "ifnull(trench, 0) = ifnull(?, 0) AND number_key = ?",
                                c.site, c.trench, key),
                 c.row.value, message("The context %1 already exists in this place.", number));
    const store::ContextRow row = saved(catalogue_, provenance, "context", c.row, c.id, number,
                                        {{"site", c.site},
                                         {"trench", c.trench},
                                         {"number", number},
                                         {"number_key", key, kFollows},
                                         {"kind", c.kind},
                                         {"excavated_on", day},
                                         {"period", c.period},
                                         {"date_edtf", edtf},
                                         {"closed", c.closed},
                                         {"note", c.note},
                                         {"extra", c.extra_json}});
    if (c.row) searchAnewIn(*database_, "row", row.value);
    return row;
  });
}

Result<std::vector<records::BagRecord>> Places::bags() const {
  return bags(store::ContextRow{});
}

Result<std::vector<records::BagRecord>> Places::bags(store::ContextRow context) const {
  return database_->asResult([&] {
    using B = records::BagRecord;
    return database_
        ->sql(
            "SELECT row, context, id, number, collected_on, storage, count_written, weight_g, "
            "(SELECT count(*) FROM sherd WHERE sherd.bag = bag.row AND sherd.state <> 'void'), "
            "ifnull((SELECT initials FROM person WHERE person.row = bag.created_by), '') FROM bag "
            "WHERE one_with IS NULL AND (?1 IS NULL OR context = ?1) ORDER BY context, "
            "number_key",
            context)
        .all(&B::row, &B::context, &B::id, &B::number, &B::collected_on, &B::storage,
             &B::count_written, &B::weight_g, &B::sherds, &B::entered_by);
  });
}

Result<store::BagRow> Places::save(const records::BagRecord& b,
                                   const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string number = neededCode(b.number, kBagNumber), key = store::codeKey(number);
    if (!b.context) store::refuse(message("A bag needs a context."), number);
    const std::string day = checked(store::checkedDay(b.collected_on), "collected_on");
    if (b.weight_g && !(*b.weight_g > 0))
      store::refuse(message("The weight of a bag must be greater than 0 g."), number);
    if (b.count_written && *b.count_written < 0)
      store::refuse(message("A count cannot be less than 0."), number);
    refuseDouble(
        database_->sql(
            "SELECT row FROM bag WHERE one_with IS NULL AND context = ? AND number_key = ?",
            b.context, key),
        b.row.value, message("The bag %1 already exists in this context.", number));
    return saved(catalogue_, provenance, "bag", b.row, b.id, number,
                 {{"context", b.context},
                  {"number", number},
                  {"number_key", key, kFollows},
                  {"collected_on", day},
                  {"storage", b.storage},
                  {"count_written", b.count_written},
                  {"weight_g", b.weight_g}});
  });
}

}  // namespace ostraka::catalogue
