#include "catalogue/renamed_places.h"

#include <algorithm>
#include <optional>

#include "base/message.h"
#include "catalogue/label_codes.h"
#include "catalogue/places.h"
#include "catalogue/search.h"
#include "catalogue/settings.h"
#include "catalogue/stamped_rows.h"
#include "catalogue/typed_place.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

using store::valueOrThrow;

// How a kind of place is stored.
struct Stored {
  std::string table, called;              ///< the column of its name
  std::string beside;                     ///< two of one name are one where these are the same, too
  std::vector<std::string> descriptions;  ///< columns
};

const Stored& storedAs(PlaceKind kind) {
  static const Stored kAll[] = {
      {"trench", "code", "site", {"name"}},
      {"context",
       "number",
       "site, ifnull(trench, 0)",
       {"kind", "excavated_on", "period", "date_edtf", "closed", "note", "extra"}},
      {"bag", "number", "context", {"collected_on", "storage", "count_written", "weight_g"}}};
  return kAll[static_cast<std::size_t>(kind)];
}

// Of the bags, contexts and sherds in a place.
std::string contextsIn(PlaceKind kind) {
  return kind == PlaceKind::Trench
             ? "SELECT row FROM context WHERE one_with IS NULL AND trench = ?1"
             : "SELECT ?1";
}
std::string bagsIn(PlaceKind kind) {
  return kind == PlaceKind::Bag ? "SELECT ?1"
                                : "SELECT row FROM bag WHERE one_with IS NULL AND context IN (" +
                                      contextsIn(kind) + ")";
}

void refuseGone(PlaceKind kind) {
  if (kind == PlaceKind::Trench)
    store::refuse(message("This trench is no longer in the catalogue."));
  if (kind == PlaceKind::Bag) store::refuse(message("This bag is no longer in the catalogue."));
  store::refuse(message("This context is no longer in the catalogue."));
}

std::string calledNow(store::Database& database, PlaceId place) {
  const Stored& as = storedAs(place.kind);
  store::Statement row = database.sql(
      "SELECT " + as.called + " FROM " + as.table + " WHERE one_with IS NULL AND row = ?",
      place.row);
  std::string name;
  if (!row.read(name)) refuseGone(place.kind);
  return name;
}

// Another place beside this one that has the name; 0: none.
std::int64_t besideWithName(store::Database& database, PlaceId place, const std::string& key) {
  const Stored& as = storedAs(place.kind);
  return database
      .sql("SELECT row FROM " + as.table + " WHERE one_with IS NULL AND row <> ?1 AND " +
               as.called + "_key = ?2 AND (" + as.beside + ") = (SELECT " + as.beside + " FROM " +
               as.table + " WHERE row = ?1)",
           place.row, key)
      .one<std::int64_t>();
}

// Its record with another name, checked and saved.
void saveName(const Catalogue& catalogue, PlaceId place, const std::string& name,
              const records::Provenance& provenance) {
  Places places(catalogue);
  const auto change = [&](auto all, auto member) {
    const auto found =
        std::ranges::find_if(all, [&](const auto& one) { return one.row.value == place.row; });
    if (found == all.end()) return refuseGone(place.kind);
    (*found).*member = name;
    valueOrThrow(places.save(*found, provenance));
  };
  switch (place.kind) {
    case PlaceKind::Trench:
      return change(valueOrThrow(places.trenches()), &records::TrenchRecord::code);
    case PlaceKind::Context:
      return change(valueOrThrow(places.contexts()), &records::ContextRecord::number);
    case PlaceKind::Bag:
      return change(valueOrThrow(places.bags()), &records::BagRecord::number);
  }
}

class Joining {
 public:
  explicit Joining(const Catalogue& catalogue)
      : catalogue_(catalogue), database_(catalogue.database()) {}

  /// What lies in `from`; places of one name in both become one in their turn.
  void bring(PlaceKind kind, std::int64_t from, std::int64_t into) {
    joined_.push_back({kind, from, into, {}, {}, {}});
    const std::size_t own = joined_.size() - 1;  // others come behind it
    if (kind == PlaceKind::Trench) {
      within(own, PlaceKind::Context, "trench");
      move(own, "trench", "parent");
    } else if (kind == PlaceKind::Context) {
      within(own, PlaceKind::Bag, "context");
      move(own, "sherd", "context");
    } else {
      move(own, "sherd", "bag");
      ofBatches(own);
    }
  }
  /// The whole pairs, those within them behind them.
  std::vector<JoinedPlace>& joined() { return joined_; }

 private:
  void within(std::size_t own, PlaceKind kind, const char* column) {
    const Stored& as = storedAs(kind);
    const std::int64_t from = joined_[own].from, into = joined_[own].into;
    const std::string live =
        "SELECT row FROM " + as.table + " WHERE one_with IS NULL AND " + column;
    for (const std::int64_t row :
         database_.sql(live + " = ? ORDER BY row", from).all<std::int64_t>()) {
      const auto same = database_
                            .sql(live + " = ?1 AND " + as.called + "_key = (SELECT " + as.called +
                                     "_key FROM " + as.table + " WHERE row = ?2)",
                                 into, row)
                            .one<std::int64_t>();
      if (same == 0) {
        set(own, {as.table.c_str(), column, row, from, into});
        continue;
      }
      database_.run("UPDATE " + as.table + " SET one_with = ? WHERE row = ?", same, row);
      bring(kind, row, same);
    }
  }
  void move(std::size_t own, const char* table, const char* column) {
    const std::int64_t from = joined_[own].from, into = joined_[own].into;
    for (const std::int64_t row :
         database_.sql(std::string("SELECT row FROM ") + table + " WHERE " + column + " = ?", from)
             .all<std::int64_t>())
      // A trench that lay in the other one lies where that did.
      set(own,
          {table, column, row, from,
           std::string_view(table) == "trench" && row == into
               ? database_.sql("SELECT nullif(parent, ?) FROM trench WHERE row = ?", into, from)
                     .one<std::int64_t>()
               : into});
  }
  void set(std::size_t own, const Moved& moved) {
    write(database_, moved, moved.after);
    joined_[own].moved.push_back(moved);
  }
  void ofBatches(std::size_t own) {
    const std::int64_t from = joined_[own].from, into = joined_[own].into;
    store::Statement twice = database_.sql(
        "SELECT batch, position FROM batch_bag WHERE bag = ?1 AND batch IN (SELECT batch FROM "
        "batch_bag WHERE bag = ?2)",
        from, into);
    for (std::pair<std::int64_t, std::int64_t> one; twice.read(one.first, one.second);)
      joined_[own].of_batches.push_back(one);
    for (const auto& [batch, position] : joined_[own].of_batches)
      database_.run("DELETE FROM batch_bag WHERE batch = ? AND position = ?", batch, position);
    for (const std::int64_t batch :
         database_.sql("SELECT batch FROM batch_bag WHERE bag = ?", from).all<std::int64_t>())
      set(own, {"batch_bag", "bag", batch, from, into});
  }

 public:
  // Of a batch's bags, the one that is there now.
  static void write(store::Database& database, const Moved& moved, std::int64_t value) {
    if (std::string_view(moved.table) == "batch_bag")
      database.run("UPDATE batch_bag SET bag = ?1 WHERE batch = ?2 AND bag = ?3", value, moved.row,
                   value == moved.after ? moved.before : moved.after);
    else
      database.run(std::string("UPDATE ") + moved.table + " SET " + moved.column +
                       " = nullif(?, 0) WHERE row = ?",
                   value, moved.row);
  }
  static bool holds(store::Database& database, const Moved& moved) {
    if (std::string_view(moved.table) == "batch_bag")
      return database
          .sql("SELECT 1 FROM batch_bag WHERE batch = ? AND bag = ?", moved.row, moved.after)
          .next();
    return database
        .sql(std::string("SELECT 1 FROM ") + moved.table + " WHERE row = ? AND ifnull(" +
                 moved.column + ", 0) = ?",
             moved.row, moved.after)
        .next();
  }

 private:
  const Catalogue& catalogue_;
  store::Database& database_;
  std::vector<JoinedPlace> joined_;
};

// What the place says that the other one does not.
std::map<std::string, std::string> onlySaidOf(store::Database& database, const JoinedPlace& pair) {
  const Stored& as = storedAs(pair.kind);
  std::map<std::string, std::string> said;
  for (const std::string& column : as.descriptions) {
    const auto valueOf = [&](std::int64_t row) {
      store::Statement one =
          database.sql("SELECT " + column + " FROM " + as.table + " WHERE row = ?", row);
      std::string text;
      if (one.next()) one.readText(text);
      return text == "{}" ? std::string() : text;
    };
    if (valueOf(pair.into).empty())
      if (std::string text = valueOf(pair.from); !text.empty()) said[column] = std::move(text);
  }
  return said;
}

// NULL where nothing is said: some of these columns are numbers.
ColumnValue columnValue(const Stored& as, const std::string& column, const std::string& text) {
  const bool number = as.table == "bag" ? column.ends_with("_written") || column.ends_with("_g")
                                        : column == "closed";
  if (text.empty() && column == "extra") return "{}";
  return number && text.empty() ? ColumnValue(std::optional<double>()) : ColumnValue(text);
}

// After one pair, or back before it.
void tell(const Catalogue& catalogue, const JoinedPlace& pair, bool joined,
          const records::Provenance& provenance) {
  const Stored& as = storedAs(pair.kind);
  const std::int64_t one_with = joined ? pair.into : 0;
  const std::vector<Column> follows = {
      {"one_with", one_with > 0 ? ColumnValue(one_with) : ColumnValue(std::optional<double>())}};
  rememberDifferences(catalogue, provenance, as.table.c_str(), pair.from, follows);
  changeRow(catalogue, provenance, as.table.c_str(), pair.from, follows);
  std::vector<Column> said;
  for (const auto& [column, text] : pair.described)
    said.push_back({column.c_str(), columnValue(as, column, joined ? text : std::string())});
  if (said.empty()) return;
  rememberDifferences(catalogue, provenance, as.table.c_str(), pair.into, said);
  changeRow(catalogue, provenance, as.table.c_str(), pair.into, said);
}

void findSherdsAnew(store::Database& database, PlaceKind kind, std::int64_t row) {
  if (kind != PlaceKind::Bag)
    searchAnewIn(database, kind == PlaceKind::Trench ? "trench" : "row", row);
}

// What is typed in the capture, as the place that it means is called afterwards.
class CapturePlace {
 public:
  explicit CapturePlace(const Catalogue& catalogue) : catalogue_(catalogue) {
    text_ = valueOrThrow(Settings(catalogue).value(kCapturePlace));
    const auto typed = typedPlace(catalogue, text_, Named::Bag);
    if (!typed || !*typed) return;
    Places places(catalogue);
    context_ =
        valueOrThrow(places.contextByPlace((*typed)->site, (*typed)->trench, (*typed)->context));
    bag_ = valueOrThrow(places.bagByNumber(context_, (*typed)->bag));
    new_bag_ = (*typed)->bag;
  }
  void follow() {
    if (!context_) return;
    const store::ContextRow now{placeNow(catalogue_, {PlaceKind::Context, context_.value})};
    const auto context = valueOrThrow(Places(catalogue_).context(now));
    std::string bag = new_bag_;
    if (bag_)
      if (const auto place = valueOrThrow(placeOf(catalogue_, bag_))) bag = place->bag;
    std::string text = context.site_code;
    for (const std::string* part :
         {&context.trench_code, &context.number, static_cast<const std::string*>(&bag)})
      if (!part->empty()) text += " " + *part;
    const auto means = typedPlace(catalogue_, text_, Named::Bag);
    const bool same = means && *means && (*means)->site == context.site_code &&
                      (*means)->trench == context.trench_code &&
                      (*means)->context == context.number && (*means)->bag == bag;
    if (!same) valueOrThrow(Settings(catalogue_).setValue(kCapturePlace, text));
  }

 private:
  const Catalogue& catalogue_;
  std::string text_, new_bag_;
  store::ContextRow context_;
  store::BagRow bag_;
};

}  // namespace

const char* nameOf(PlaceKind kind) {
  return storedAs(kind).table.c_str();
}

Result<Renaming> renamingOf(const Catalogue& catalogue, PlaceId place, const std::string& name) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    Renaming would;
    would.before = calledNow(database, place);
    would.after = valueOrThrow(store::checkedText(name));
    if (would.after.empty())
      store::refuse(message("The name of a place must not be empty; nothing was renamed."));
    would.into = besideWithName(database, place, store::codeKey(would.after));
    const auto count = [&](const std::string& of) {
      return database.sql("SELECT count(*) FROM (" + of + ")", place.row).one<int>();
    };
    if (place.kind == PlaceKind::Trench) would.contexts = count(contextsIn(place.kind));
    if (place.kind != PlaceKind::Bag) would.bags = count(bagsIn(place.kind));
    would.batches =
        count("SELECT DISTINCT batch FROM batch_bag WHERE bag IN (" + bagsIn(place.kind) + ")");
    const std::string sherds =
        place.kind == PlaceKind::Bag
            ? "SELECT * FROM sherd WHERE bag = ?1"
            : "SELECT * FROM sherd WHERE context IN (" + contextsIn(place.kind) + ")";
    would.sherds = count(sherds + " AND state <> 'void'");
    would.numbered = count(sherds + " AND state = 'numbered'");
    return would;
  });
}

Result<Renamed> rename(const Catalogue& catalogue, PlaceId place, const std::string& name,
                       IfNameIsTaken if_taken, const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    const Renaming would = valueOrThrow(renamingOf(catalogue, place, name));
    CapturePlace typed(catalogue);
    Renamed renamed{place, would.before, would.after, {}};
    if (would.into == 0 || if_taken == IfNameIsTaken::Refuse) {
      saveName(catalogue, place, would.after, provenance);
    } else {
      Joining joining(catalogue);
      joining.bring(place.kind, place.row, would.into);
      for (JoinedPlace& pair : joining.joined()) {
        pair.described = onlySaidOf(database, pair);
        // Told by what it was before.
        database.run(
            std::string("UPDATE ") + nameOf(pair.kind) + " SET one_with = NULL WHERE row = ?",
            pair.from);
      }
      for (auto pair = joining.joined().begin(); pair != joining.joined().end(); ++pair)
        tell(catalogue, *pair, true, provenance);
      renamed.joined = std::move(joining.joined());
      findSherdsAnew(database, place.kind, would.into);
    }
    typed.follow();
    return renamed;
  });
}

Result<void> renameBack(const Catalogue& catalogue, const Renamed& renamed,
                        const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    const Stored& as = storedAs(renamed.place.kind);
    const auto refuseChanged = [&] {
      throw store::Refused(Error::changedMeanwhile(as.called, renamed.after));
    };
    CapturePlace typed(catalogue);
    if (renamed.joined.empty()) {
      if (calledNow(database, renamed.place) != renamed.after) refuseChanged();
      saveName(catalogue, renamed.place, renamed.before, provenance);
      return typed.follow();
    }
    for (auto pair = renamed.joined.rbegin(); pair != renamed.joined.rend(); ++pair) {
      const Stored& own = storedAs(pair->kind);
      if (!database
               .sql("SELECT 1 FROM " + own.table + " WHERE row = ? AND one_with = ?", pair->from,
                    pair->into)
               .next())
        refuseChanged();
      if (pair->from == renamed.place.row && pair->kind == renamed.place.kind &&
          besideWithName(database, renamed.place, store::codeKey(renamed.before)) != 0)
        store::refuse(
            message("Another place has the name %1 by now; nothing was undone.", renamed.before));
      for (const Moved& moved : pair->moved) {
        if (!Joining::holds(database, moved)) refuseChanged();
        Joining::write(database, moved, moved.before);
      }
      for (const auto& [batch, position] : pair->of_batches)
        database.run("INSERT INTO batch_bag VALUES (?, ?, ?)", batch, position, pair->from);
      JoinedPlace parted = *pair;
      std::erase_if(parted.described, [&](const auto& said) {
        store::Statement one = database.sql(
            "SELECT " + said.first + " FROM " + own.table + " WHERE row = ?", pair->into);
        std::string now;
        if (one.next()) one.readText(now);
        return now != said.second;
      });
      tell(catalogue, parted, false, provenance);
    }
    // A sherd that was put into another bag meanwhile.
    if (database
            .sql("SELECT 1 FROM sherd JOIN bag ON bag.row = sherd.bag WHERE bag.context IS NOT "
                 "sherd.context")
            .next())
      refuseChanged();
    for (const JoinedPlace& pair : renamed.joined) {
      findSherdsAnew(database, pair.kind, pair.from);
      findSherdsAnew(database, pair.kind, pair.into);
    }
    typed.follow();
  });
}

std::vector<JoinedPlace> bringTogether(const Catalogue& catalogue, PlaceKind kind,
                                       std::int64_t from, std::int64_t into) {
  Joining joining(catalogue);
  joining.bring(kind, from, into);
  for (const JoinedPlace& pair : joining.joined())
    if (!pair.moved.empty()) findSherdsAnew(catalogue.database(), pair.kind, pair.into);
  return std::move(joining.joined());
}

std::int64_t placeNow(const Catalogue& catalogue, PlaceId place) {
  const std::string table = nameOf(place.kind);
  return catalogue.database()
      .sql("WITH RECURSIVE now(row, one_with) AS (SELECT row, one_with FROM " + table +
               " WHERE row = ? UNION SELECT t.row, t.one_with FROM now JOIN " + table +
               " t ON t.row = now.one_with) SELECT row FROM now WHERE one_with IS NULL",
           place.row)
      .one<std::int64_t>();
}

Result<std::vector<std::pair<std::string, std::int64_t>>> joinedPlaces(const Catalogue& catalogue) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    using Place = std::pair<std::string, std::int64_t>;
    std::vector<Place> all;
    for (const PlaceKind kind : {PlaceKind::Trench, PlaceKind::Context, PlaceKind::Bag})
      for (const auto& [id, row] : database
                                       .sql(std::string("SELECT id, row FROM ") + nameOf(kind) +
                                            " WHERE one_with IS NOT NULL")
                                       .all<Place>(&Place::first, &Place::second))
        all.emplace_back(id, placeNow(catalogue, {kind, row}));
    return all;
  });
}

std::vector<std::string> namesOf(const Catalogue& catalogue, PlaceId place) {
  if (place.row == 0) return {};
  const Stored& as = storedAs(place.kind);
  store::Statement rows = catalogue.database().sql(
      "WITH RECURSIVE one(row, depth) AS (SELECT ?1, 0 UNION ALL SELECT t.row, depth + 1 FROM one "
      "JOIN " +
          as.table + " t ON t.one_with = one.row) SELECT name FROM (SELECT " + as.called +
          " AS name, depth, 0 AS number FROM one JOIN " + as.table +
          " t ON t.row = one.row UNION ALL SELECT old, depth, h.number FROM one JOIN history h ON "
          "h.table_name = ?2 AND h.row = one.row AND h.field = ?3) WHERE name <> '' ORDER BY "
          "depth, number",
      place.row, as.table, as.called);
  std::vector<std::string> names;
  for (std::string name; rows.read(name);)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace ostraka::catalogue
