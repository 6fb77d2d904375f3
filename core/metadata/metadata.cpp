#include "metadata/metadata.h"

#include <algorithm>
#include <concepts>
#include <nlohmann/json.hpp>
#include <set>

#include "archive/bagit.h"
#include "base/message.h"
#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue/places.h"
#include "catalogue/renamed_places.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "metadata/json_fields.h"
#include "metadata/vocabularies.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/filter.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"

namespace ostraka::metadata {
namespace {

using namespace catalogue;
using nlohmann::json;
using nlohmann::ordered_json;
using store::valueOrThrow;

// The words of the records and what they mean for other programs.
constexpr const char* kContext = R"({
 "@context": {
  "crm": "http://www.cidoc-crm.org/cidoc-crm/",
  "dcterms": "http://purl.org/dc/terms/",
  "aat": "http://vocab.getty.edu/aat/",
  "id": "dcterms:identifier",
  "number": "crm:P1_is_identified_by",
  "provenience": "crm:P53_has_former_or_current_location",
  "description": "crm:P3_has_note",
  "dating": "dcterms:temporal",
  "measurements": "crm:P39i_was_measured_by",
  "kind": "crm:P2_has_type",
  "value": "crm:P90_has_value",
  "unit": "crm:P91_has_unit",
  "digitisation": "dcterms:created",
  "processing": "dcterms:provenance",
  "files": "dcterms:hasFormat",
  "licence": "dcterms:license",
  "rights_holder": "dcterms:rightsHolder"
 }
}
)";

// What may lie in an export, and what it is; of the rest a reader would look for in vain.
struct Part {
  const char* path;  ///< a file, a folder with / at its end, or files of a folder: models/*.ply
  const char* text;
};
constexpr Part kParts[] = {
    {"sherds.csv", "one row per sherd; lengths in mm, areas in mm2, volumes in mm3, weights in g"},
    {"contexts.csv", "where the sherds were found"},
    {"columns.csv", "meanings of the columns of both tables"},
    {"sherds.ods", "sherds, contexts and their columns as one spreadsheet"},
    {"sherds/",
     "one JSON record per sherd (format ostraka-sherd/1, terms in context.jsonld);\n"
     "                 what photographs alone propose, as Munsell colours, is under proposals"},
    {"models/",
     "closed surfaces; a model that was simplified further than this list says\n"
     "                 states its deviation in its file"},
    {"models/*.ply",
     "in mm with z up, coloured, with the photographs of the GLB as PNG beside it\n"
     "                 where there are any"},
    {"models/*.glb",
     "in metres with y up, simplified (nearly all of it by less than 0.05 mm), with\n"
     "                 the photographs as texture, a mask of the texels that were filled in\n"
     "                 and a normal map of the finer relief, or coloured where there are none"},
    {"models/*.obj",
     "in mm with z up, the surface of the GLB with its photographs as MTL and PNG,\n"
     "                 or coloured where there are none"},
    {"images/", "a picture of each model"},
    {"photographs/", "the photographs that the models were made from, unchanged"},
    {"drawings/", "drawings for print"},
    {"views/",
     "photographs without the lens's distortion, masks and poses, for COLMAP and\n"
     "                 OpenMVS: InterfaceCOLMAP -i views/B0001/front -o scene.mvs, or\n"
     "                 colmap gui --import_path views/B0001/front/sparse"}};
constexpr const char* kMetadata =
    "metadata/        the project, its places, its batches with scans and decisions,\n"
    "                 the vocabulary terms that the sherds use\n";
constexpr const char* kGuarded =
    "\nTables (.csv) are for other programs: commas between the values, decimal points, and the\n"
    "same English headings in every language: rely on these. sherds.ods is for people: its "
    "headings\n"
    "are in the language of whoever exported it, and its sheet columns says which is which. Saved "
    "as\n"
    "CSV, each of its sheets can be imported again.\n"
    "\nIn a table, a text that begins with = + - or @ has one ' before it, so that a spreadsheet "
    "does\nnot read it as a formula.\n";
constexpr const char* kBag =
    "\nThe folder is a bag as defined in RFC 8493. In the folder above this one, `sha256sum -c\n"
    "manifest-sha256.txt` checks every file.\n";

std::string listOf(const std::vector<archive::BagFile>& exported) {
  std::string text = "Potsherds, measured in 3D\n=========================\n\n";
  for (const Part& part : kParts) {
    const std::string path = std::string("data/") + part.path;
    const std::size_t any = path.find('*');
    const auto is_there = [&](const archive::BagFile& file) {
      return any != std::string::npos ? file.path.starts_with(path.substr(0, any)) &&
                                            file.path.ends_with(path.substr(any + 1))
             : path.ends_with('/') ? file.path.starts_with(path)
                                   : file.path == path;
    };
    if (!std::any_of(exported.begin(), exported.end(), is_there)) continue;
    std::string name = part.path;
    name.resize(17, ' ');
    text += name + part.text + "\n";
  }
  text += kMetadata;
  const auto table = [](const archive::BagFile& file) { return file.path == "data/sherds.csv"; };
  if (std::any_of(exported.begin(), exported.end(), table)) text += kGuarded;
  return text + kBag;
}

// What nobody who measures on these models may overlook.
std::string readMe(const Catalogue& catalogue, const std::set<store::BatchRow>& batches,
                   const Content& exported) {
  std::string text = listOf(exported.files);
  if (!exported.without_model.empty())
    text +=
        "\nSherds without a model\n"
        "----------------------\n" +
        joined(exported.without_model, "\n") + "\n";
  std::string doubts;
  for (const store::BatchRow row : batches) {
    const records::BatchRecord batch = valueOrThrow(Batches(catalogue).get(row));
    if (!batch.scale_doubts.empty())
      doubts += batch.number + ": " + linesOf(batch.scale_doubts) + "\n";
  }
  if (doubts.empty()) return text;
  return text +
         "\nMeasurements in doubt\n"
         "---------------------\n"
         "The models and measurements of these batches may be wrong (in sherds.csv the\n"
         "column scale says doubtful; the models' files have a comment):\n\n" +
         doubts;
}

template <class T, class Record>
concept Is = std::same_as<std::remove_const_t<T>, Record>;

// The fields of the records, as PutFields and TakenFields want them; in the order of the file.
template <class Fields>
struct Listing {
  Fields fields;

  void operator()(auto& record) {
    fields.always("id", record.id);
    list(record);
  }

 private:
  void list(Is<records::PersonRecord> auto& p) {
    fields.always("name", p.name);
    fields.always("initials", p.initials);
    fields("orcid", p.orcid);
  }
  void list(Is<records::SiteRecord> auto& s) {
    fields.always("code", s.code);
    fields.always("name", s.name);
    fields("gazetteer", s.gazetteer);
    fields("location_public", s.location_public);
    if (Fields::kWrites && !s.location_public) return;  // the place stays with the project's people
    fields("latitude_deg", s.latitude_deg);
    fields("longitude_deg", s.longitude_deg);
  }
  void list(Is<records::TrenchRecord> auto& t) {
    fields("site", t.site);
    fields.always("code", t.code);
    fields.always("name", t.name);
    fields("parent", t.parent);
  }
  void list(Is<records::ContextRecord> auto& c) {
    fields("site", c.site);
    fields("trench", c.trench);
    fields.always("number", c.number);
    fields("kind", c.kind);
    fields("excavated_on", c.excavated_on);
    fields("period", c.period);
    fields("date_edtf", c.date_edtf);
    fields("note", c.note);
    fields("closed", c.closed);
    fields.inner("extra", c.extra_json);
  }
  void list(Is<records::BagRecord> auto& b) {
    fields("context", b.context);
    fields.always("number", b.number);
    fields("collected_on", b.collected_on);
    fields("storage", b.storage);
    fields("count_written", b.count_written);
    fields("weight_g", b.weight_g);
  }
};

ordered_json placesJson(const Catalogue& catalogue, const std::set<store::ContextRow>& wanted) {
  const auto sites = valueOrThrow(Places(catalogue).sites());
  const auto trenches = valueOrThrow(Places(catalogue).trenches());
  const auto contexts = valueOrThrow(Places(catalogue).contexts());
  std::set<store::SiteRow> used_sites;
  for (const records::ContextRecord& c : contexts)
    if (wanted.contains(c.row)) used_sites.insert(c.site);
  Ids ids;
  ordered_json out;
  const auto add = [&](const char* list, const auto& records, const auto& is_wanted) {
    out[list] = ordered_json::array();
    for (const auto& record : records) ids[record.row] = record.id;
    for (const auto& record : records) {
      if (!is_wanted(record)) continue;
      ordered_json one;
      Listing{PutFields{one, ids}}(record);
      out[list].push_back(std::move(one));
    }
  };
  add("persons", valueOrThrow(People(catalogue).all()), [](const auto&) { return true; });
  add("sites", sites, [&](const auto& s) { return used_sites.contains(s.row); });
  add("trenches", trenches, [&](const auto& t) { return used_sites.contains(t.site); });
  add("contexts", contexts, [&](const auto& c) { return wanted.contains(c.row); });
  add("bags", valueOrThrow(Places(catalogue).bags()),
      [&](const auto& b) { return wanted.contains(b.context); });
  return out;
}

// Adds what is not there yet, known by its id, or by what no two of them share: initials, codes,
// numbers. What the project has already stays, and the others' records refer to it.
class Reading {
 public:
  Reading(Catalogue& catalogue, const records::Provenance& provenance)
      : catalogue_(catalogue), provenance_(provenance) {
    for (const auto& p : orEmpty(People(catalogue).all())) know(p, keyOf(p));
    for (const auto& s : orEmpty(Places(catalogue).sites())) know(s, keyOf(s));
    for (const auto& t : orEmpty(Places(catalogue).trenches())) know(t, keyOf(t));
    for (const auto& c : orEmpty(Places(catalogue).contexts())) know(c, keyOf(c));
    for (const auto& b : orEmpty(Places(catalogue).bags())) know(b, keyOf(b));
    for (const auto& [id, row] : orEmpty(joinedPlaces(catalogue))) known_[id] = row;
  }

  void places(const json& places) {
    enter<records::PersonRecord>(places.at("persons"));
    enter<records::SiteRecord>(places.at("sites"));
    enter<records::TrenchRecord>(places.at("trenches"));
    enter<records::ContextRecord>(places.at("contexts"));
    enter<records::BagRecord>(places.at("bags"));
  }

  /// id -> row of everything that is there now.
  const RowsById& rows() const { return known_; }

 private:
  template <class T>
  static std::vector<T> orEmpty(Result<std::vector<T>> list) {
    return list ? std::move(*list) : std::vector<T>();
  }
  template <class Record>
  void enter(const json& list) {
    for (const json& one : list) {
      Record record;
      Listing{TakenFields{one, known_}}(record);
      add(record);
    }
  }
  static std::string key(const char* kind, std::int64_t in, std::int64_t also,
                         const std::string& name) {
    return std::string(kind) + " " + std::to_string(in) + " " + std::to_string(also) + " " +
           store::codeKey(name);
  }
  static std::string keyOf(const records::PersonRecord& p) {
    return key("person", 0, 0, p.initials);
  }
  static std::string keyOf(const records::SiteRecord& s) { return key("site", 0, 0, s.code); }
  static std::string keyOf(const records::TrenchRecord& t) {
    return key("trench", t.site.value, 0, t.code);
  }
  static std::string keyOf(const records::ContextRecord& c) {
    return key("context", c.site.value, c.trench.value, c.number);
  }
  static std::string keyOf(const records::BagRecord& b) {
    return key("bag", b.context.value, 0, b.number);
  }

  template <class Record>
  void know(const Record& record, const std::string& key) {
    known_[record.id] = record.row.value;
    named_[key] = record.row.value;
  }
  template <class Record>
  void add(const Record& record) {
    if (known_.contains(record.id)) return;
    const std::string key = keyOf(record);
    if (const auto same = named_.find(key); same != named_.end()) {
      known_[record.id] = same->second;
      return;
    }
    using Subject =
        std::conditional_t<std::is_same_v<Record, records::PersonRecord>, People, Places>;
    known_[record.id] = named_[key] =
        valueOrThrow(Subject(catalogue_).save(record, provenance_)).value;
  }

  Catalogue& catalogue_;
  const records::Provenance& provenance_;
  RowsById known_, named_;
};

json jsonOf(const archive::BagReader& bag, const std::string& path) {
  const archive::BagFile* file = bag.find(path);
  if (!file) store::refuse(message("This file is not part of the export."), path);
  return valueOrThrow(parseFields(valueOrThrow(bag.read(*file, std::size_t{64} << 20)), path));
}

}  // namespace

std::set<store::ContextRow> contextsOf(const Catalogue& catalogue,
                                       const std::vector<records::SherdRecord>& sherds) {
  std::set<store::ContextRow> contexts;
  for (const records::SherdRecord& sherd : sherds)
    if (sherd.context) contexts.insert(sherd.context);
  if (sherds.size() >= valueOrThrow(sherds::Sherds(catalogue).rows(sherds::Filter{}, {})).size())
    for (const records::ContextRecord& context : valueOrThrow(Places(catalogue).contexts()))
      contexts.insert(context.row);
  return contexts;
}

Result<std::vector<MetadataFile>> metadataOf(const Catalogue& catalogue,
                                             const std::vector<records::SherdRecord>& sherds,
                                             const records::ProjectRecord& project,
                                             const std::string& program, const Content& exported) {
  std::set<store::BatchRow> batches;
  for (const records::SherdRecord& sherd : sherds)
    if (sherd.batch) batches.insert(sherd.batch);
  return catalogue.database().asResult([&] {
    std::set<store::ContextRow> contexts = contextsOf(catalogue, sherds);
    // And of the bags that the batches were made of, wherever their sherds are now.
    const auto bags = valueOrThrow(Places(catalogue).bags());
    for (const store::BatchRow row : batches) {
      const records::BatchRecord batch = valueOrThrow(Batches(catalogue).get(row));
      for (const records::BagRecord& of : bags)
        if (std::find(batch.bags.begin(), batch.bags.end(), of.row) != batch.bags.end())
          contexts.insert(of.context);
    }
    const ordered_json dublin_core = {{"identifier", project.id},
                                      {"code", project.code},
                                      {"title", project.title},
                                      {"creator", project.institution},
                                      {"rightsHolder", project.rights_holder},
                                      {"license", project.licence},
                                      {"type", "Dataset"},
                                      {"format", "ostraka-export/1"},
                                      {"provenance", program},
                                      {"numbering", project.numbering}};
    std::vector<MetadataFile> files;
    const auto add = [&](const char* path, const ordered_json& content) {
      files.push_back({path, valueOrThrow(jsonText(content, path)) + "\n"});
    };
    add("metadata/project.json", dublin_core);
    add("metadata/places.json", placesJson(catalogue, contexts));
    add("metadata/batches.json", valueOrThrow(batchesJson(catalogue, batches, exported.files)));
    add("metadata/vocabularies.json", valueOrThrow(vocabulariesJson(catalogue, sherds)));
    files.push_back({"context.jsonld", kContext});
    files.push_back({"README.txt", readMe(catalogue, batches, exported)});
    return files;
  });
}

Result<ReadBatches> readMetadata(Catalogue& catalogue, const archive::BagReader& bag,
                                 const records::Provenance& provenance) {
  try {
    return catalogue.database().asResult([&] {
      const json places = jsonOf(bag, "data/metadata/places.json");
      const json batches = jsonOf(bag, "data/metadata/batches.json");
      const json words = jsonOf(bag, "data/metadata/vocabularies.json");
      Reading reading(catalogue, provenance);
      reading.places(places);
      valueOrThrow(readVocabularies(catalogue, words, provenance));
      return valueOrThrow(readBatches(catalogue, bag, batches, reading.rows(), provenance));
    });
  } catch (const json::exception& refused) {
    return unusableJson(refused, message("These places and batches are not in Ostraka's format."),
                        "data/metadata");
  }
}

}  // namespace ostraka::metadata
