// What `ostraka process` left, into the catalogue.
#include "intake/enter_results.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "base/message.h"
#include "batch/batch.h"
#include "batch/exif.h"
#include "capture/manifest.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "decisions/scan_folder.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "intake/read_results.h"
#include "intake/results_owner.h"
#include "intake/review_decisions.h"
#include "intake/same_pieces.h"
#include "intake/settle_batch.h"
#include "intake/side_photographs.h"
#include "records/records.h"
#include "records/sherd.h"
#include "review/review.h"
#include "sherds/kept_models.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"
#include "upkeep/project.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using store::valueOrThrow;

bool samePose(const std::optional<Eigen::Isometry3d>& a,
              const std::optional<Eigen::Isometry3d>& b) {
  if (!a || !b) return !a && !b;
  return a->matrix().isApprox(b->matrix(), 1e-12);
}

bool sameWord(const records::PairDecision& a, const records::PairDecision& b) {
  return a.front == b.front && a.back == b.back && a.score == b.score && a.margin == b.margin &&
         a.ambiguous == b.ambiguous && a.fracture_rms_mm == b.fracture_rms_mm &&
         a.fracture_overlap == b.fracture_overlap && a.note == b.note &&
         samePose(a.front_from_back, b.front_from_back);
}

// What the results say of the batch as a whole, and whether it wants a person.
enum class BatchItself { Settled, LeftAsItIs };

class Entering {
 public:
  Entering(catalogue::Catalogue& catalogue, store::BatchRow batch,
           const records::Provenance& provenance)
      : catalogue_(catalogue), batch_(batch), provenance_{{}, "process", provenance.why} {}

  EnteredResults enter(const ReadResults& read, const fs::path& out,
                       std::optional<Message> other_photographs, BatchItself then) {
    entered_.other_photographs = std::move(other_photographs);
    const int before = sherdRows();
    scans(read.scans, read.edits);
    const std::string number = valueOrThrow(catalogue::Batches(catalogue_).get(batch_)).number;
    valueOrThrow(followDecisions(catalogue_, number, out));
    // A file that cannot be read hinders no results; a check names it.
    if (const Result<void> known = followStrokes(catalogue_, number, out);
        !known && known.error().code == ErrorCode::CannotWrite)
      throw store::Refused(known.error());
    decide(read);
    // Before the models: what lies under a number that waited is another record's from here on.
    entered_.numbers_left = valueOrThrow(sherds::giveTypedNumbers(catalogue_, batch_, provenance_));
    taken_back_ = valueOrThrow(piecesTakenBack(catalogue_, batch_, out));
    valueOrThrow(forgetModelsOf(catalogue_, batch_, taken_back_, provenance_));
    for (const ReadSherd& sherd : read.sherds) model(sherd);
    for (const ReadFile& file : read.files) {
      records::FileRecord record = file.record;
      if (!file.sherd_front.empty()) record.sherd = sherdOf(file.sherd_front, file.sherd_back);
      valueOrThrow(catalogue::Files(catalogue_).save(record, provenance_));
      ++entered_.files;
    }
    entered_.new_sherds = sherdRows() - before;
    countOpen();
    entered_.decided_meanwhile = review::wantsComputing(out);
    if (then == BatchItself::Settled) settle(read);
    return entered_;
  }

 private:
  // Void ones, too: a pair that is computed anew is taken back first, and finds its sherd again.
  int sherdRows() const {
    return catalogue_.database()
        .sql("SELECT count(*) FROM sherd WHERE batch = ?", batch_)
        .one<int>();
  }

  void settle(const ReadResults& read) {
    records::BatchRecord batch = valueOrThrow(catalogue::Batches(catalogue_).get(batch_));
    const bool open = entered_.open > 0 || entered_.decided_meanwhile || entered_.other_photographs;
    batch.state = open || !read.scale_doubts.empty() ? records::BatchState::Review
                                                     : records::BatchState::Done;
    batch.reprojection_px = read.reprojection_px;
    batch.scale_error_pct = read.scale_error_pct;
    batch.scale = read.scale;
    batch.scale_doubts = read.scale_doubts;
    valueOrThrow(catalogue::Batches(catalogue_).save(batch, provenance_));
  }

  // Pieces are numbered anew by each computation, in the order of their places; what a person said
  // about one must stay with it, so it is known by its place.
  void scans(std::vector<records::ScanRecord> found, const decisions::Decisions& edits) {
    const std::vector<records::ScanRecord> known =
        valueOrThrow(catalogue::Batches(catalogue_).scans(batch_));
    const std::vector<int> same =
        samePieces(known, found, edits, sherds::typedOn(catalogue_, batch_));
    for (std::size_t i = 0; i < known.size(); ++i) {
      const bool gone = same[i] < 0;
      if (gone && !known[i].isThere()) continue;
      records::ScanRecord scan = known[i];
      scan.index = -static_cast<int>(scan.row.value);  // out of the way of the others
      if (gone) {
        scan.name += "-earlier" + std::to_string(scan.row.value);
        valueOrThrow(catalogue::Batches(catalogue_).save(scan, provenance_));
        continue;
      }
      records::ScanRecord& now = found[static_cast<std::size_t>(same[i])];
      now.row = scan.row;
      if (now.index != known[i].index)
        catalogue_.database().run("UPDATE scan SET position = ? WHERE row = ?", scan.index,
                                  scan.row);
    }
    for (const records::ScanRecord& scan : found) {
      rows_[scan.name] = valueOrThrow(catalogue::Batches(catalogue_).save(scan, provenance_));
      ++entered_.scans;
    }
  }

  store::ScanRow scan(const std::string& name) const {
    const auto found = rows_.find(name);
    if (found == rows_.end())
      store::refuse(message(
          "The pair table names the scan %1, which is missing; run 'ostraka process' again.",
          name));
    return found->second;
  }

  void decide(const ReadResults& read) {
    std::vector<records::PairDecision> standing;  // the program's words that were not taken back
    std::map<store::DecisionRow, bool> withdrawn;
    const std::vector<records::PairDecision> all =
        valueOrThrow(sherds::PairDecisions(catalogue_).all(batch_));
    for (const records::PairDecision& d : all)
      if (!d.by && d.verdict == records::Verdict::Withdraw) withdrawn[d.replaces] = true;
    for (const records::PairDecision& d : all)
      if (!d.by && d.verdict == records::Verdict::Accept && !withdrawn.contains(d.row))
        standing.push_back(d);
    std::vector<records::PairDecision> said = read.pairs;
    for (std::size_t i = 0; i < said.size(); ++i) {
      said[i].front = scan(read.pair_names[i].first);
      said[i].back = scan(read.pair_names[i].second);
    }
    const auto isIn = [](const std::vector<records::PairDecision>& list,
                         const records::PairDecision& d) {
      return std::any_of(list.begin(), list.end(),
                         [&](const records::PairDecision& other) { return sameWord(other, d); });
    };
    for (const records::PairDecision& old : standing)
      if (!isIn(said, old)) {
        records::PairDecision back;
        back.batch = batch_;
        back.verdict = records::Verdict::Withdraw;
        back.replaces = old.row;
        valueOrThrow(sherds::PairDecisions(catalogue_).add(back, provenance_));
      }
    for (const records::PairDecision& d : said)
      if (!isIn(standing, d)) {
        valueOrThrow(sherds::PairDecisions(catalogue_).add(d, provenance_));
        ++entered_.decisions;
      }
    current_ = valueOrThrow(sherds::PairDecisions(catalogue_).current(batch_));
    for (const records::PairDecision& d : current_) entered_.kept_decisions += d.by ? 1 : 0;
  }

  // The sherd of this pair, if the pair is what counts now, of pieces that still hold.
  store::SherdRow sherdOf(const std::string& front, const std::string& back) {
    const store::ScanRow f = scan(front), b = scan(back);
    if (taken_back_.contains(f) || taken_back_.contains(b)) return {};
    return catalogue_.database()
        .sql("SELECT row FROM sherd WHERE front = ? AND back = ?", f, b)
        .one<store::SherdRow>();
  }

  void model(const ReadSherd& read) {
    const store::SherdRow sherd = sherdOf(read.front, read.back);
    if (!sherd || read.model_path.empty()) return;
    valueOrThrow(sherds::Sherds(catalogue_).setModel(sherd, read.model_path, read.preview_path));
    catalogue_.database().run(
        "UPDATE file SET sherd = NULL WHERE sherd = ? AND role IN ('model', 'preview') AND "
        "substr(path, 1, length(?)) <> ?",
        sherd, read.folder, read.folder);
    ++entered_.models;
    for (const auto& [kind, value] : read.measures) {
      sherds::setMeasure(catalogue_,
                         {sherd, kind, {}, value, std::nullopt, "program", {}, read.model_sha256},
                         provenance_, sherds::MeasureRank::PersonFirst);
      ++entered_.measurements;
    }
  }

  // Doubtful pairs, and scans that nobody has paired or set aside; not those that were joined to
  // others and are no pieces any more.
  void countOpen() {
    for (const records::ScanRecord& scan :
         valueOrThrow(catalogue::Batches(catalogue_).scans(batch_)))
      entered_.open += scan.state == records::ScanState::Open && rows_.contains(scan.name) ? 1 : 0;
    for (const records::PairDecision& d :
         current_)  // a doubtful pair is two open scans, and one question
      if (d.verdict == records::Verdict::Accept && !d.by && d.ambiguous) --entered_.open;
  }

  catalogue::Catalogue& catalogue_;
  store::BatchRow batch_;
  records::Provenance provenance_;
  std::map<std::string, store::ScanRow> rows_;
  std::set<store::ScanRow> taken_back_;  // pieces that nobody wants joined or cut so any more
  std::vector<records::PairDecision> current_;
  EnteredResults entered_;
};

Result<EnteredResults> entered(catalogue::Catalogue& catalogue, const fs::path& project,
                               store::BatchRow batch, const fs::path& out,
                               const records::Provenance& provenance, BatchItself then,
                               Progress& progress, std::stop_token stop) {
  // Models that one entering has kept and not entered yet are in use by nobody for another one:
  // holdModels keeps out other programs, and this other threads where the disk knows no locks.
  static std::mutex one_by_one;
  const std::scoped_lock alone(one_by_one);
  return catalogue.database().asResult([&] {
    const auto record = valueOrThrow(catalogue::Batches(catalogue).get(batch));
    const std::optional<Message> other_photographs =
        valueOrThrow(checkResultsAreOf(catalogue, project, record, out, stop));
    valueOrThrow(checkNotShared(catalogue, project, record, stop));
    const FolderLock models =
        valueOrThrow(sherds::holdModels(project, record.number, progress, stop));
    const ReadResults read = readResults(project, record, out, progress, stop);
    // Not before: nothing goes where there is nothing to come in its place.
    std::set<std::string> kept;
    for (const ReadSherd& sherd : read.sherds)
      if (!sherd.folder.empty()) kept.insert(sherd.folder.substr(0, sherd.folder.size() - 1));
    valueOrThrow(sherds::dropUnusedModels(catalogue, project, record.number, kept));
    return valueOrThrow(catalogue.database().inTransaction([&] {
      return Entering(catalogue, batch, provenance).enter(read, out, other_photographs, then);
    }));
  });
}

}  // namespace

Result<bool> enterLostModels(const fs::path& project, const std::string& batch, Progress& progress,
                             std::stop_token stop) {
  const fs::path out = project / "results" / batch;
  std::error_code failed;
  if (!fs::exists(out / "report.json", failed)) return false;
  Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(project);
  if (!catalogue) return catalogue.error();
  return catalogue->database().asResult([&] {
    const auto record = valueOrThrow(catalogue::Batches(*catalogue).byNumber(batch)).row;
    const sherds::Sherds sherds(*catalogue);
    const auto all = valueOrThrow(sherds.of(valueOrThrow(sherds.rows(record))));
    if (std::none_of(all.begin(), all.end(), [](const records::SherdRecord& sherd) {
          return sherd.front && sherd.back && sherd.model_path.empty();
        }))
      return false;
    // The batch may wait to be computed again, or lie under the cameras: that is not theirs to say.
    return valueOrThrow(entered(*catalogue, project, record, out, {{}, "process", {}},
                                BatchItself::LeftAsItIs, progress, std::move(stop)))
               .models > 0;
  });
}

namespace {

// Without following links: what they lead to is not the project's.
std::pair<records::FileRecord, std::string> fileOf(const fs::path& project, const fs::path& at,
                                                   store::BatchRow batch, const char* role) {
  records::FileRecord file;
  file.path = relativeTo(project, at);
  OpenFile open = valueOrThrow(OpenFile::within(project, file.path));
  std::string bytes = valueOrThrow(open.readAll());
  file.sha256 = sha256(bytes);
  file.bytes = static_cast<std::int64_t>(bytes.size());
  file.media_type = mediaTypeOf(at);
  file.role = role;
  file.batch = batch;
  return {std::move(file), std::move(bytes)};
}

// What says how long something in the photographs is.
std::vector<records::FileRecord> scaleFilesOf(const fs::path& project, const fs::path& folder,
                                              store::BatchRow batch) {
  std::vector<records::FileRecord> files;
  std::error_code failed;
  for (const char* name : {"plate.json", "board.json", "scale.json"})
    if (fs::is_regular_file(fs::symlink_status(folder / name, failed)))
      files.push_back(fileOf(project, folder / name, batch, "scale").first);
  return files;
}

struct RecordedPhotographs {
  int recorded = 0;
  std::vector<std::string> more;  // names that do not count
};

// made_from: those that count; empty: all.
Result<RecordedPhotographs> recordPhotographs(catalogue::Catalogue& catalogue,
                                              const fs::path& project, store::BatchRow batch,
                                              const batch::PhotographHashes& made_from,
                                              const records::Provenance& provenance,
                                              Progress& progress, const std::stop_token& stop) {
  std::set<std::string> count;
  for (const auto& [name, hash] : made_from) count.insert(hash);
  RecordedPhotographs done;
  const Result<records::BatchRecord> record = catalogue::Batches(catalogue).get(batch);
  if (!record) return record.error();
  const Result<batch::Batch> folder =
      batch::readBatch(project / "batches" / record->number, {}, progress);
  if (!folder) return folder.error();
  // What the capture noted; a batch from elsewhere has none.
  const Result<capture::Manifest> noted =
      capture::readManifest(project / "batches" / record->number);
  if (!noted) progress.note(NoteLevel::Warning, noted.error().sentence());
  struct Photograph {
    records::PhotographRecord shot;
    records::FileRecord file;
  };
  const Result<std::vector<Photograph>> read = catalogue.database().asResult([&] {
    std::vector<Photograph> all;
    for (const batch::Shot& shot : folder->shots) {
      if (stop.stop_requested()) throw store::Refused(Error::cancelled());
      Photograph p;
      std::string bytes;
      std::tie(p.file, bytes) = fileOf(project, shot.file, batch, "photo");
      if (!count.empty() && !count.contains(p.file.sha256)) {
        const std::string name = shot.file.lexically_relative(folder->folder).generic_string();
        if (!made_from.contains(name)) done.more.push_back(name);  // else it was exchanged
        continue;
      }
      p.shot.path = p.file.path;
      p.shot.batch = batch;
      p.shot.side = shot.side;
      // Of free cameras it is one camera's, photograph after photograph.
      const bool rig = folder->way == batch::Way::Rig;
      p.shot.camera = static_cast<char>(rig ? 'A' + shot.camera : 'A');
      p.shot.stop = rig ? shot.stop : shot.camera;
      const batch::Exif exif = batch::exifIn(bytes);
      p.shot.exif_json = exif.json();
      p.shot.serial = exif.serial;
      const capture::ManifestEntry* entry =
          noted ? noted->find(shot.side, shot.stop, shot.camera) : nullptr;
      if (entry) {
        if (!entry->camera_serial.empty()) p.shot.serial = entry->camera_serial;
        p.shot.angle_deg = entry->angle_seen_deg.value_or(entry->angle_deg);
        if (entry->checked) p.shot.sharpness = entry->sharpness;
      }
      all.push_back(std::move(p));
      progress.report(static_cast<std::int64_t>(all.size()),
                      static_cast<std::int64_t>(folder->shots.size()));
    }
    return all;
  });
  if (!read) return read.error();
  const auto scale = catalogue.database().asResult(
      [&] { return scaleFilesOf(project, project / "batches" / record->number, batch); });
  if (!scale) return scale.error();
  return catalogue.database().inTransaction([&] {
    for (const records::FileRecord& file : *scale)
      valueOrThrow(catalogue::Files(catalogue).save(file, provenance));
    for (const Photograph& p : *read) {
      valueOrThrow(catalogue::Batches(catalogue).save(p.shot, provenance));
      valueOrThrow(catalogue::Files(catalogue).save(p.file, provenance));
    }
    done.recorded = static_cast<int>(read->size());
    return done;
  });
}

}  // namespace

Result<int> enterPhotographs(catalogue::Catalogue& catalogue, const fs::path& project,
                             store::BatchRow batch, const records::Provenance& provenance,
                             Progress& progress, std::stop_token stop) {
  const Result<RecordedPhotographs> done =
      recordPhotographs(catalogue, project, batch, {}, provenance, progress, stop);
  return done ? Result<int>(done->recorded) : done.error();
}

Result<EnteredResults> enterResults(catalogue::Catalogue& catalogue, const fs::path& project,
                                    store::BatchRow batch, const fs::path& out,
                                    const records::Provenance& provenance, Progress& progress,
                                    std::stop_token stop) {
  Result<EnteredResults> done =
      entered(catalogue, project, batch, out, provenance, BatchItself::Settled, progress, stop);
  if (!done) return done;
  const Result<records::BatchRecord> record = catalogue::Batches(catalogue).get(batch);
  if (!record) return record.error();
  if (decisions::holdsScans(project / "batches" / record->number)) return done;
  const auto made_from = catalogue.database().asResult([&] { return photographsOf(out); });
  if (!made_from) return made_from.error();
  // Results may be here without their photographs, or with ones that cannot be read any more.
  const Result<RecordedPhotographs> recorded =
      recordPhotographs(catalogue, project, batch, *made_from, provenance, progress, stop);
  if (!recorded && (recorded.error().code == ErrorCode::CannotWrite ||
                    recorded.error().code == ErrorCode::Cancelled))
    return recorded.error();
  if (recorded && !recorded->more.empty())
    done->more_photographs = message(
        "Photographs of %1 that these results were not made from: %2, the first is %3. "
        "Reprocess the batch to use them.",
        record->number, recorded->more.size(), recorded->more.front());
  return done;
}

}  // namespace ostraka::intake
