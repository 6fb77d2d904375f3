#include "sherds/sherd_fields.h"

#include <nlohmann/json.hpp>

#include "files/json_text.h"
#include "records/sherd.h"
#include "records/words.h"
#include "sherds/sherd_columns.h"
#include "store/values.h"

namespace ostraka::sherds {
namespace {

using S = records::SherdRecord;

SherdColumn text(const char* name, records::FieldKind kind, std::string S::*member, const char* sql,
                 bool editable = true, const char* vocabulary = "") {
  return {{name, kind, vocabulary, editable}, member, nullptr, nullptr, sql};
}

SherdColumn terms(const char* name, std::vector<std::string> S::*member, const char* sql,
                  const char* vocabulary) {
  return {{name, records::FieldKind::Terms, vocabulary, true}, nullptr, member, nullptr, sql};
}

SherdColumn measure(const char* name, const char* kind, const char* sql, bool editable) {
  return {{name, records::FieldKind::Number, "", editable}, nullptr, nullptr, kind, sql};
}

}  // namespace

const std::vector<SherdColumn>& sherdColumns() {
  using K = records::FieldKind;
  static const std::vector<SherdColumn> all = {
      text("number", K::Text, &S::number, "s.number_sort"),
      text("uuid", K::Text, &S::id, "s.id", false),
      {{"state", K::Text, "", false}, nullptr, nullptr, nullptr, "s.state"},
      text("void_reason", K::Text, &S::void_reason, "s.void_reason"),
      text("site", K::Place, &S::site, "site.code_key"),
      text("trench", K::Place, &S::trench, "trench.code_key"),
      text("context", K::Place, &S::context_number, "context.number_key"),
      text("bag", K::Place, &S::bag_number, "bag.number_key"),
      terms("part", &S::part, "s.part", "part"),
      text("ware", K::Text, &S::ware, "s.ware"),
      text("fabric", K::Text, &S::fabric, "s.fabric"),
      text("inclusions", K::Text, &S::inclusions, "s.inclusions"),
      text("manufacture", K::Term, &S::manufacture, "s.manufacture", true, "manufacture"),
      text("firing", K::Term, &S::firing, "s.firing", true, "firing"),
      text("surface_out", K::Term, &S::surface_out, "s.surface_out", true, "surface"),
      text("surface_in", K::Term, &S::surface_in, "s.surface_in", true, "surface"),
      terms("decoration", &S::decoration, "s.decoration", "decoration"),
      text("munsell_out", K::Munsell, &S::munsell_out, "s.munsell_out"),
      text("munsell_in", K::Munsell, &S::munsell_in, "s.munsell_in"),
      text("munsell_core", K::Munsell, &S::munsell_core, "s.munsell_core"),
      terms("condition", &S::condition, "s.condition", "condition"),
      {{"joins", K::Joins, "", true}, nullptr, nullptr, nullptr, nullptr},
      text("vessel", K::Text, &S::vessel, "s.vessel"),
      text("period", K::Text, &S::period, "s.period"),
      text("date_edtf", K::Edtf, &S::date_edtf, "s.date_edtf"),
      measure("length_mm", "length", "m.length", true),
      measure("width_mm", "width", "m.width", true),
      measure("thickness_min_mm", "thickness_min", "m.thickness_min", true),
      measure("thickness_mean_mm", "thickness_mean", "m.thickness_mean", true),
      measure("thickness_max_mm", "thickness_max", "m.thickness_max", true),
      measure("area_mm2", "area", "m.area", false),
      measure("volume_mm3", "volume", "m.volume", false),
      measure("filled_pct", "filled_pct", "m.filled_pct", false),
      measure("rim_diameter_mm", "rim_diameter", "m.rim_diameter", true),
      measure("rim_pct", "rim_pct", "m.rim_pct", true),
      measure("weight_g", "weight", "m.weight", true),
      text("batch", K::Text, &S::batch_number, "batch.number", false),
      {{"scale", K::Text, "", false}, nullptr, nullptr, nullptr, "batch.scale_doubts"},
      text("note", K::Text, &S::note, "s.note")};
  return all;
}

const SherdColumn* sherdColumn(const std::string& name) {
  for (const SherdColumn& column : sherdColumns())
    if (name == column.field.name || (column.measure && name == column.measure)) return &column;
  static const SherdColumn end = text(kLabelEnd, records::FieldKind::Text, nullptr,
                                      "substr(replace(s.id, '-', ''), -8)", false);
  static const SherdColumn place =
      text(kLabelPlace, records::FieldKind::Text, nullptr,
           "(SELECT batch.number || printf('-%02d', scan.position) FROM scan JOIN batch ON "
           "batch.row = scan.batch WHERE scan.row = s.front)",
           false);
  // Days as the person's clock has them; '' is none.
  static const SherdColumn entered =
      text(kEntered, records::FieldKind::Day, nullptr,
           "date(s.created_at / 1000, 'unixepoch', 'localtime')", false);
  static const SherdColumn excavated =
      text(kExcavated, records::FieldKind::Day, nullptr,
           "ifnull((SELECT excavated_on FROM context WHERE context.row = s.context), '')", false);
  if (name == kEntered) return &entered;
  if (name == kExcavated) return &excavated;
  if (name == kLabelEnd) return &end;
  if (name == kLabelPlace) return &place;
  return name == "thickness" ? sherdColumn("thickness_mean_mm") : nullptr;
}

const std::vector<records::SherdField>& sherdFields() {
  static const std::vector<records::SherdField> all = [] {
    std::vector<records::SherdField> fields;
    for (const SherdColumn& column : sherdColumns()) fields.push_back(column.field);
    return fields;
  }();
  return all;
}

const std::vector<records::SherdField>& filterFields() {
  static const std::vector<records::SherdField> all = [] {
    std::vector<records::SherdField> fields = sherdFields();
    for (const char* day : {kEntered, kExcavated}) fields.push_back(sherdColumn(day)->field);
    return fields;
  }();
  return all;
}

const records::SherdField* sherdField(std::string_view name) {
  for (const records::SherdField& field : sherdFields())
    if (name == field.name) return &field;
  return nullptr;
}

std::string customText(const std::string& extra_json, const std::string& name) {
  const nlohmann::json extra = jsonOrDiscarded(extra_json);
  const auto found = extra.is_object() ? extra.find(name) : extra.end();
  if (!extra.is_object() || found == extra.end()) return {};
  return found->is_string() ? found->get<std::string>() : found->dump();
}

std::string textOf(const records::SherdRecord& sherd, const std::string& field) {
  if (field.starts_with("extra.")) return customText(sherd.extra_json, field.substr(6));
  const SherdColumn* column = sherdColumn(field);
  if (!column) return {};
  if (column->text) return sherd.*column->text;
  if (column->terms) return store::joinTerms(sherd.*column->terms);
  if (column->measure) {
    const auto value = sherd.measures.find(column->measure);
    return value == sherd.measures.end() ? std::string() : store::numberText(value->second);
  }
  if (field == "state") return records::wordOf(sherd.state);
  if (field == "scale") return sherd.scale_doubtful ? kDoubtfulScale : "";
  if (field == "joins") return store::joinTerms(sherd.join_numbers);
  return {};
}

void setJoins(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
              const std::vector<store::SherdRow>& joins) {
  store::Database& database = catalogue.database();
  database.run("DELETE FROM sherd_join WHERE sherd = ?1 OR other = ?1", sherd);
  for (const store::SherdRow& other : joins) {
    database.run("INSERT INTO sherd_join VALUES (?, ?)", sherd, other);
    database.run("INSERT INTO sherd_join VALUES (?, ?)", other, sherd);
  }
}

void setExtra(const catalogue::Catalogue& catalogue, store::SherdRow sherd, const std::string& name,
              const std::string& value) {
  store::Database& database = catalogue.database();
  nlohmann::ordered_json extra = orderedJsonOrDiscarded(
      database.sql("SELECT extra FROM sherd WHERE row = ?", sherd).one<std::string>());
  if (!extra.is_object()) extra = nlohmann::ordered_json::object();
  if (value.empty())
    extra.erase(name);
  else
    extra[name] = value;
  database.run("UPDATE sherd SET extra = ? WHERE row = ?", extra.dump(), sherd);
}

}  // namespace ostraka::sherds
