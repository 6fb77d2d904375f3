#include "exchange/read_back.h"

#include <algorithm>
#include <set>

#include "archive/bag_reader.h"
#include "base/limits.h"
#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue/file_places.h"
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "exchange/other_version.h"
#include "files/checksum.h"
#include "files/folder_lock.h"
#include "intake/side_photographs.h"
#include "metadata/metadata.h"
#include "metadata/sherd_json.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"
#include "upkeep/file_check.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;
using store::valueOrThrow;

constexpr std::size_t kMostRecordBytes = limits::kJsonBytes.most;

std::string mediaTypeOf(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  if (ending == ".png") return "image/png";
  if (ending == ".jpg") return "image/jpeg";
  if (ending == ".svg") return "image/svg+xml";
  if (ending == ".pdf") return "application/pdf";
  if (ending == ".glb") return "model/gltf-binary";
  return "application/octet-stream";
}

class ReadingBack {
 public:
  ReadingBack(upkeep::Project& project, const fs::path& folder, const archive::BagReader& bag,
              const records::Provenance& provenance)
      : project_(project),
        folder_(folder),
        bag_(bag),
        provenance_(provenance),
        name_(store::slug(archive::folderNamed(folder).filename().string())) {}

  /// All records, read before anything is changed.
  Result<void> records() {
    for (const archive::BagFile& file : bag_.files()) {
      if (!file.path.starts_with("data/sherds/")) continue;
      const Result<std::string> text = bag_.read(file, kMostRecordBytes);
      if (!text) return text.error();
      Result<metadata::ReadSherdJson> read =
          metadata::parseSherdJson(*text, fs::path(file.path).filename().string());
      if (!read) return read.error();
      read->row.line = static_cast<int>(records_.size()) + 1;
      const auto& values = read->row.values;
      if (values.contains("uuid") && values.contains("number"))
        uuids_[store::uniqueKey(values.at("number"))] = values.at("uuid");
      records_.push_back(std::move(*read));
    }
    if (records_.empty() && bag_.find("data/catalogue.sqlite"))
      return Error::unusable(
          message("This is an archive of a whole project, not an export; restore it (ostraka "
                  "catalogue restore), then merge the restored project."),
          folder_.string());
    if (records_.empty())
      return Error::unusable(
          message("This export contains no sherd records (JSON); export it again with them."),
          folder_.string());
    return {};
  }

  /// Within a transaction: throws Refused.
  tables::ImportReport enter(const tables::ImportOptions& options, Progress& progress,
                             std::stop_token stop) {
    Catalogue& catalogue = project_.catalogue();
    metadata::ReadBatches beside =
        valueOrThrow(metadata::readMetadata(catalogue, bag_, provenance_));
    copies_ = std::move(beside.copies);
    fresh_batches_ = std::move(beside.fresh);
    lost_joins_.clear();
    noteShared(stop);
    tables::ImportReport kept;
    std::vector<tables::ImportRow> fresh;
    std::vector<const metadata::ReadSherdJson*> fresh_records;
    for (const metadata::ReadSherdJson& record : records_) {
      const std::string uuid =
          record.row.values.contains("uuid") ? record.row.values.at("uuid") : "";
      const store::SherdRow there = valueOrThrow(sherds::Sherds(catalogue).byId(uuid));
      if (!there) {
        fresh_records.push_back(&record);
        fresh.push_back(record.row);
        fresh.back().values.erase("joins");  // when all sherds are there
        if (const auto batch = record.row.values.find("batch"); batch != record.row.values.end())
          if (const auto number = beside.numbers.find(batch->second);
              number != beside.numbers.end())
            fresh.back().batch = valueOrThrow(Batches(catalogue).byNumber(number->second)).row;
        continue;
      }
      const records::SherdRecord sherd = valueOrThrow(sherds::Sherds(catalogue).get(there));
      if (sameAs(sherd, record.row, name_, catalogue)) {
        ++kept.same;
        continue;
      }
      ++kept.refused;
      const std::vector<records::FieldChange> other = otherVersion(sherd, record.row, name_);
      const auto undo = valueOrThrow(sherds::SherdChanges(catalogue).apply(other, provenance_));
      if (!undo.empty()) kept.changes.insert(kept.changes.end(), other.begin(), other.end());
      kept.undo.insert(kept.undo.end(), undo.rbegin(), undo.rend());  // turned at the end
      kept.refusals.push_back({record.row.line, "number", sherd.number, keepsItsOwn(name_)});
    }
    tables::ImportReport report =
        valueOrThrow(tables::importSherds(catalogue, fresh, options, provenance_, progress, stop));
    if (report.not_reached > 0) throw store::Refused(Error::cancelled());
    for (const metadata::ReadSherdJson* record : fresh_records) afterwards(*record);
    copiesAreThere();
    if (!lost_joins_.empty())
      report.warnings.push_back(
          message("Joins with sherds that are not in the export or were not imported are left out: "
                  "%1; enter them by hand.",
                  joined(lost_joins_, ", ")));
    report.warnings.insert(report.warnings.end(), shared_.begin(), shared_.end());
    report.same += kept.same;
    report.changes.insert(report.changes.end(), kept.changes.begin(), kept.changes.end());
    report.undo.insert(report.undo.begin(), kept.undo.rbegin(), kept.undo.rend());
    report.refused += kept.refused;
    report.refusals.insert(report.refusals.end(), kept.refusals.begin(), kept.refusals.end());
    return report;
  }

  /// Of the batches that entered last those that share photographs with others, a sentence each.
  const std::vector<Message>& shared() const { return shared_; }

  /// Files of sherds that are new. One that is there already, of an import that broke off, is not
  /// touched if it is the same, and stops the import if it is another.
  Result<void> copyFiles(Progress& progress, std::stop_token stop) {
    copied_.clear();
    const Result<OpenFolder> project = OpenFolder::open(project_.folder());
    if (!project) return project.error();
    for (const metadata::FileCopy& file : copies_) {
      if (stop.stop_requested()) return Error::cancelled();
      progress.report(static_cast<std::int64_t>(copied_.size()),
                      static_cast<std::int64_t>(copies_.size()));
      const Result<ContainedPath> to = ContainedPath::parse(file.to);
      if (!to) return to.error();
      const archive::BagFile& from = *bag_.find("data/" + file.from);
      if (project->has(*to)) {
        if (Result<void> same = sameAsThere(*project, *to, from, stop); !same) return same;
      } else {
        noteFolders(project_.folder() / file.to);
        if (Result<void> written = bag_.copy(from, *project, *to, stop); !written) return written;
        written_.push_back(file.to);
      }
      copied_.push_back(file);
    }
    return {};
  }

  /// False when other numbers were given to batches than when the files were copied: somebody began
  /// a batch meanwhile.
  bool liesWhereItIsEntered() const {
    return std::equal(copies_.begin(), copies_.end(), copied_.begin(), copied_.end(),
                      [](const metadata::FileCopy& a, const metadata::FileCopy& b) {
                        return a.from == b.from && a.to == b.to;
                      });
  }

  /// What the catalogue names, the disk has lost and the export has with the same bytes. The
  /// photographs of a batch that lies under the cameras are being replaced.
  Result<int> putBackMissing(const std::stop_token& stop) {
    const Result<OpenFolder> project = OpenFolder::open(project_.folder());
    if (!project) return project.error();
    const Result<std::vector<records::BatchRecord>> batches = Batches(project_.catalogue()).all();
    if (!batches) return batches.error();
    std::set<std::string> under_cameras;
    for (const records::BatchRecord& batch : *batches)
      if (batch.state < records::BatchState::Queued) under_cameras.insert(batch.number);
    std::map<std::string, const archive::BagFile*> with_hash;
    for (const archive::BagFile& file : bag_.files()) with_hash.emplace(file.sha256, &file);
    const Result<std::vector<upkeep::KnownFile>> known = upkeep::knownFiles(project_.catalogue());
    if (!known) return known.error();
    int files = 0;
    for (const upkeep::KnownFile& file : *known) {
      const auto from = with_hash.find(file.sha256);
      const bool taken = file.role == "photo" || file.role == "scale";
      if (from == with_hash.end() || (taken && under_cameras.contains(file.batch))) continue;
      const Result<ContainedPath> to = ContainedPath::parse(file.path);
      if (!to) return to.error();
      std::error_code failed;  // what lies behind a link is not lost
      if (project->has(*to) || fs::exists(project_.folder() / file.path, failed) || failed)
        continue;
      if (Result<void> put = bag_.copy(*from->second, *project, *to, stop); !put)
        return put.error();
      ++files;
    }
    return files;
  }

  /// What copyFiles wrote, as far as the catalogue does not name it by now, and the folders that it
  /// made, as far as they are empty.
  void removeCopies() {
    project_.catalogue().database().setWaiting({});  // a stop is no reason to leave them
    // Within a transaction: nobody can come to name a file between the question and its removal.
    const Result<void> removed = project_.catalogue().database().inTransaction([&] {
      std::set<std::string> named;
      for (const records::FileRecord& file : store::valueOrThrow(Files(project_.catalogue()).all()))
        named.insert(file.path);
      std::error_code ignored;
      for (const std::string& file : written_)
        if (!named.contains(file)) fs::remove(project_.folder() / file, ignored);
    });
    if (!removed) return;  // files too many harm less than files that are missing
    std::error_code ignored;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
      fs::remove(*folder, ignored);
    written_.clear();
    made_.clear();
  }

 private:
  void noteShared(const std::stop_token& stop) {
    Catalogue& catalogue = project_.catalogue();
    shared_.clear();
    for (const store::BatchRow row : fresh_batches_) {
      std::vector<batch::SideFile> photographs;
      for (const records::FileRecord& file : valueOrThrow(Files(catalogue).of(row)))
        if (file.role == "photo")
          photographs.push_back({file.path, static_cast<std::uintmax_t>(file.bytes), file.sha256});
      const auto shared = valueOrThrow(intake::sharedPhotographs(
          catalogue, project_.folder(), std::move(photographs),
          [&](const records::BatchRecord& other) {
            return !fresh_batches_.contains(other.row) &&
                   intake::entersItsSherds(catalogue, other, row);
          },
          stop));
      if (!shared) continue;
      const std::string number = valueOrThrow(Batches(catalogue).get(row)).number;
      shared_.push_back(
          message("%1 of the %2 photographs of %3, which this export holds, belong to %4, too: its "
                  "sherds would be in the catalogue twice. Use %4 and leave the export out, or "
                  "keep both on purpose (on the command line: --keep-both).",
                  shared->shared, shared->of, number, shared->batch));
      valueOrThrow(intake::keepBoth(catalogue, number, provenance_));
    }
  }

  // Before anything is written: each file is in the export, and no two get one place.
  void copiesAreThere() const {
    std::map<std::string, std::string> hashes;
    for (const metadata::FileCopy& copy : copies_) {
      const archive::BagFile* file = bag_.find("data/" + copy.from);
      if (!file) store::refuse(message("This file is not part of the export."), copy.from);
      if (hashes.try_emplace(copy.to, file->sha256).first->second != file->sha256)
        store::refuse(message("Two files of the export would have the same name."), copy.to);
    }
  }

  static Result<void> sameAsThere(const OpenFolder& project, const ContainedPath& to,
                                  const archive::BagFile& from, const std::stop_token& stop) {
    Result<OpenFile> there = project.read(to);
    if (!there) return there.error();
    const Result<Checksum> sum = checksumOf(*there, stop);
    if (!sum) return sum.error();
    if (sum->sha256 == from.sha256) return {};
    return Error::unusable(
        message(
            "The project has another file with this name; rename the export and import it again."),
        there->name());
  }

  void noteFolders(const fs::path& file) {
    std::error_code ignored;
    for (fs::path folder = file.parent_path(); !folder.empty() && !fs::exists(folder, ignored);
         folder = folder.parent_path())
      made_.insert(folder);
  }

  // Joins, scans and files of a sherd that was not there before, once all sherds are there.
  void afterwards(const metadata::ReadSherdJson& record) {
    Catalogue& catalogue = project_.catalogue();
    if (!record.row.values.contains("uuid")) return;
    const store::SherdRow sherd =
        valueOrThrow(sherds::Sherds(catalogue).byId(record.row.values.at("uuid")));
    if (!sherd) return;  // refused
    join(sherd, record);
    scansOf(sherd, record);
    if (!valueOrThrow(Files(catalogue).of(sherd)).empty()) return;
    std::string model, preview;
    for (const metadata::SherdFile& file : record.files) {
      records::FileRecord f;
      f.path =
          valueOrThrow(catalogue::importPlace("imported/" + name_ + "/" + file.path, {})).text();
      const archive::BagFile verified =
          valueOrThrow(metadata::verifiedFile(bag_, file.path, file.sha256, file.bytes));
      f.sha256 = verified.sha256;
      f.bytes = verified.bytes;
      f.role = file.role;
      f.media_type = mediaTypeOf(file.path);
      f.sherd = sherd;
      valueOrThrow(Files(catalogue).save(f, provenance_));
      copies_.push_back({file.path, f.path});
      if (file.role == "model" && file.path.ends_with(".ply")) model = f.path;
      if (file.role == "preview") preview = f.path;
    }
    valueOrThrow(sherds::Sherds(catalogue).setModel(sherd, model, preview));
  }

  // With whom the export means: a number may be another sherd's here, or nobody knows whose.
  void join(store::SherdRow sherd, const metadata::ReadSherdJson& record) {
    Catalogue& catalogue = project_.catalogue();
    const auto joins = record.row.values.find("joins");
    if (joins == record.row.values.end()) return;
    std::vector<std::string> there;
    for (const std::string& named : store::splitTerms(joins->second)) {
      const auto known = uuids_.find(store::uniqueKey(named));
      const std::string uuid = known == uuids_.end() ? named : known->second;
      if (valueOrThrow(sherds::Sherds(catalogue).byId(uuid))) {
        there.push_back(uuid);
      } else {
        const auto number = record.row.values.find("number");
        const bool draft = number == record.row.values.end();
        lost_joins_.push_back((draft ? record.row.values.at("uuid") : number->second) + " – " +
                              named);
      }
    }
    if (there.empty()) return;
    const records::FieldChange change{sherd, "joins", store::joinTerms(there)};
    valueOrThrow(sherds::SherdChanges(catalogue).apply(std::span(&change, 1), provenance_));
  }

  // From which scans of its batch it was made, unless that is known already. A batch that was here
  // before has its own scans and decisions: one of the same name may be of another piece.
  void scansOf(store::SherdRow row, const metadata::ReadSherdJson& record) {
    Catalogue& catalogue = project_.catalogue();
    const records::SherdRecord sherd = valueOrThrow(sherds::Sherds(catalogue).get(row));
    if (record.front.empty() || sherd.front || !fresh_batches_.contains(sherd.batch)) return;
    store::ScanRow front, back;
    for (const records::ScanRecord& scan : valueOrThrow(Batches(catalogue).scans(sherd.batch))) {
      if (scan.side == batch::Side::Front && scan.name == record.front) front = scan.row;
      if (scan.side == batch::Side::Back && scan.name == record.back) back = scan.row;
    }
    if (front) valueOrThrow(metadata::restoreScans(catalogue, row, front, back));
  }

  upkeep::Project& project_;
  const fs::path& folder_;
  const archive::BagReader& bag_;
  const records::Provenance& provenance_;
  std::string name_;  ///< of the export's folder, as part of other names
  std::vector<metadata::ReadSherdJson> records_;
  std::map<std::string, std::string> uuids_;  ///< of the records, by number
  std::set<store::BatchRow> fresh_batches_;   ///< what entered last
  std::vector<std::string> lost_joins_;
  std::vector<Message> shared_;
  std::vector<metadata::FileCopy> copies_;  ///< of what was entered last
  std::vector<metadata::FileCopy> copied_;
  std::vector<std::string> written_;
  std::set<fs::path> made_;  ///< those within others behind them
};

}  // namespace

Result<tables::ImportReport> readBack(upkeep::Project& project, const fs::path& folder,
                                      tables::ImportMode mode,
                                      const records::Provenance& provenance, Progress& progress,
                                      std::stop_token stop, SamePhotographs same) {
  const Result<archive::BagReader> bag = archive::BagReader::open(folder, progress, stop);
  if (!bag) return bag.error();
  ReadingBack reading(project, folder, *bag, provenance);
  if (Result<void> read = reading.records(); !read) return read.error();
  tables::ImportReport report;
  bool moved = false;
  const auto records = [&](tables::ImportMode how) {
    // The records of one export belong together: within the transaction around them.
    return tables::previewOrEnter(project.catalogue(), how, [&]() -> Result<void> {
      report =
          reading.enter({tables::ImportMode::Enter, tables::UnknownPlaces::Refuse}, progress, stop);
      moved = how == tables::ImportMode::Enter && !reading.liesWhereItIsEntered();
      return moved ? Result<void>(Error::cancelled()) : Result<void>();
    });
  };
  const std::int64_t before = History(project.catalogue()).length();
  if (const Result<void> fits = records(tables::ImportMode::Preview); !fits) return fits.error();
  if (mode == tables::ImportMode::Preview) return report;
  if (same == SamePhotographs::Refuse && !reading.shared().empty())
    return Error::unusable(reading.shared().front(), folder.string());
  if (const auto saved = project.backUp(); !saved) return saved.error();
  // From where files are copied until the rows that name them are there they are nobody's: two
  // imports would take each other's copies for what was there before, or for their own. Of the
  // whole project, since two exports may hold the same batch, or want the same number; and where no
  // export and no batch gets its files.
  const Result<FolderLock> alone = FolderLock::waitFor(
      project.folder(),
      message("Another import into this project is running; this one waits until it has finished."),
      progress, stop);
  if (!alone) return alone.error();
  // Another import has entered since: what is new, and where its files go, is another answer now.
  if (History(project.catalogue()).length() != before)
    if (const Result<void> fits = records(tables::ImportMode::Preview); !fits) return fits.error();
  const Result<int> put_back = reading.putBackMissing(stop);
  if (!put_back) return put_back.error();
  const auto copyAndEnter = [&]() -> Result<void> {
    do {
      // Nobody who wants to write waits for files to be copied.
      if (Result<void> copied = reading.copyFiles(progress, stop); !copied) return copied;
      moved = false;
      if (Result<void> entered = records(mode); !entered && !moved) return entered;
      if (moved) reading.removeCopies();
    } while (moved);
    return {};
  };
  if (const Result<void> done = copyAndEnter(); !done) {
    // Else they lie where the next batch that is photographed gets its folder.
    reading.removeCopies();
    return done.error();
  }
  if (*put_back > 0)
    report.warnings.push_back(
        message("Files that were missing from the project and are restored: %1.", *put_back));
  return report;
}

}  // namespace ostraka::exchange
