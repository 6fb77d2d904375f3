// What `ostraka process` left.
#include "intake/read_results.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "files/checksum.h"
#include "files/json.h"
#include "files/json_message.h"
#include "files/json_numbers.h"
#include "files/open_folder.h"
#include "sherds/kept_models.h"
#include "sherds/sherd_columns.h"
#include "stages/output_folder.h"
#include "store/values.h"

namespace ostraka::intake {

namespace fs = std::filesystem;
using nlohmann::json;

std::string relativeTo(const fs::path& project, const fs::path& file) {
  const Result<std::string> path =
      store::checkedPath(fs::absolute(file)
                             .lexically_normal()
                             .lexically_relative(fs::absolute(project).lexically_normal())
                             .generic_string());
  if (!path) store::refuse(message("This file is outside the project's folder."), file.string());
  return *path;
}

std::string mediaTypeOf(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".jpg" || ending == ".jpeg") return "image/jpeg";
  if (ending == ".png") return "image/png";
  if (ending == ".glb") return "model/gltf-binary";
  if (ending == ".html") return "text/html";
  if (ending == ".json") return "application/json";
  return "application/octet-stream";
}

namespace {

std::optional<double> numberIn(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// Ten metres, and their square and cube: no vessel is so large.
double mostOf(const std::string& measurement_kind) {
  const std::string unit = records::unitOf(measurement_kind);
  return unit == "mm3" ? 1e12 : unit == "mm2" ? 1e8 : 1e4;
}

class Reading {
 public:
  Reading(const fs::path& project, const records::BatchRecord& batch, const fs::path& out,
          Progress& progress, std::stop_token stop)
      : project_(project),
        batch_(batch.row),
        batch_number_(batch.number),
        out_(out),
        progress_(progress),
        stop_(std::move(stop)) {}

  ReadResults all() {
    opened_.emplace(store::valueOrThrow(OpenFolder::open(project_)));
    const json pairs = store::valueOrThrow(readJson(out_ / "pairs.json"));
    const json report = store::valueOrThrow(readJson(out_ / "report.json"));
    try {
      // Two scans and three files of the model a pair, and the reports: about that many files.
      total_ = 5 * static_cast<std::int64_t>(pairs.at("pairs").size()) + 3;
      reports();
      pairsOf(pairs);
      scansOf("front");
      scansOf("back");
      edits();
      for (const json& sherd : report.at("sherds")) sherdOf(sherd, report.value("has_scale", true));
      for (const json& stage : report.at("stages"))
        if (stage.at("stage") == "cameras") camerasOf(stage.at("figures"));
      if (report.contains("scale"))
        results_.scale = store::valueOrThrow(
            messageFromJson(report.at("scale"), (out_ / "report.json").string()));
      checkTextOf("report.json", results_.scale.english());
      results_.scale_doubts = store::valueOrThrow(messagesFromJson(
          report.value("scale_doubts", json::array()), (out_ / "report.json").string()));
      checkTextOf("report.json", textOf(results_.scale_doubts));
      for (const Message& doubt : results_.scale_doubts)
        checkTextOf("report.json", doubt.english());
      if (report.value("draft", false))
        results_.scale_doubts.push_back(
            message("This is a draft from reduced photographs; reprocess the batch for final "
                    "measurements."));
    } catch (const json::exception&) {
      store::refuse(message("These results of 'ostraka process' are incomplete; run it again."),
                    out_.string());
    }
    return std::move(results_);
  }

 private:
  void checkTextOf(const char* file, const std::string& text) const {
    if (const Result<void> good = checkText(text); !good)
      store::refuse(good.error().what, (out_ / file).string());
  }

  // Of the lengths that took no part in the fit the one that is off most stands for the scale.
  void camerasOf(const json& figures) {
    results_.reprojection_px = numberIn(figures, "reprojection_rms_px");
    for (const char* kind : {"held_out", "known_lengths"})
      for (const json& length : figures.value(kind, json::array())) {
        const std::optional<double> error = numberIn(length, "error_pct");
        if (error && std::abs(*error) >= std::abs(results_.scale_error_pct.value_or(0)))
          results_.scale_error_pct = error;
      }
  }

  void pairsOf(const json& pairs) {
    for (const json& p : pairs.at("pairs")) {
      // A person's word counts by its own row, and ends where it is taken back.
      if (p.contains("decided")) continue;
      records::PairDecision d;
      d.batch = batch_;
      const auto& pose = p.at("T_front_from_back");
      d.front_from_back =
          store::valueOrThrow(isometryFromJson(pose, (out_ / "pairs.json").string()));
      d.score = numberIn(p, "score");
      d.margin = numberIn(p, "margin");
      d.fracture_rms_mm = numberIn(p, "fracture_rms_mm");
      d.fracture_overlap = numberIn(p, "fracture_overlap");
      d.ambiguous = p.at("ambiguous").get<bool>();
      d.note = p.value("reason", "");
      checkTextOf("pairs.json", d.note);
      results_.pairs.push_back(std::move(d));
      results_.pair_names.emplace_back(p.at("front").get<std::string>(),
                                       p.at("back").get<std::string>());
    }
  }

  // Those that were paired: where a person joined or cut pieces, they lie in a folder of their own.
  std::vector<fs::path> scanFiles(const std::string& side) {
    const fs::path work = out_ / "work", table = work / "pairs" / "candidates.json";
    std::vector<fs::path> files;
    std::error_code code;
    if (fs::exists(table, code)) {
      noteStageOf(table);
      checkAsNoted(table);
      const json candidates = store::valueOrThrow(readJson(table));
      for (const json& scan : candidates.at(side + "s")) {
        // Another batch's scan would become this one's in the catalogue.
        const Result<ContainedPath> inside =
            ContainedPath::parse(scan.at("file").get<std::string>());
        if (!inside) store::refuse(inside.error().what, table.string());
        files.push_back(work / inside->text());
        photographs_[side] = scan.value("photographs", "");
      }
      return files;
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(work / ("scans_" + side), code))
      if (entry.path().extension() == ".ply") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
  }

  void scansOf(const std::string& side) {
    for (const fs::path& path : scanFiles(side)) {
      noteStageOf(path);
      file(path, "scan", {}, {});
      records::ScanRecord scan;
      scan.batch = batch_;
      scan.side = side == "front" ? batch::Side::Front : batch::Side::Back;
      scan.name = path.stem().string();
      scan.index = std::atoi(scan.name.c_str() + 1);
      scan.path = relativeTo(project_, path);
      const PointCloud cloud = store::valueOrThrow(readPlyCloud(path));
      scan.points = static_cast<int>(cloud.size());
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3f& point : cloud.points) sum += point.cast<double>();
      scan.plate_x_mm = sum.x() / static_cast<double>(cloud.size());
      scan.plate_y_mm = sum.y() / static_cast<double>(cloud.size());
      results_.scans.push_back(std::move(scan));
    }
  }

  void edits() {
    for (decisions::PairDecision& d : store::valueOrThrow(decisions::readDecisions(out_))) {
      if (d.kind != decisions::DecisionKind::Join && d.kind != decisions::DecisionKind::Split)
        continue;
      const std::string& seen = d.scans.front().photographs;
      const std::string& now = photographs_[batch::name(d.scans.front().side)];
      if (seen.empty() || now.empty() || seen == now) results_.edits.push_back(std::move(d));
    }
  }

  void sherdOf(const json& s, bool has_scale) {
    ReadSherd sherd;
    sherd.front = s.at("front").get<std::string>();
    sherd.back = s.at("back").get<std::string>();
    const json& figures = s.at("figures");
    if (figures.value("model", false)) {
      stopIfAsked();
      const std::string number =
          store::valueOrThrow(store::checkedPath(s.at("number").get<std::string>()));
      sherd.folder = keptModel(out_ / "sherds" / number, modelHashes(number)) + "/";
      sherd.model_path = sherd.folder + "model.ply";
      sherd.preview_path = sherd.folder + "preview.png";
      const fs::path folder = project_ / sherd.folder;
      sherd.model_sha256 = file(folder / "model.ply", "model", sherd.front, sherd.back);
      file(folder / "model.glb", "model", sherd.front, sherd.back);
      file(folder / "preview.png", "preview", sherd.front, sherd.back);
      if (has_scale) {  // without a scale no length is known
        for (const auto& [name, value] : figures.at("measures").items()) {
          const sherds::SherdColumn* column = sherds::sherdColumn(name);
          if (!column || !column->measure || !value.is_number() || !(value.get<double>() > 0))
            continue;
          if (value.get<double>() > mostOf(column->measure))
            store::refuse(message("These results contain a measurement larger than any sherd; run "
                                  "'ostraka process' again."),
                          (out_ / "report.json").string());
          sherd.measures[column->measure] = value.get<double>();
        }
        sherd.measures["filled_pct"] = 100 * numberAt(figures, "filled_share");
      }
    }
    results_.sherds.push_back(std::move(sherd));
  }

  // Before anything in them counts.
  void reports() {
    const fs::path record = out_ / stages::kReportsRecord;
    opened(record);
    note(out_, store::valueOrThrow(readJson(record)));
    checkAsNoted(out_ / stages::kInputsRecord);
    for (const char* name : {"report.json", "report.html", "pairs.json"}) {
      if (!noted_.contains(out_ / name)) refuseIncomplete(record);
      file(out_ / name, "report", {}, {});
    }
  }

  // A file that the catalogue does not list.
  void checkAsNoted(const fs::path& path) {
    if (!noted_.contains(path)) return;
    OpenFile open = opened(path);
    checkAsNoted(path, store::valueOrThrow(checksumOf(open, stop_)).sha256);
  }

  void checkAsNoted(const fs::path& path, const std::string& sha256) const {
    const auto noted = noted_.find(path);
    if (noted != noted_.end() && noted->second != sha256)
      store::refuse(message("This file differs from what 'ostraka process' wrote; run it again, "
                            "which writes the file anew."),
                    path.string());
  }

  // What made the files of a folder noted of them.
  void note(const fs::path& folder, const json& made) {
    const json files = made.value("files", json::object());
    for (const auto& [name, hash] : files.items()) noted_[folder / name] = hash.get<std::string>();
  }

  void noteStageOf(const fs::path& file) {
    if (noted_.contains(file)) return;
    const fs::path stage = file.parent_path() / "stage.json";
    opened(stage);
    note(file.parent_path(), store::valueOrThrow(readJson(stage)));
  }

  // As the stages that made the model and its texture noted them: what was cut, emptied or
  // exchanged since is not what was made.
  sherds::ModelHashes modelHashes(const std::string& number) {
    sherds::ModelHashes hashes;
    for (const char* name : {"model_", "texture_"}) {
      if (hashes.contains("model.glb")) break;  // of a version that made both at once
      const fs::path stage = out_ / "work" / (name + number) / "stage.json";
      opened(stage);
      hashes.merge(store::valueOrThrow(readJson(stage)).at("files").get<sherds::ModelHashes>());
    }
    return hashes;
  }

  std::string keptModel(const fs::path& made, const sherds::ModelHashes& hashes) {
    for (const auto& [name, hash] : hashes) {
      const fs::path path = made / name;
      std::error_code none;
      if (fs::symlink_status(path, none).type() != fs::file_type::not_found) opened(path);
    }
    return store::valueOrThrow(sherds::keepModel(project_, batch_number_, made, hashes));
  }

  // Without following links: what they lead to is not the project's. An emptied file is a lost one.
  OpenFile opened(const fs::path& path) {
    const ContainedPath inside =
        store::valueOrThrow(ContainedPath::parse(relativeTo(project_, path)));
    std::error_code none;
    const bool is_there = fs::symlink_status(path, none).type() != fs::file_type::not_found;
    if (is_there) {
      OpenFile file = store::valueOrThrow(opened_->read(inside));
      if (file.bytes() > 0) return file;
    }
    refuseIncomplete(path);
  }

  [[noreturn]] static void refuseIncomplete(const fs::path& path) {
    throw store::Refused(
        Error::unusable(message("These results of 'ostraka process' are incomplete; run it again."),
                        path.string()));
  }

  std::string file(const fs::path& path, const char* role, const std::string& front,
                   const std::string& back) {
    stopIfAsked();
    OpenFile open = opened(path);
    const Checksum sum = store::valueOrThrow(checksumOf(open, stop_));
    checkAsNoted(path, sum.sha256);
    ReadFile read;
    read.record.path = relativeTo(project_, path);
    read.record.sha256 = sum.sha256;
    read.record.bytes = sum.bytes;
    read.record.media_type = mediaTypeOf(path);
    read.record.role = role;
    read.record.batch = batch_;
    read.sherd_front = front;
    read.sherd_back = back;
    results_.files.push_back(std::move(read));
    const auto done = static_cast<std::int64_t>(results_.files.size());
    progress_.report(done, std::max(done, total_));
    return results_.files.back().record.sha256;
  }

  void stopIfAsked() const {
    if (stop_.stop_requested()) throw store::Refused(Error::cancelled());
  }

  const fs::path& project_;
  store::BatchRow batch_;
  std::string batch_number_;
  const fs::path& out_;
  Progress& progress_;
  std::stop_token stop_;
  std::optional<OpenFolder> opened_;  ///< the project
  ReadResults results_;
  std::map<fs::path, std::string> noted_;           ///< SHA-256, by what made the file
  std::map<std::string, std::string> photographs_;  ///< of each side, where they are known
  std::int64_t total_ = 1;
};

}  // namespace

ReadResults readResults(const fs::path& project, const records::BatchRecord& batch,
                        const fs::path& out, Progress& progress, std::stop_token stop) {
  return Reading(project, batch, out, progress, std::move(stop)).all();
}

}  // namespace ostraka::intake
