// Sherds, and the places that they point at, whose rows are lost: made anew under their own row
// numbers. Nothing deletes them, so what the history or another row speaks of was there.

#include <algorithm>
#include <optional>
#include <sstream>

#include "base/uuid.h"
#include "sherds/sherd_columns.h"
#include "store/database.h"
#include "store/names.h"
#include "upkeep/row_repair.h"

namespace ostraka::upkeep {
namespace {

class MakingAnew {
 public:
  MakingAnew(store::Database& fresh, RepairReport& report) : fresh_(fresh), report_(report) {}

  void run() {
    sherds();
    sites();
    trenches();
    contexts();
    bags();
  }

 private:
  struct Stamp {
    std::int64_t at = 0;
    store::PersonRow by;
  };
  struct Place {
    std::string context;
    std::int64_t site = 0;
    std::optional<std::int64_t> trench;
  };

  // pointing: SELECTs of the rows that others point at, each behind a UNION.
  std::vector<std::int64_t> missing(const std::string& table, const std::string& pointing) {
    return fresh_
        .sql("SELECT row FROM history WHERE table_name = ? AND row > 0 " + pointing +
                 " EXCEPT SELECT row FROM " + table + " ORDER BY 1",
             table)
        .all<std::int64_t>();
  }

  // The last value of a field; of an empty one what the row was called when it was new.
  std::string told(const std::string& table, std::int64_t row, const std::string& field) {
    return fresh_
        .sql(
            "SELECT new FROM history WHERE table_name = ? AND row = ? AND field = ? ORDER BY "
            "number DESC LIMIT 1",
            table, row, field)
        .one<std::string>();
  }

  Stamp stampOf(const std::string& table, std::int64_t row) {
    Stamp stamp;
    fresh_
        .sql(
            "SELECT at, person FROM history WHERE table_name = ? AND row = ? ORDER BY number "
            "LIMIT 1",
            table, row)
        .read(stamp.at, stamp.by);
    return stamp;
  }

  void madeAnew(const std::string& table, std::int64_t row) {
    const auto known = std::ranges::find_if(report_.rows, [&](const RepairedRow& one) {
      return one.table == table && one.row == row && one.field.empty();
    });
    if (known != report_.rows.end())
      known->from = RepairedRow::From::History;
    else
      report_.rows.push_back({table, row, {}, {}, RepairedRow::From::History});
  }

  // Those of the fields that the history does not tell, either.
  void notTold(const std::string& table, std::int64_t row, const std::string& fields) {
    std::string left;
    std::istringstream names(fields);
    for (std::string name; std::getline(names >> std::ws, name, ',');)
      if (told(table, row, name).empty()) left += (left.empty() ? "" : ", ") + name;
    if (!left.empty()) report_.rows.push_back({table, row, {}, left, RepairedRow::From::Nowhere});
  }

  // Its uuid is what the history says first of a new sherd.
  void sherds() {
    for (const std::int64_t row : missing("sherd", "")) {
      const std::string id = told("sherd", row, "");
      const Stamp made = stampOf("sherd", row);
      if (!isUuid(id)) continue;
      fresh_.run(
          "INSERT OR IGNORE INTO sherd (row, id, created_at, created_by, updated_at, updated_by, "
          "number_sort) VALUES (?, ?, ?, ?, ?, ?, ?)",
          row, id, made.at, made.by, made.at, made.by, sherds::kBehindAllNumbers);
      if (fresh_.changes() > 0) madeAnew("sherd", row);
    }
  }

  // False where this place has another of this name. more: further columns, each behind a comma.
  template <class... Values>
  bool add(const std::string& table, std::int64_t row, const std::string& called,
           const std::string& name, const std::string& more, const Values&... values) {
    const Stamp made = stampOf(table, row);
    std::string marks;
    for (std::size_t i = 0; i < sizeof...(values); ++i) marks += ", ?";
    fresh_.run("INSERT OR IGNORE INTO " + table + " (" + called + ", " + called +
                   "_key, row, id, " + "created_at, created_by, updated_at, updated_by" + more +
                   ") VALUES (?, ?, ?, ?, ?, ?, ?, ?" + marks + ")",
               name, store::codeKey(name), row, newId(made.at), made.at, made.by, made.at, made.by,
               values...);
    if (fresh_.changes() == 0) return false;
    madeAnew(table, row);
    return true;
  }

  static std::string lost(std::int64_t row) { return "lost " + std::to_string(row); }
  // As it was called last; a made-up name where nothing tells it.
  std::string nameOf(const std::string& table, std::int64_t row, const std::string& called) {
    for (const std::string& field : {called, std::string()})
      if (std::string name = told(table, row, field); !name.empty()) return name;
    return lost(row);
  }

  void sites() {
    for (const std::int64_t row :
         missing("site", "UNION SELECT site FROM context UNION SELECT site FROM trench")) {
      for (const std::string& name : {nameOf("site", row, "code"), lost(row)})
        if (add("site", row, "code", name, ", name", "")) break;
      notTold("site", row, "name, latitude_deg, longitude_deg, gazetteer");
    }
  }

  // By its code, or by one that it had before.
  std::int64_t siteCalled(const std::string& code) {
    const auto now = fresh_.sql("SELECT row FROM site WHERE code_key = ?", store::codeKey(code))
                         .one<std::int64_t>();
    return now ? now
               : fresh_
                     .sql(
                         "SELECT site.row FROM history h JOIN site ON site.row = h.row WHERE "
                         "h.table_name = 'site' AND field IN ('', 'code') AND new = ?",
                         code)
                     .one<std::int64_t>();
  }
  std::int64_t siteOfSherd(std::int64_t sherd) {
    const std::string code = told("sherd", sherd, "site");
    return code.empty() ? 0 : siteCalled(code);
  }

  // Where nothing tells it: the only one that there is, or one that is called lost.
  std::int64_t anySite() {
    std::int64_t count = 0, row = 0;
    fresh_.sql("SELECT count(*), max(row) FROM site").read(count, row);
    if (count == 1) return row;
    if (const std::int64_t known = siteCalled("lost")) return known;
    add("site", row + 1, "code", "lost", ", name", "");
    return row + 1;
  }

  void trenches() {
    for (const std::int64_t row :
         missing("trench",
                 "UNION SELECT trench FROM context WHERE trench > 0 UNION SELECT parent FROM "
                 "trench WHERE parent > 0")) {
      const std::string code = nameOf("trench", row, "code");
      auto site = fresh_
                      .sql(
                          "SELECT site FROM context WHERE trench = ?1 UNION ALL SELECT site FROM "
                          "trench WHERE parent = ?1",
                          row)
                      .one<std::int64_t>();
      for (const std::int64_t sherd : sherdsTold("trench", code))
        if (site == 0) site = siteOfSherd(sherd);
      if (site == 0) site = anySite();
      for (const std::string& name : {code, lost(row)})
        if (add("trench", row, "code", name, ", site, name", site, "")) break;
      notTold("trench", row, "name, parent");
    }
  }

  std::vector<std::int64_t> sherdsTold(const std::string& field, const std::string& value) {
    return fresh_
        .sql(
            "SELECT DISTINCT row FROM history WHERE table_name = 'sherd' AND field = ? AND new = "
            "? ORDER BY row",
            field, value)
        .all<std::int64_t>();
  }

  // As the sherd's own history says it; none where it was entered with its place, which nobody
  // changed since.
  std::optional<Place> placeOfSherd(std::int64_t sherd) {
    Place place{told("sherd", sherd, "context"), siteOfSherd(sherd), {}};
    if (place.context.empty() || place.site == 0) return std::nullopt;
    const std::string code = told("sherd", sherd, "trench");
    if (code.empty()) return place;
    place.trench = fresh_
                       .sql("SELECT row FROM trench WHERE site = ? AND code_key = ?", place.site,
                            store::codeKey(code))
                       .one<std::int64_t>();
    return *place.trench > 0 ? std::optional(place) : std::nullopt;
  }

  bool isCalled(std::int64_t context, const std::string& number) {
    store::Statement names = fresh_.sql(
        "SELECT max(new = ?), count(*) FROM history WHERE table_name = 'context' AND row = ? AND "
        "field IN ('', 'number')",
        number, context);
    std::int64_t so = 0, known = 0;
    names.read(so, known);
    return so > 0 || known == 0;
  }

  // Those that are in it, else those without a row of their own that say so.
  bool addWhereItsSherdsAre(std::int64_t row) {
    const std::string number = nameOf("context", row, "number");
    std::vector<std::int64_t> in_it =
        fresh_.sql("SELECT row FROM sherd WHERE context = ?", row).all<std::int64_t>();
    if (in_it.empty()) in_it = sherdsTold("context", number);
    for (const std::int64_t sherd : in_it) {
      const std::optional<Place> place = placeOfSherd(sherd);
      if (!place || !isCalled(row, place->context)) continue;
      const std::string name = number == lost(row) ? place->context : number;
      if (add("context", row, "number", name, ", site, trench", place->site, place->trench))
        return true;
    }
    return false;
  }

  void contexts() {
    for (const std::int64_t row :
         missing("context",
                 "UNION SELECT context FROM sherd WHERE context > 0 UNION SELECT context FROM "
                 "bag")) {
      std::string fields = "kind, excavated_on, period, date_edtf, note";
      if (!addWhereItsSherdsAre(row)) {
        const std::int64_t site = anySite();
        for (const std::string& name : {nameOf("context", row, "number"), lost(row)})
          if (add("context", row, "number", name, ", site", site)) break;
        fields = "site, trench, " + fields;
      }
      notTold("context", row, fields);
    }
  }

  void bags() {
    for (const std::int64_t row :
         missing("bag",
                 "UNION SELECT bag FROM sherd WHERE bag > 0 UNION SELECT bag FROM "
                 "batch_bag")) {
      const auto context =
          fresh_.sql("SELECT context FROM sherd WHERE bag = ? AND context > 0", row)
              .one<std::int64_t>();
      if (context == 0) continue;
      for (const std::string& name : {nameOf("bag", row, "number"), lost(row)})
        if (add("bag", row, "number", name, ", context", context)) break;
      notTold("bag", row, "collected_on, count_written, weight_g, storage");
    }
  }

  store::Database& fresh_;
  RepairReport& report_;
};

}  // namespace

void makeLostRowsAnew(store::Database& fresh, RepairReport& report) {
  MakingAnew(fresh, report).run();
}

}  // namespace ostraka::upkeep
