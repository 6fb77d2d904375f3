#include "sherds/sherds.h"

#include <nlohmann/json.hpp>
#include <unordered_map>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/file_places.h"
#include "catalogue/history.h"
#include "catalogue/search.h"
#include "catalogue/stamped_rows.h"
#include "records/words.h"
#include "sherds/filter.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherd_fields.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::sherds {
namespace {

constexpr const char* kKinds[] = {"length",        "width",   "thickness_min", "thickness_mean",
                                  "thickness_max", "area",    "volume",        "filled_pct",
                                  "rim_diameter",  "rim_pct", "weight"};

constexpr const char* kSherds =
    "SELECT s.row, s.id, s.number, s.state, s.void_reason, s.context, s.bag, s.batch, s.front, "
    "s.back, s.part, s.decoration, s.condition, s.ware, s.fabric, s.inclusions, s.manufacture, "
    "s.firing, s.surface_out, s.surface_in, s.munsell_out, s.munsell_in, s.munsell_core, s.period, "
    "s.date_edtf, s.vessel, s.note, s.extra, s.revision, site.code, "
    "trench.code, context.number, bag.number, batch.number, ifnull(batch.scale_doubts, '') <> '', "
    "s.preview_path, s.model_path, ifnull(max(front.position, 0), 0), "
    "m.length, m.width, m.thickness_min, m.thickness_mean, m.thickness_max, m.area, m.volume, "
    "m.filled_pct, m.rim_diameter, m.rim_pct, m.weight "
    "FROM sherd s JOIN sherd_measure m ON m.sherd = s.row "
    "LEFT JOIN context ON context.row = s.context LEFT JOIN site ON site.row = context.site "
    "LEFT JOIN trench ON trench.row = context.trench LEFT JOIN bag ON bag.row = s.bag "
    "LEFT JOIN batch ON batch.row = s.batch LEFT JOIN scan front ON front.row = s.front "
    "WHERE s.row IN (SELECT value FROM json_each(?))";

records::SherdRecord readSherd(store::Statement& row) {
  records::SherdRecord s;
  std::string part, decoration, condition;
  row >> s.row >> s.id >> s.number >> s.state >> s.void_reason >> s.context >> s.bag >> s.batch >>
      s.front >> s.back >> part >> decoration >> condition >> s.ware >> s.fabric >> s.inclusions >>
      s.manufacture >> s.firing >> s.surface_out >> s.surface_in >> s.munsell_out >> s.munsell_in >>
      s.munsell_core >> s.period >> s.date_edtf >> s.vessel >> s.note >> s.extra_json >>
      s.revision >> s.site >> s.trench >> s.context_number >> s.bag_number >> s.batch_number >>
      s.scale_doubtful >> s.preview_path >> s.model_path >> s.piece;
  s.part = store::termsFromJson(part);
  s.decoration = store::termsFromJson(decoration);
  s.condition = store::termsFromJson(condition);
  for (const char* kind : kKinds) {
    std::optional<double> value;
    row >> value;
    if (value) s.measures[kind] = *value;
  }
  return s;
}

// Shares of the surface stay true whatever the scale is.
void readDoubts(store::Database& database, const std::string& wanted,
                std::unordered_map<std::int64_t, records::SherdRecord>& sherds) {
  store::Statement rows = database.sql(
      "SELECT m.sherd, m.kind FROM measurement m JOIN sherd s ON s.row = m.sherd JOIN batch b ON "
      "b.row = s.batch WHERE m.current = 1 AND m.method = 'program' AND m.unit <> 'pct' AND "
      "b.scale_doubts <> '' AND m.sherd IN (SELECT value FROM json_each(?))",
      wanted);
  std::int64_t row = 0;
  std::string kind;
  while (rows.read(row, kind)) sherds[row].doubtful.insert(kind);
}

// What the program computed last stays beside what a person measured.
void readReplaced(store::Database& database, const std::string& wanted,
                  std::unordered_map<std::int64_t, records::SherdRecord>& sherds) {
  store::Statement rows = database.sql(
      "SELECT m.sherd, m.kind, p.value FROM measurement m JOIN measurement p ON p.row = (SELECT "
      "max(row) FROM measurement c WHERE c.sherd = m.sherd AND c.kind = m.kind AND c.person IS "
      "NULL AND c.method = 'program') WHERE m.current = 1 AND NOT (m.person IS NULL AND m.method = "
      "'program') AND m.value <> p.value AND m.sherd IN (SELECT value FROM json_each(?))",
      wanted);
  std::int64_t row = 0;
  std::string kind;
  double value = 0;
  while (rows.read(row, kind, value)) sherds[row].replaced[kind] = value;
}

}  // namespace

std::string rowsJson(std::span<const store::SherdRow> rows) {
  std::string text = "[";
  for (const store::SherdRow& row : rows) {
    if (text.size() > 1) text += ',';
    text += std::to_string(row.value);
  }
  return text + "]";
}

Result<std::vector<records::SherdRecord>> Sherds::of(std::span<const store::SherdRow> rows) const {
  return database_->asResult([&] {
    std::unordered_map<std::int64_t, records::SherdRecord> found;
    const std::string wanted = rowsJson(rows);
    bool any_doubtful = false;
    {
      store::Statement statement = database_->sql(kSherds, wanted);
      while (statement.next()) {
        records::SherdRecord sherd = readSherd(statement);
        any_doubtful = any_doubtful || sherd.scale_doubtful;
        found.emplace(sherd.row.value, std::move(sherd));
      }
    }
    if (any_doubtful) readDoubts(*database_, wanted, found);
    readReplaced(*database_, wanted, found);
    store::Statement joins = database_->sql(
        "SELECT j.sherd, j.other, o.number, o.id FROM sherd_join j JOIN sherd o ON o.row = j.other "
        "WHERE j.sherd IN (SELECT value FROM json_each(?)) ORDER BY o.number_sort, o.row",
        wanted);
    std::int64_t in = 0;
    store::SherdRow other;
    for (std::string number, id; joins.read(in, other, number, id);) {
      found[in].joins.push_back(other);
      found[in].join_numbers.push_back(number.empty() ? id : number);
    }
    std::vector<records::SherdRecord> page;
    page.reserve(rows.size());
    for (const store::SherdRow& row : rows) {
      const auto sherd = found.find(row.value);
      if (sherd == found.end()) store::refuse(message("A sherd is no longer in the catalogue."));
      page.push_back(sherd->second);
    }
    return page;
  });
}

Result<records::SherdRecord> Sherds::get(store::SherdRow row) const {
  Result<std::vector<records::SherdRecord>> page = of(std::span(&row, 1));
  if (!page) return page.error();
  return std::move(page->front());
}

Result<store::SherdRow> Sherds::byNumber(const std::string& number) const {
  return firstOf<store::SherdRow>(
      "SELECT g.sherd FROM given_number g JOIN sherd s ON s.row = g.sherd AND s.number = g.number "
      "WHERE g.number_key = ?",
      store::uniqueKey(store::trimmed(number)));
}

Result<store::SherdRow> Sherds::byId(const std::string& id) const {
  return firstOf<store::SherdRow>("SELECT row FROM sherd WHERE id = ?",
                                  store::uniqueKey(store::trimmed(id)));
}

Result<std::vector<store::SherdRow>> Sherds::rows(const Filter& filter,
                                                  const records::SherdOrder& order) const {
  return database_->asResult([&] { return matching(*database_, filter, order); });
}

Result<std::vector<store::SherdRow>> Sherds::rows(store::BatchRow batch) const {
  return allOf<store::SherdRow>(
      "SELECT row FROM sherd WHERE batch = ? AND NOT (state = 'void' AND number = '') ORDER BY "
      "number_sort, row",
      batch);
}

Result<std::vector<std::string>> Sherds::customFields() const {
  return allOf<std::string>(
      "SELECT DISTINCT 'extra.' || key FROM sherd, json_each(sherd.extra) WHERE "
      "json_type(sherd.extra) = 'object' AND sherd.extra <> '{}' AND key <> '' ORDER BY 1");
}

Result<store::SherdRow> Sherds::add(const records::SherdRecord& s,
                                    const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string id = s.id.empty() ? newId(now()) : s.id;
    if (!isUuid(id)) store::refuse(message("The uuid of a sherd is not well formed."), id);
    store::Statement same = database_->sql("SELECT 1 FROM sherd WHERE id = ?", id);
    if (same.next()) store::refuse(message("A sherd with this uuid already exists."), id);
    const store::SherdRow row{catalogue::saveRow(catalogue_, provenance, "sherd", 0, id,
                                                 {{"number_sort", kBehindAllNumbers},
                                                  {"context", s.context},
                                                  {"bag", s.bag},
                                                  {"batch", s.batch},
                                                  {"front", s.front},
                                                  {"back", s.back},
                                                  {"extra", s.extra_json}})};
    database_->run("INSERT INTO sherd_measure (sherd) VALUES (?)", row);
    catalogue::remember(catalogue_, provenance, "sherd", row.value, "", "", id);
    std::vector<records::FieldChange> changes;
    for (const SherdColumn& column : sherdColumns()) {
      if (!column.field.editable || column.field.kind == records::FieldKind::Place) continue;
      std::string value = textOf(s, column.field.name);
      if (!value.empty())
        changes.push_back({row, column.field.name, std::move(value), records::Confirmation::Given});
    }
    if (changes.empty())
      catalogue::searchAnew(*database_, row);
    else
      store::valueOrThrow(SherdChanges(catalogue_).apply(changes, provenance));
    return row;
  });
}

Result<void> Sherds::setModel(store::SherdRow sherd, const std::string& model_path,
                              const std::string& preview_path) {
  return database_->inTransaction([&] {
    for (const std::string& path : {model_path, preview_path})
      if (!path.empty()) store::valueOrThrow(catalogue::recordedPath(path));
    database_->run("UPDATE sherd SET model_path = ?, preview_path = ? WHERE row = ?", model_path,
                   preview_path, sherd);
  });
}

Result<void> Sherds::voidSherd(store::SherdRow sherd, const std::string& reason,
                               const records::Provenance& provenance) {
  if (store::trimmed(reason).empty())
    return Error::unusable(message("A void sherd needs a reason; enter it."));
  const records::FieldChange voided{sherd, "void_reason", reason};
  const Result<std::vector<records::FieldChange>> done =
      SherdChanges(catalogue_).apply(std::span(&voided, 1), provenance);
  return done ? Result<void>() : done.error();
}

}  // namespace ostraka::sherds
