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
  const Result<std::string> checked = store::checkedText(text);
  if (!checked) throw store::Refused(checked.error());
  if (checked->empty()) store::refuse(message(words.empty));
  if (checked->size() > 200) store::refuse(message(words.too_long), *checked);
  return *checked;
}

// What two places are told apart by; a person's name may need such letters.
std::string neededCode(const std::string& text, const NeededText& words) {
  std::string code = needed(text, words);
  if (store::hasInvisible(code))
    store::refuse(message("A number or code cannot contain invisible characters; type it again."),
                  code);
  return code;
}

std::string checked(const Result<std::string>& value, const char* where) {
  if (!value) throw store::Refused({value.error().code, value.error().what, where});
  return *value;
}

std::string typedKey(const std::string& text) {
  return store::uniqueKey(store::trimmed(text));
}

// The row that holds this key already, other than the one being saved.
void refuseDouble(store::Statement rows, std::int64_t own, const Message& what) {
  for (std::int64_t row = 0; rows.read(row);)
    if (row != own) store::refuse(what);
}

// Adds an empty row with what every table has, or changes the stamp of the row that is there.
class Saving {
 public:
  Saving(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
         std::int64_t row, const std::string& id)
      : catalogue_(catalogue), provenance_(provenance), table_(table), row_(row), id_(id) {
    if (!id.empty() && !isUuid(id)) store::refuse(message("The uuid is not well formed."), id);
  }

  template <class... Values>
  std::int64_t done(const char* columns, const std::string& label,
                    const std::vector<SavedField>& fields, const Values&... values) {
    for (const SavedField& field : fields) checked(store::checkedText(field.value), field.name);
    if (row_ == 0) {
      row_ = addRow(catalogue_, provenance_, table_, id_, columns, values...);
      remember(catalogue_, provenance_, table_, row_, "", "", label);
    } else if (rememberDifferences(catalogue_, provenance_, table_, row_, fields)) {
      changeRow(catalogue_, provenance_, table_, row_, columns, values...);
    }
    return row_;
  }

 private:
  const Catalogue& catalogue_;
  const records::Provenance& provenance_;
  const char* table_;
  std::int64_t row_;
  std::string id_;
};

constexpr const char* kContexts =
    "SELECT context.row, context.site, context.trench, context.id, context.number, kind, "
    "excavated_on, period, date_edtf, note, closed, context.extra, site.code, trench.code FROM "
    "context "
    "JOIN site ON site.row = context.site LEFT JOIN trench ON trench.row = context.trench";

records::ContextRecord readContext(store::Statement& row) {
  records::ContextRecord c;
  row >> c.row >> c.site >> c.trench >> c.id >> c.number >> c.kind >> c.excavated_on >> c.period >>
      c.date_edtf >> c.note >> c.closed >> c.extra_json >> c.site_code >> c.trench_code;
  return c;
}

// After a place was renamed, the sherds in it are found by the new name.
void searchAnew(store::Database& database, const char* which, std::int64_t row) {
  const std::string update =
      std::string("UPDATE sherd_text SET words = (SELECT ") + kSearchedWords +
      " FROM sherd_words WHERE sherd = sherd_text.rowid) WHERE rowid IN (SELECT sherd.row FROM "
      "sherd JOIN context ON context.row = sherd.context WHERE context." +
      which + " = ?)";
  database.run(update, row);
}

}  // namespace

Result<std::vector<records::PersonRecord>> People::all() const {
  return database_->asResult([&] {
    std::vector<records::PersonRecord> all;
    store::Statement rows =
        database_->sql("SELECT row, id, name, initials, orcid FROM person ORDER BY initials_key");
    for (records::PersonRecord p; rows.read(p.row, p.id, p.name, p.initials, p.orcid);)
      all.push_back(p);
    return all;
  });
}

Result<store::PersonRow> People::save(const records::PersonRecord& p,
                                      const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string name = needed(p.name, kPersonName);
    const std::string initials = needed(p.initials, kInitials);
    const std::string key = store::uniqueKey(initials);
    refuseDouble(database_->sql("SELECT row FROM person WHERE initials_key = ?", key), p.row.value,
                 message("The initials %1 already belong to another person.", initials));
    return store::PersonRow{Saving(catalogue_, provenance, "person", p.row.value, p.id)
                                .done("name initials initials_key orcid", initials,
                                      {{"name", name}, {"initials", initials}, {"orcid", p.orcid}},
                                      name, initials, key, p.orcid)};
  });
}

Result<store::PersonRow> People::byInitials(const std::string& initials,
                                            const records::Provenance& provenance) {
  const Result<store::PersonRow> known = database_->asResult([&] {
    return database_->sql("SELECT row FROM person WHERE initials_key = ?", typedKey(initials))
        .one<store::PersonRow>();
  });
  if (!known || *known) return known;
  return save(records::PersonRecord{{}, {}, initials, initials, {}}, provenance);
}

Result<std::vector<records::SiteRecord>> Places::sites() const {
  return database_->asResult([&] {
    std::vector<records::SiteRecord> all;
    store::Statement rows = database_->sql(
        "SELECT row, id, code, name, gazetteer, latitude_deg, longitude_deg, location_public FROM "
        "site ORDER BY code_key");
    for (records::SiteRecord s; rows.read(s.row, s.id, s.code, s.name, s.gazetteer, s.latitude_deg,
                                          s.longitude_deg, s.location_public);)
      all.push_back(s);
    return all;
  });
}

Result<store::SiteRow> Places::save(const records::SiteRecord& s,
                                    const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string code = neededCode(s.code, kSiteCode), key = store::uniqueKey(code);
    if (s.latitude_deg && !(*s.latitude_deg >= -90 && *s.latitude_deg <= 90))
      store::refuse(message("The latitude must be between -90 and 90 degrees."), code);
    if (s.longitude_deg && !(*s.longitude_deg >= -180 && *s.longitude_deg <= 180))
      store::refuse(message("The longitude must be between -180 and 180 degrees."), code);
    refuseDouble(database_->sql("SELECT row FROM site WHERE code_key = ?", key), s.row.value,
                 message("The site %1 already exists.", code));
    const store::SiteRow row{
        Saving(catalogue_, provenance, "site", s.row.value, s.id)
            .done("code code_key name latitude_deg longitude_deg location_public gazetteer", code,
                  {{"code", code},
                   {"name", s.name},
                   {"latitude_deg", optionalText(s.latitude_deg)},
                   {"longitude_deg", optionalText(s.longitude_deg)},
                   {"location_public", s.location_public ? "1" : "0"},
                   {"gazetteer", s.gazetteer}},
                  code, key, s.name, s.latitude_deg, s.longitude_deg, s.location_public,
                  s.gazetteer)};
    if (s.row) searchAnew(*database_, "site", row.value);
    return row;
  });
}

Result<std::vector<records::TrenchRecord>> Places::trenches() const {
  return database_->asResult([&] {
    std::vector<records::TrenchRecord> all;
    store::Statement rows = database_->sql(
        "SELECT row, site, id, code, name, parent FROM trench ORDER BY site, code_key");
    for (records::TrenchRecord t; rows.read(t.row, t.site, t.id, t.code, t.name, t.parent);)
      all.push_back(t);
    return all;
  });
}

Result<store::TrenchRow> Places::save(const records::TrenchRecord& t,
                                      const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string code = neededCode(t.code, kTrenchCode), key = store::uniqueKey(code);
    if (!t.site) store::refuse(message("A trench needs a site."), code);
    if (t.parent && t.parent == t.row)
      store::refuse(message("A trench cannot contain itself."), code);
    refuseDouble(
        database_->sql("SELECT row FROM trench WHERE site = ? AND code_key = ?", t.site, key),
        t.row.value, message("The trench %1 already exists in this site.", code));
    const store::TrenchRow row{Saving(catalogue_, provenance, "trench", t.row.value, t.id)
                                   .done("site code code_key name parent", code,
                                         {{"site", rowText(t.site.value)},
                                          {"code", code},
                                          {"name", t.name},
                                          {"parent", rowText(t.parent.value)}},
                                         t.site, code, key, t.name, t.parent)};
    if (t.row) searchAnew(*database_, "trench", row.value);
    return row;
  });
}

Result<std::vector<records::ContextRecord>> Places::contexts() const {
  return database_->asResult([&] {
    std::vector<records::ContextRecord> all;
    store::Statement rows = database_->sql(
        std::string(kContexts) + " ORDER BY site.code_key, trench.code_key, context.number_key");
    while (rows.next()) all.push_back(readContext(rows));
    return all;
  });
}

Result<records::ContextRecord> Places::context(store::ContextRow row) const {
  return database_->asResult([&] {
    store::Statement rows = database_->sql(std::string(kContexts) + " WHERE context.row = ?", row);
    if (!rows.next()) store::refuse(message("This context is no longer in the catalogue."));
    return readContext(rows);
  });
}

Result<store::ContextRow> Places::contextByPlace(const std::string& site, const std::string& trench,
                                                 const std::string& number) const {
  return database_->asResult([&] {
    return database_
        ->sql(
            "SELECT context.row FROM context JOIN site ON site.row = context.site LEFT JOIN trench "
            "ON "
            "trench.row = context.trench WHERE context.number_key = ? AND site.code_key = ? AND "
            "ifnull(trench.code_key, '') = ?",
            store::uniqueKey(number), store::uniqueKey(site), store::uniqueKey(trench))
        .one<store::ContextRow>();
  });
}

Result<store::ContextRow> Places::contextAt(const std::string& site, const std::string& trench,
                                            const std::string& number,
                                            const records::Provenance& provenance,
                                            std::vector<std::string>& made) {
  return database_->inTransaction([&] {
    records::ContextRecord context;
    context.number = number;
    context.site = database_->sql("SELECT row FROM site WHERE code_key = ?", typedKey(site))
                       .one<store::SiteRow>();
    if (!context.site) {
      records::SiteRecord record;
      record.code = record.name = site;
      context.site = store::valueOrThrow(save(record, provenance));
      made.push_back(site);
    }
    if (!trench.empty())
      context.trench = database_
                           ->sql("SELECT row FROM trench WHERE site = ? AND code_key = ?",
                                 context.site, typedKey(trench))
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
                               "SELECT row FROM context WHERE site = ? AND ifnull(trench, 0) = "
                               "ifnull(?, 0) AND number_key = ?",
                               context.site, context.trench, typedKey(number))
                           .one<store::ContextRow>();
    return known ? known : store::valueOrThrow(save(context, provenance));
  });
}

Result<store::BagRow> Places::bagByNumber(store::ContextRow context,
                                          const std::string& number) const {
  return database_->asResult([&] {
    return database_
        ->sql("SELECT row FROM bag WHERE context = ? AND number_key = ?", context, typedKey(number))
        .one<store::BagRow>();
  });
}

Result<store::ContextRow> Places::save(const records::ContextRecord& c,
                                       const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string number = neededCode(c.number, kContextNumber), key = store::uniqueKey(number);
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
    refuseDouble(database_->sql("SELECT row FROM context WHERE site = ? AND ifnull(trench, 0) "
                                "= ifnull(?, 0) AND number_key = ?",
                                c.site, c.trench, key),
                 c.row.value, message("The context %1 already exists in this place.", number));
    const store::ContextRow row{Saving(catalogue_, provenance, "context", c.row.value, c.id)
                                    .done("site trench number number_key kind excavated_on period "
                                          "date_edtf closed note extra",
                                          number,
                                          {{"site", rowText(c.site.value)},
                                           {"trench", rowText(c.trench.value)},
                                           {"number", number},
                                           {"kind", c.kind},
                                           {"excavated_on", day},
                                           {"period", c.period},
                                           {"date_edtf", edtf},
                                           {"closed", c.closed ? (*c.closed ? "1" : "0") : ""},
                                           {"note", c.note},
                                           {"extra", c.extra_json}},
                                          c.site, c.trench, number, key, c.kind, day, c.period,
                                          edtf, c.closed, c.note, c.extra_json)};
    if (c.row) searchAnew(*database_, "row", row.value);
    return row;
  });
}

Result<std::vector<records::BagRecord>> Places::bags() const {
  return bags(store::ContextRow{});
}

Result<std::vector<records::BagRecord>> Places::bags(store::ContextRow context) const {
  return database_->asResult([&] {
    std::vector<records::BagRecord> all;
    store::Statement rows = database_->sql(
        "SELECT row, context, id, number, collected_on, storage, count_written, weight_g, (SELECT "
        "count(*) FROM sherd WHERE sherd.bag = bag.row AND sherd.state <> 'void'), ifnull((SELECT "
        "initials FROM person WHERE person.row = bag.created_by), '') FROM bag WHERE ?1 IS NULL OR "
        "context = ?1 ORDER BY context, number_key",
        context);
    for (records::BagRecord b;
         rows.read(b.row, b.context, b.id, b.number, b.collected_on, b.storage, b.count_written,
                   b.weight_g, b.sherds, b.entered_by);)
      all.push_back(b);
    return all;
  });
}

Result<store::BagRow> Places::save(const records::BagRecord& b,
                                   const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string number = neededCode(b.number, kBagNumber), key = store::uniqueKey(number);
    if (!b.context) store::refuse(message("A bag needs a context."), number);
    const std::string day = checked(store::checkedDay(b.collected_on), "collected_on");
    if (b.weight_g && !(*b.weight_g > 0))
      store::refuse(message("The weight of a bag must be greater than 0 g."), number);
    if (b.count_written && *b.count_written < 0)
      store::refuse(message("A count cannot be less than 0."), number);
    refuseDouble(
        database_->sql("SELECT row FROM bag WHERE context = ? AND number_key = ?", b.context, key),
        b.row.value, message("The bag %1 already exists in this context.", number));
    return store::BagRow{
        Saving(catalogue_, provenance, "bag", b.row.value, b.id)
            .done("context number number_key collected_on storage count_written weight_g", number,
                  {{"context", rowText(b.context.value)},
                   {"number", number},
                   {"collected_on", day},
                   {"storage", b.storage},
                   {"count_written", optionalText(b.count_written)},
                   {"weight_g", optionalText(b.weight_g)}},
                  b.context, number, key, day, b.storage, b.count_written, b.weight_g)};
  });
}

}  // namespace ostraka::catalogue
