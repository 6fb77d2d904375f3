#include "metadata/batch_records.h"

#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/batches.h"
#include "catalogue/file_places.h"
#include "catalogue/files.h"
#include "catalogue/places.h"
#include "files/json_numbers.h"
#include "metadata/json_fields.h"
#include "records/records.h"
#include "records/sherd.h"
#include "records/words.h"
#include "sherds/pair_decisions.h"
#include "store/database.h"

namespace ostraka::metadata {
namespace {

using namespace catalogue;
using nlohmann::json;
using nlohmann::ordered_json;
using store::valueOrThrow;

std::string text(const json& object, const char* key) {
  return object.value(key, "");
}
const json& listOf(const json& object, const char* key) {
  static const json none = json::array();
  return object.contains(key) ? object.at(key) : none;  // an empty list is not written
}

// Where a photograph of the batch goes in an export.
std::string exportedAs(const std::string& path, const std::string& batch) {
  const std::string folder = "batches/" + batch + "/";
  const std::string inside =
      path.starts_with(folder) ? path.substr(folder.size()) : path.substr(path.rfind('/') + 1);
  return "photographs/" + batch + "/" + inside;
}

// The fields of the records, as PutFields and TakenFields want them; in the order of the file.
void photograph(auto&& fields, auto& p) {
  fields.always("id", p.id);
  fields.word("side", p.side);
  fields.always("camera", p.camera);
  fields.always("stop", p.stop);
  fields.always("take", p.take);
  fields.always("path", p.path);
  fields.always("used", p.used);
  fields("serial", p.serial);
  if (p.exif_json != "{}") fields("exif", p.exif_json);
  fields("angle_deg", p.angle_deg);
  fields("sharpness", p.sharpness);
  fields("reason", p.reason);
}

void scan(auto&& fields, auto& s) {
  fields.always("id", s.id);
  fields.word("side", s.side);
  fields.always("index", s.index);
  fields.always("name", s.name);
  fields.always("path", s.path);
  fields.word("state", s.state);
  fields("points", s.points);
  fields("coverage_pct", s.coverage_pct);
  fields("plate_x_mm", s.plate_x_mm);
  fields("plate_y_mm", s.plate_y_mm);
}

void decision(auto&& fields, auto& d) {
  fields.always("id", d.id);
  fields.always("at_ms", d.at_ms);
  fields.word("verdict", d.verdict);
  fields("decision", d.decision);
  fields("by", d.by);
  fields("front", d.front);
  fields("back", d.back);
  fields("replaces", d.replaces);
  fields("T_front_from_back", d.front_from_back);
  fields("score", d.score);
  fields("margin", d.margin);
  fields("fracture_rms_mm", d.fracture_rms_mm);
  fields("fracture_overlap", d.fracture_overlap);
  fields("ambiguous", d.ambiguous);
  fields("note", d.note);
}

// A decision about pieces as its row has it, but for the id of what it replaces.
struct Piece {
  std::string id, decision, side, verdict, pieces, cut_mm, replaces, note;
  store::PersonRow by;
  std::int64_t at_ms = 0;
};

void piece(auto&& fields, auto& d) {
  fields.always("id", d.id);
  fields.always("at_ms", d.at_ms);
  fields.always("side", d.side);
  fields.always("verdict", d.verdict);
  fields("decision", d.decision);
  fields("by", d.by);
  fields("pieces", d.pieces);
  fields("cut_mm", d.cut_mm);
  fields("replaces", d.replaces);
  fields("note", d.note);
}

// Of a batch, what both ways list alike.
void figures(auto&& fields, auto& b) {
  fields("started_ms", b.started_ms);
  fields("ended_ms", b.ended_ms);
  fields("reprojection_px", b.reprojection_px);
  fields("scale_error_pct", b.scale_error_pct);
}
void origins(auto&& fields, auto& b) {
  fields("rig_sha256", b.rig_sha256);
  fields("program", b.program);
  fields("settings_sha256", b.settings_sha256);
  fields("note", b.note);
}

const std::string& wellFormed(const std::string& id) {
  if (!isUuid(id)) store::refuse(message("A uuid of the export is not well formed."), id);
  return id;
}

class Writing {
 public:
  Writing(const Catalogue& catalogue, const std::vector<archive::BagFile>& exported)
      : catalogue_(catalogue) {
    for (const archive::BagFile& file : exported) exported_[file.path] = &file;
    for (const auto& p : valueOrThrow(People(catalogue_).all())) ids_[p.row] = p.id;
    for (const auto& bag : valueOrThrow(Places(catalogue_).bags())) ids_[bag.row] = bag.id;
  }

  ordered_json batch(store::BatchRow row) {
    const records::BatchRecord b = valueOrThrow(Batches(catalogue_).get(row));
    ordered_json one = {{"id", b.id},
                        {"number", b.number},
                        {"state", records::wordOf(b.state)},
                        {"counted", b.counted}};
    PutFields fields{one, ids_};
    fields("operator", b.operator_);
    for (const store::BagRow& bag : b.bags) one["bags"].push_back(ids_[bag]);
    figures(fields, b);
    put(one, "scale", b.scale.english());
    put(one, "scale_doubts", linesOf(b.scale_doubts));
    origins(fields, b);
    const auto add = [&](const char* list, const auto& records, const auto& write) {
      for (const auto& record : records) {
        ordered_json out;
        write(PutFields{out, ids_}, record);
        one[list].push_back(std::move(out));
      }
    };
    add("photographs", valueOrThrow(Batches(catalogue_).photographs(row)),
        [](auto&& to, auto& p) { photograph(to, p); });
    const auto scans = valueOrThrow(Batches(catalogue_).scans(row));
    for (const records::ScanRecord& s : scans) ids_[s.row] = s.id;
    add("scans", scans, [](auto&& to, auto& s) { scan(to, s); });
    const auto decisions = valueOrThrow(sherds::PairDecisions(catalogue_).all(row));
    for (const records::PairDecision& d : decisions) ids_[d.row] = d.id;
    add("decisions", decisions, [](auto&& to, auto& d) { decision(to, d); });
    using P = Piece;
    add("piece_decisions",
        catalogue_.database()
            .sql("SELECT d.id, d.decision, d.person, d.side, d.verdict, d.pieces, d.cut_mm, r.id, "
                 "d.note, d.at FROM piece_decision d LEFT JOIN piece_decision r ON r.row = "
                 "d.replaces WHERE d.batch = ? ORDER BY d.row",
                 row)
            .all(&P::id, &P::decision, &P::by, &P::side, &P::verdict, &P::pieces, &P::cut_mm,
                 &P::replaces, &P::note, &P::at_ms),
        [](auto&& to, auto& d) { piece(to, d); });
    files(b, one);
    return one;
  }

 private:
  void files(const records::BatchRecord& b, ordered_json& one) {
    for (const records::FileRecord& f : valueOrThrow(Files(catalogue_).of(b.row))) {
      const std::string at = exportedAs(f.path, b.number);
      const auto exported = exported_.find("data/" + at);
      if ((f.role != "photo" && f.role != "scale") || exported == exported_.end()) continue;
      // Of what goes along: the photograph may have changed since it was entered.
      one["files"].push_back({{"id", f.id},
                              {"role", f.role},
                              {"path", f.path},
                              {"sha256", exported->second->sha256},
                              {"bytes", exported->second->bytes},
                              {"media_type", f.media_type},
                              {"at", at}});
    }
  }

  const Catalogue& catalogue_;
  std::map<std::string, const archive::BagFile*> exported_;  ///< by their paths in the bag
  Ids ids_;
};

class Entering {
 public:
  Entering(Catalogue& catalogue, const archive::BagReader& bag,
           const std::map<std::string, std::int64_t>& rows, const records::Provenance& provenance)
      : catalogue_(catalogue), bag_(bag), rows_(rows), provenance_(provenance) {}

  void batch(const json& b) {
    records::BatchRecord batch;
    batch.id = text(b, "id");
    batch.number = number_ = text(b, "number");
    if (const auto there = valueOrThrow(Batches(catalogue_).byId(batch.id))) {
      read.numbers[number_] = there->number;
      return;
    }
    std::string note;  // behind its own
    if (Batches(catalogue_).byNumber(number_)) {
      // This import's own copies lie there already when the batch enters.
      batch.number = valueOrThrow(Batches(catalogue_).lowestFreeNumber());
      note = (text(b, "note").empty() ? "" : "\n") + ("Was " + number_ + " where it was made.");
    }
    read.numbers[number_] = batch.number;
    batch.state = records::fromWord<records::BatchState>(text(b, "state"));
    // What was under way there is neither photographed on nor computed here by itself.
    if (batch.state < records::BatchState::Review) batch.state = records::BatchState::Failed;
    batch.counted = wholeOr(b, "counted", 0);
    TakenFields fields{b, rows_};
    fields("operator", batch.operator_);
    for (const json& id : listOf(b, "bags")) {
      const auto bag = rows_.find(id.get<std::string>());
      if (bag != rows_.end()) batch.bags.push_back({bag->second});
    }
    figures(fields, batch);
    if (const std::string scale = text(b, "scale"); !scale.empty()) batch.scale = Message(scale);
    if (const std::string doubts = text(b, "scale_doubts"); !doubts.empty())
      batch.scale_doubts.emplace_back(doubts);
    origins(fields, batch);
    batch.note += note;
    const store::BatchRow added = valueOrThrow(Batches(catalogue_).add(batch, provenance_));
    read.fresh.insert(added);
    for (const json& p : listOf(b, "photographs")) {
      records::PhotographRecord taken;
      photograph(TakenFields{p, rows_}, taken);
      taken.batch = added;
      taken.path = here(taken.path);
      wellFormed(taken.id);
      valueOrThrow(Batches(catalogue_).save(taken, provenance_));
    }
    for (const json& s : listOf(b, "scans")) scanOf(s, added);
    for (const json& d : listOf(b, "decisions")) {
      records::PairDecision taken;
      decision(TakenFields{d, rows_}, taken);
      taken.batch = added;
      rows_.try_emplace(taken.id, valueOrThrow(sherds::restoreDecision(catalogue_, taken)).value);
    }
    for (const json& d : listOf(b, "piece_decisions")) pieceOf(d, added);
    for (const json& f : listOf(b, "files")) file(f, added);
  }

  ReadBatches read;

 private:
  // The folders of a batch bear its number.
  std::string here(const std::string& path) const {
    for (const char* folder : {"batches/", "results/", "models/"})
      if (const std::string old = folder + number_ + "/"; path.starts_with(old))
        return folder + read.numbers.at(number_) + "/" + path.substr(old.size());
    return path;
  }

  void scanOf(const json& s, store::BatchRow batch) {
    records::ScanRecord taken;
    scan(TakenFields{s, rows_}, taken);
    taken.batch = batch;
    taken.path = here(taken.path);
    wellFormed(taken.id);
    const store::ScanRow row = valueOrThrow(Batches(catalogue_).save(taken, provenance_));
    catalogue_.database().run("UPDATE scan SET state = ? WHERE row = ?",
                              records::wordOf(taken.state), row);
    rows_.try_emplace(taken.id, row.value);
  }

  void pieceOf(const json& d, store::BatchRow batch) {
    Piece taken;
    piece(TakenFields{d, rows_}, taken);
    if (!taken.decision.empty()) wellFormed(taken.decision);
    catalogue_.database().run(
        "INSERT INTO piece_decision (id, decision, came_alone, at, person, batch, side, verdict, "
        "pieces, cut_mm, replaces, note) VALUES (?, ?, 1, ?, ?, ?, ?, ?, ?, ?, (SELECT row FROM "
        "piece_decision WHERE id = ?), ?)",
        wellFormed(taken.id), taken.decision, taken.at_ms, taken.by, batch, taken.side,
        taken.verdict, taken.pieces, taken.cut_mm, taken.replaces, taken.note);
  }

  void file(const json& f, store::BatchRow batch) {
    records::FileRecord file;
    file.id = text(f, "id");
    file.path =
        valueOrThrow(catalogue::importPlace(here(text(f, "path")), read.numbers.at(number_)))
            .text();
    const std::int64_t bytes = wholeIn(f.at("bytes"), "bytes", 0, INT64_MAX);
    const archive::BagFile verified =
        valueOrThrow(verifiedFile(bag_, text(f, "at"), text(f, "sha256"), bytes));
    file.sha256 = verified.sha256;
    file.bytes = verified.bytes;
    file.media_type = text(f, "media_type");
    file.role = text(f, "role") == "scale" ? "scale" : "photo";
    file.batch = batch;
    valueOrThrow(Files(catalogue_).save(file, provenance_));
    read.copies.push_back({text(f, "at"), file.path});
  }

  Catalogue& catalogue_;
  const archive::BagReader& bag_;
  RowsById rows_;  ///< of persons and bags, and of the scans and decisions that entered
  const records::Provenance& provenance_;
  std::string number_;  ///< of the present batch in the export
};

}  // namespace

Result<ordered_json> batchesJson(const Catalogue& catalogue,
                                 const std::set<store::BatchRow>& batches,
                                 const std::vector<archive::BagFile>& exported) {
  return catalogue.database().asResult([&] {
    ordered_json list = ordered_json::array();
    Writing writing(catalogue, exported);
    for (const store::BatchRow row : batches) list.push_back(writing.batch(row));
    return ordered_json{{"batches", list}};
  });
}

Result<void> restoreScans(const Catalogue& catalogue, store::SherdRow sherd, store::ScanRow front,
                          store::ScanRow back) {
  return catalogue.database().inTransaction([&] {
    catalogue.database().run("UPDATE sherd SET front = ?, back = ? WHERE row = ?", front, back,
                             sherd);
  });
}

Result<archive::BagFile> verifiedFile(const archive::BagReader& bag, const std::string& at,
                                      const std::string& sha256, std::int64_t bytes) {
  const archive::BagFile* file = bag.find("data/" + at);
  if (!file) return Error::unusable(message("This file is not part of the export."), at);
  if (file->sha256 != sha256 || file->bytes != bytes)
    return Error::unusable(message("This file has changed since the export; nothing was read."),
                           at);
  return *file;
}

Result<ReadBatches> readBatches(Catalogue& catalogue, const archive::BagReader& bag,
                                const json& batches,
                                const std::map<std::string, std::int64_t>& rows,
                                const records::Provenance& provenance) {
  return catalogue.database().asResult([&] {
    Entering entering(catalogue, bag, rows, provenance);
    for (const json& b : batches.at("batches")) entering.batch(b);
    return std::move(entering.read);
  });
}

}  // namespace ostraka::metadata
