#include "metadata/sherd_json.h"

#include <nlohmann/json.hpp>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "metadata/json_fields.h"
#include "records/sherd.h"
#include "records/words.h"
#include "sherds/measurements.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherd_fields.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::metadata {
namespace {

using catalogue::Catalogue;
using nlohmann::json;
using nlohmann::ordered_json;
using records::SherdRecord;
using store::valueOrThrow;

std::string initialsOf(const Catalogue& catalogue, store::PersonRow row) {
  if (!row) return {};
  if (const auto persons = catalogue::People(catalogue).all())
    for (const auto& person : *persons)
      if (person.row == row) return person.initials;
  return {};
}

ordered_json measurementsOf(const Catalogue& catalogue, const SherdRecord& sherd,
                            const std::vector<records::Measurement>& all) {
  ordered_json list = ordered_json::array();
  for (const records::Measurement& m : all) {
    ordered_json one = {
        {"kind", m.kind}, {"value", m.value}, {"unit", m.unit}, {"method", m.method}};
    put(one, "uncertainty", m.uncertainty);
    if (sherd.doubtful.contains(m.kind)) one["doubtful"] = true;
    put(one, "by", initialsOf(catalogue, m.by));
    put(one, "model_sha256", m.model_sha256);
    list.push_back(std::move(one));
  }
  return list;
}

ordered_json pairingOf(const Catalogue& catalogue, const SherdRecord& sherd) {
  ordered_json pairing = ordered_json::object();
  if (!sherd.batch) return pairing;
  std::map<store::ScanRow, std::string> names;
  if (const auto scans = catalogue::Batches(catalogue).scans(sherd.batch))
    for (const auto& scan : *scans) names[scan.row] = scan.name;
  put(pairing, "front", names[sherd.front]);
  put(pairing, "back", names[sherd.back]);
  if (const auto decisions = sherds::PairDecisions(catalogue).current(sherd.batch))
    for (const auto& d : *decisions)
      if (d.front == sherd.front && d.back == sherd.back && sherd.front) {
        put(pairing, "score", d.score);
        pairing["by"] = d.by ? "person" : "program";
      }
  return pairing;
}

// path into the JSON -> field of the table
const std::vector<std::pair<const char*, const char*>> kTexts = {
    {"/id", "uuid"},
    {"/number", "number"},
    {"/void_reason", "void_reason"},
    {"/provenience/site", "site"},
    {"/provenience/trench", "trench"},
    {"/provenience/context", "context"},
    {"/provenience/bag", "bag"},
    {"/description/part", "part"},
    {"/description/ware", "ware"},
    {"/description/fabric", "fabric"},
    {"/description/inclusions", "inclusions"},
    {"/description/manufacture", "manufacture"},
    {"/description/firing", "firing"},
    {"/description/surface/out", "surface_out"},
    {"/description/surface/in", "surface_in"},
    {"/description/decoration", "decoration"},
    {"/description/munsell/out", "munsell_out"},
    {"/description/munsell/in", "munsell_in"},
    {"/description/munsell/core", "munsell_core"},
    {"/description/condition", "condition"},
    {"/description/joins", "joins"},
    {"/description/vessel", "vessel"},
    {"/description/note", "note"},
    {"/dating/period", "period"},
    {"/dating/date_edtf", "date_edtf"},
    {"/digitisation/batch", "batch"}};

const std::set<std::string> kKnown = {
    "@context",     "format",      "id",          "number",  "state",
    "void_reason",  "provenience", "description", "dating",  "measurements",
    "digitisation", "pairing",     "files",       "licence", "rights_holder",
    "processing",   "proposals",   "extra"};

// The fields in the order of the table above, nested as it says.
void putTexts(ordered_json& out, const SherdRecord& sherd) {
  for (const auto& [pointer, field] : kTexts) {
    const json::json_pointer path{std::string(pointer)};
    if (path.parent_pointer().empty() && std::string_view(field) != "void_reason") continue;
    if (std::string_view(field) == "batch") continue;
    const std::string text = sherds::textOf(sherd, field);
    if (text.empty()) continue;
    const records::FieldKind kind = sherds::sherdField(field)->kind;
    if (kind == records::FieldKind::Terms || kind == records::FieldKind::Joins)
      out[path] = store::splitTerms(text);
    else
      out[path] = text;
  }
}

ordered_json filesJson(const std::vector<SherdFile>& files) {
  ordered_json list = ordered_json::array();
  for (const SherdFile& file : files) {
    ordered_json one = {
        {"role", file.role}, {"path", file.path}, {"sha256", file.sha256}, {"bytes", file.bytes}};
    // Not for what lies beside a model: an OBJ's material, a picture.
    if (file.role == "model" && !file.path.ends_with(".mtl") && !file.path.ends_with(".png")) {
      one["unit"] = file.path.ends_with(".glb") ? "m" : "mm";
      one["frame"] = "plate_front";
    }
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

Result<std::string> sherdJson(const Catalogue& catalogue, const SherdRecord& sherd,
                              const std::vector<SherdFile>& files, const GlbExtras& model,
                              const std::string& program) {
  return catalogue.database().asResult([&] {
    const auto project = valueOrThrow(catalogue::Settings(catalogue).project());
    ordered_json out = {
        {"@context", "context.jsonld"}, {"format", "ostraka-sherd/1"}, {"id", sherd.id}};
    put(out, "number", sherd.number);
    out["state"] = records::wordOf(sherd.state);
    putTexts(out, sherd);
    out["measurements"] = measurementsOf(
        catalogue, sherd, valueOrThrow(sherds::Measurements(catalogue).of(sherd.row)));
    ordered_json digitisation = ordered_json::object();
    std::string used_program = program;
    if (sherd.batch) {
      const auto batch = valueOrThrow(catalogue::Batches(catalogue).get(sherd.batch));
      digitisation["batch"] = batch.number;
      if (batch.started_ms) digitisation["shot_on"] = utcDay(*batch.started_ms);
      put(digitisation, "operator", initialsOf(catalogue, batch.operator_));
      put(digitisation, "scale_error_pct", batch.scale_error_pct);
      put(digitisation, "scale", batch.scale.english());
      put(digitisation, "scale_doubts", linesOf(batch.scale_doubts));
      if (!batch.program.empty()) used_program = batch.program;
    }
    put(out, "digitisation", std::move(digitisation));
    put(out, "pairing", pairingOf(catalogue, sherd));
    if (const ordered_json munsell = orderedJsonOrDiscarded(model.munsell); munsell.is_object())
      out["proposals"] = {{"munsell", munsell}};
    out["files"] = filesJson(files);
    put(out, "licence", project.licence);
    put(out, "rights_holder", project.rights_holder);
    out["processing"] = {{"program", used_program}};
    put(out["processing"], "texture", model.texture);
    const ordered_json extra = orderedJsonOrDiscarded(sherd.extra_json);
    if (extra.is_object() && !extra.empty()) out["extra"] = extra;
    return valueOrThrow(jsonText(out, sherd.number.empty() ? sherd.id : sherd.number)) + "\n";
  });
}

Result<ReadSherdJson> parseSherdJson(std::string_view text, const std::string& where) {
  const Result<json> value = parseFields(text, where);
  if (!value) return value.error();
  const auto bad = [&](const Message& what) { return Error::unusable(what, where); };
  if (!value->is_object() || value->value("format", json()) != "ostraka-sherd/1")
    return bad(message("Not a sherd record (ostraka-sherd/1)."));
  ReadSherdJson read;
  try {
    for (const auto& [pointer, field] : kTexts) {
      const json::json_pointer path{std::string(pointer)};
      if (!value->contains(path)) continue;
      const json& at = value->at(path);
      const std::string entry = at.is_array() ? store::joinTerms(at.get<std::vector<std::string>>())
                                              : at.get<std::string>();
      if (!entry.empty()) read.row.values[field] = entry;
    }
    for (const json& m : value->value("measurements", json::array())) {
      records::Measurement measurement;
      measurement.kind = m.at("kind").get<std::string>();
      measurement.value = numberAt(m, "value");
      measurement.method = m.value("method", "program");
      measurement.model_sha256 = m.value("model_sha256", "");
      if (m.contains("uncertainty")) measurement.uncertainty = numberAt(m, "uncertainty");
      if (m.value("unit", records::unitOf(measurement.kind)) != records::unitOf(measurement.kind))
        return bad(message("The measurement %1 has a unit other than %2.", measurement.kind,
                           records::unitOf(measurement.kind)));
      read.row.measured.emplace_back(std::move(measurement), m.value("by", ""));
    }
    for (const json& f : value->value("files", json::array()))
      read.files.push_back({f.at("role").get<std::string>(), f.at("path").get<std::string>(),
                            f.at("sha256").get<std::string>(),
                            wholeIn(f.at("bytes"), "bytes", 0, INT64_MAX)});
    const json pairing = value->value("pairing", json::object());
    read.front = pairing.value("front", "");
    read.back = pairing.value("back", "");
    const json extra = value->value("extra", json::object());
    for (const auto& [key, own] : extra.items())
      read.row.values["extra." + key] = own.is_string() ? own.get<std::string>() : own.dump();
    for (const auto& [key, own] : value->items())
      if (!kKnown.contains(key))
        read.row.values["extra." + key] = own.is_string() ? own.get<std::string>() : own.dump();
  } catch (const json::exception& refused) {
    return bad(
        unusableJson(refused, message("A value of the record has the wrong type."), {}).what);
  }
  return read;
}

}  // namespace ostraka::metadata
