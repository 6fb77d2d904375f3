#include "metadata/batch_records.h"

#include <nlohmann/json.hpp>

#include "base/message.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/places.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "metadata/json_fields.h"
#include "metadata/restored_rows.h"
#include "records/records.h"
#include "records/sherd.h"
#include "records/words.h"
#include "sherds/pair_decisions.h"
#include "store/database.h"
#include "tables/import_places.h"

namespace ostraka::metadata {
namespace {

using namespace catalogue;
using nlohmann::json;
using nlohmann::ordered_json;
using store::valueOrThrow;

template <class T>
void take(const json& object, const char* key, std::optional<T>& value) {
  if (object.contains(key)) value = object.at(key).get<T>();
}
std::string text(const json& object, const char* key) {
  return object.value(key, "");
}
const json& listOf(const json& object, const char* key) {
  static const json none = json::array();
  return object.contains(key) ? object.at(key) : none;  // exports before there were any
}

// Where a photograph of the batch goes in an export.
std::string exportedAs(const std::string& path, const std::string& batch) {
  const std::string folder = "batches/" + batch + "/";
  const std::string inside =
      path.starts_with(folder) ? path.substr(folder.size()) : path.substr(path.rfind('/') + 1);
  return "photographs/" + batch + "/" + inside;
}

class Writing {
 public:
  Writing(const Catalogue& catalogue, const std::vector<archive::BagFile>& exported)
      : catalogue_(catalogue) {
    for (const archive::BagFile& file : exported) exported_[file.path] = &file;
  }

  ordered_json batch(store::BatchRow row) {
    const records::BatchRecord b = valueOrThrow(Batches(catalogue_).get(row));
    if (persons_.empty()) {
      for (const auto& p : valueOrThrow(People(catalogue_).all())) persons_[p.row] = p.id;
      for (const auto& bag : valueOrThrow(Places(catalogue_).bags())) bag_ids_[bag.row] = bag.id;
    }
    ordered_json one = {{"id", b.id},
                        {"number", b.number},
                        {"state", records::wordOf(b.state)},
                        {"counted", b.counted}};
    put(one, "operator", persons_[b.operator_]);
    for (const store::BagRow& bag : b.bags) one["bags"].push_back(bag_ids_[bag]);
    put(one, "started_ms", b.started_ms);
    put(one, "ended_ms", b.ended_ms);
    put(one, "reprojection_px", b.reprojection_px);
    put(one, "scale_error_pct", b.scale_error_pct);
    put(one, "scale", b.scale.english());
    put(one, "scale_doubts", linesOf(b.scale_doubts));
    put(one, "rig_sha256", b.rig_sha256);
    put(one, "program", b.program);
    put(one, "settings_sha256", b.settings_sha256);
    put(one, "note", b.note);
    ids_ = valueOrThrow(idsOf(catalogue_, row));
    photographs(b, one);
    scans(b, one);
    decisions(b, one);
    pieces(b, one);
    files(b, one);
    return one;
  }

 private:
  std::string scanId(store::ScanRow row) const { return row ? ids_.scans.at(row) : std::string(); }

  void photographs(const records::BatchRecord& b, ordered_json& one) {
    for (const records::PhotographRecord& p :
         valueOrThrow(Batches(catalogue_).photographs(b.row))) {
      ordered_json out = {{"id", ids_.photographs[p.row]},
                          {"side", records::wordOf(p.side)},
                          {"camera", std::string(1, p.camera)},
                          {"stop", p.stop},
                          {"take", p.take},
                          {"path", p.path},
                          {"used", p.used}};
      put(out, "serial", p.serial);
      if (p.exif_json != "{}") put(out, "exif", p.exif_json);
      put(out, "angle_deg", p.angle_deg);
      put(out, "sharpness", p.sharpness);
      put(out, "reason", p.reason);
      one["photographs"].push_back(std::move(out));
    }
  }

  void scans(const records::BatchRecord& b, ordered_json& one) {
    for (const records::ScanRecord& s : valueOrThrow(Batches(catalogue_).scans(b.row))) {
      ordered_json out = {{"id", ids_.scans[s.row]}, {"side", records::wordOf(s.side)},
                          {"index", s.index},        {"name", s.name},
                          {"path", s.path},          {"state", records::wordOf(s.state)}};
      put(out, "points", s.points);
      put(out, "coverage_pct", s.coverage_pct);
      put(out, "plate_x_mm", s.plate_x_mm);
      put(out, "plate_y_mm", s.plate_y_mm);
      one["scans"].push_back(std::move(out));
    }
  }

  void decisions(const records::BatchRecord& b, ordered_json& one) {
    for (const records::PairDecision& d :
         valueOrThrow(sherds::PairDecisions(catalogue_).all(b.row))) {
      ordered_json out = {{"id", ids_.decisions[d.row]},
                          {"at_ms", d.at_ms},
                          {"verdict", records::wordOf(d.verdict)}};
      put(out, "decision", d.decision);
      put(out, "by", persons_[d.by]);
      put(out, "front", scanId(d.front));
      put(out, "back", scanId(d.back));
      if (d.replaces) put(out, "replaces", ids_.decisions[d.replaces]);
      if (d.front_from_back) out["T_front_from_back"] = toJson(*d.front_from_back);
      put(out, "score", d.score);
      put(out, "margin", d.margin);
      put(out, "fracture_rms_mm", d.fracture_rms_mm);
      put(out, "fracture_overlap", d.fracture_overlap);
      if (d.ambiguous) out["ambiguous"] = true;
      put(out, "note", d.note);
      one["decisions"].push_back(std::move(out));
    }
  }

  void pieces(const records::BatchRecord& b, ordered_json& one) {
    for (const PieceRow& d : valueOrThrow(pieceRows(catalogue_, b.row))) {
      ordered_json out = {
          {"id", d.id}, {"at_ms", d.at_ms}, {"side", d.side}, {"verdict", d.verdict}};
      put(out, "decision", d.decision);
      put(out, "by", d.by);
      put(out, "pieces", d.pieces_json);
      put(out, "cut_mm", d.cut_json);
      put(out, "replaces", d.replaces);
      put(out, "note", d.note);
      one["piece_decisions"].push_back(std::move(out));
    }
  }

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
  std::map<store::PersonRow, std::string> persons_;
  std::map<store::BagRow, std::string> bag_ids_;
  BatchIds ids_;  ///< of the present batch
};

class Entering {
 public:
  Entering(Catalogue& catalogue, const archive::BagReader& bag,
           const std::map<std::string, std::int64_t>& rows, const records::Provenance& provenance)
      : catalogue_(catalogue), bag_(bag), rows_(rows), provenance_(provenance) {}

  void batch(const json& b) {
    records::BatchRecord batch;
    batch.id = text(b, "id");
    batch.note = text(b, "note");
    batch.number = number_ = text(b, "number");
    if (const auto there = valueOrThrow(Batches(catalogue_).byId(batch.id))) {
      read.numbers[number_] = there->number;
      return;
    }
    if (Batches(catalogue_).byNumber(number_)) {
      // This import's own copies lie there already when the batch enters.
      batch.number = valueOrThrow(Batches(catalogue_).lowestFreeNumber());
      batch.note += (batch.note.empty() ? "" : "\n") + ("Was " + number_ + " where it was made.");
    }
    read.numbers[number_] = batch.number;
    batch.state = records::fromWord<records::BatchState>(text(b, "state"));
    // What was under way there is neither photographed on nor computed here by itself.
    if (batch.state < records::BatchState::Review) batch.state = records::BatchState::Failed;
    batch.counted = wholeOr(b, "counted", 0);
    batch.operator_ = {row(b, "operator")};
    for (const json& id : listOf(b, "bags")) {
      const auto bag = rows_.find(id.get<std::string>());
      if (bag != rows_.end()) batch.bags.push_back({bag->second});
    }
    take(b, "started_ms", batch.started_ms);
    take(b, "ended_ms", batch.ended_ms);
    take(b, "reprojection_px", batch.reprojection_px);
    take(b, "scale_error_pct", batch.scale_error_pct);
    if (const std::string scale = text(b, "scale"); !scale.empty()) batch.scale = Message(scale);
    if (const std::string doubts = text(b, "scale_doubts"); !doubts.empty())
      batch.scale_doubts.emplace_back(doubts);
    batch.rig_sha256 = text(b, "rig_sha256");
    batch.program = text(b, "program");
    batch.settings_sha256 = text(b, "settings_sha256");
    const store::BatchRow added = valueOrThrow(Batches(catalogue_).add(batch, provenance_));
    read.fresh.insert(added);
    for (const json& p : listOf(b, "photographs")) photograph(p, added);
    for (const json& s : listOf(b, "scans")) scan(s, added);
    for (const json& d : listOf(b, "decisions")) decision(d, added);
    for (const json& d : listOf(b, "piece_decisions")) {
      const PieceRow piece{text(d, "id"),      text(d, "decision"),
                           text(d, "by"),      text(d, "side"),
                           text(d, "verdict"), text(d, "pieces"),
                           text(d, "cut_mm"),  text(d, "replaces"),
                           text(d, "note"),    wholeIn(d.at("at_ms"), "at_ms", 0, INT64_MAX)};
      valueOrThrow(restorePieceRow(catalogue_, added, {row(d, "by")}, piece));
    }
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
  std::int64_t row(const json& object, const char* key) const {
    const auto found = rows_.find(text(object, key));
    return found == rows_.end() ? 0 : found->second;
  }
  std::int64_t own(const json& object, const char* key) const {
    const auto found = own_.find(text(object, key));
    return found == own_.end() ? 0 : found->second;
  }

  void photograph(const json& p, store::BatchRow batch) {
    records::PhotographRecord photograph;
    photograph.batch = batch;
    photograph.side = records::fromWord<batch::Side>(text(p, "side"));
    const std::string camera = text(p, "camera");
    photograph.camera = camera.empty() ? 'A' : camera[0];
    photograph.stop = wholeAt(p, "stop");
    photograph.take = wholeAt(p, "take");
    photograph.path = here(text(p, "path"));
    photograph.serial = text(p, "serial");
    photograph.exif_json = text(p, "exif");
    take(p, "angle_deg", photograph.angle_deg);
    take(p, "sharpness", photograph.sharpness);
    photograph.used = p.value("used", true);
    photograph.reason = text(p, "reason");
    valueOrThrow(restorePhotograph(catalogue_, photograph, text(p, "id"), provenance_));
  }

  void scan(const json& s, store::BatchRow batch) {
    records::ScanRecord scan;
    scan.batch = batch;
    scan.side = records::fromWord<batch::Side>(text(s, "side"));
    scan.index = wholeAt(s, "index");
    scan.name = text(s, "name");
    scan.path = here(text(s, "path"));
    take(s, "points", scan.points);
    take(s, "coverage_pct", scan.coverage_pct);
    take(s, "plate_x_mm", scan.plate_x_mm);
    take(s, "plate_y_mm", scan.plate_y_mm);
    scan.state = records::fromWord<records::ScanState>(text(s, "state"));
    own_[text(s, "id")] =
        valueOrThrow(restoreScan(catalogue_, scan, text(s, "id"), provenance_)).value;
  }

  void decision(const json& d, store::BatchRow batch) {
    records::PairDecision decision;
    decision.at_ms = wholeIn(d.at("at_ms"), "at_ms", 0, INT64_MAX);
    decision.batch = batch;
    decision.decision = text(d, "decision");
    decision.by = {row(d, "by")};
    decision.front = {own(d, "front")};
    decision.back = {own(d, "back")};
    decision.replaces = {own(d, "replaces")};
    decision.verdict = records::fromWord<records::Verdict>(text(d, "verdict"));
    if (d.contains("T_front_from_back"))
      decision.front_from_back =
          valueOrThrow(isometryFromJson(d.at("T_front_from_back"), "metadata/batches.json"));
    take(d, "score", decision.score);
    take(d, "margin", decision.margin);
    take(d, "fracture_rms_mm", decision.fracture_rms_mm);
    take(d, "fracture_overlap", decision.fracture_overlap);
    decision.ambiguous = d.value("ambiguous", false);
    decision.note = text(d, "note");
    own_[text(d, "id")] =
        valueOrThrow(sherds::restoreDecision(catalogue_, decision, text(d, "id"))).value;
  }

  void file(const json& f, store::BatchRow batch) {
    records::FileRecord file;
    file.id = text(f, "id");
    file.path =
        valueOrThrow(tables::importPlace(here(text(f, "path")), read.numbers.at(number_))).text();
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
  const std::map<std::string, std::int64_t>& rows_;
  const records::Provenance& provenance_;
  std::map<std::string, std::int64_t> own_;  ///< id -> row of scans and decisions
  std::string number_;                       ///< of the present batch in the export
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
