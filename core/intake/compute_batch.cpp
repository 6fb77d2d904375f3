#include "intake/compute_batch.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "base/message.h"
#include "base/text.h"
#include "capture/manifest.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/settings.h"
#include "decisions/scan_folder.h"
#include "files/json.h"
#include "intake/computed_again.h"
#include "intake/enter_results.h"
#include "intake/side_photographs.h"
#include "pipeline/process_batch.h"
#include "records/records.h"
#include "review/more_candidates.h"
#include "review/review.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "upkeep/project.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using records::BatchState;
using store::valueOrThrow;

// Before a batch of this project was computed: 54 photographs of 8 MB and as much again for masks,
// depth and models.
constexpr double kUsualBatch_bytes = 1.0e9;
// A first small batch does not make many of few.
constexpr std::size_t kEnoughBatches = 3, kNewestBatches = 10;
constexpr double kLeastBatch_bytes = 10.0e6;
// Of large photographs as much again, of small ones up to five times as much.
constexpr double kResultsPerPhotographs = 2;
// Below this the next stage would fail half-way on any camera; the queue waits for space instead.
constexpr double kLeastFree_bytes = 300.0e6;
constexpr std::size_t kNamedMissing = 6;
constexpr int kWantedCandidates = 3;  // that the review shows for a doubtful front

double sizeOf(const fs::path& folder) {
  double bytes = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error))
    if (at->is_regular_file(error)) bytes += static_cast<double>(at->file_size(error));
  return bytes;
}

// Photographs, or scans that were split already.
Result<BatchFigures> computed(const ComputeOptions& options, const fs::path& batch,
                              const fs::path& output, bool albedo, std::vector<Message> warnings,
                              Progress& progress, const std::stop_token& stop) {
  pipeline::ProcessOptions process;
  process.batch = batch;
  process.warnings = std::move(warnings);
  process.output = output;
  process.threads = options.threads;
  process.estimated = options.estimated;
  process.dense = options.dense == "colmap"    ? pipeline::DenseMethod::Colmap
                  : options.dense == "openmvs" ? pipeline::DenseMethod::OpenMvs
                                               : pipeline::DenseMethod::Builtin;
  if (albedo) process.texture = pipeline::TextureColours::Albedo;
  if (options.draft) process.megapixels = pipeline::kDraftMegapixels;
  if (fs::exists(batch / "rig.json")) process.rig = batch / "rig.json";
  const Result<pipeline::ProcessSummary> done =
      decisions::holdsScans(batch) ? pipeline::processScans(process, progress, stop)
                                   : pipeline::processBatch(process, progress, stop);
  if (!done) return done.error();
  BatchFigures figures;
  if (process.rig)
    if (const auto moved = checks::movedCameras(output)) figures.moved = *moved;
  figures.draft = done->draft;
  figures.sherds = static_cast<int>(done->sherds.size());
  figures.ask = done->ambiguous();
  for (const pipeline::SherdSummary& sherd : done->sherds)
    figures.decided += sherd.decided_by.empty() ? 0 : 1;
  figures.sure = figures.sherds - figures.ask - figures.decided;
  // As the review counts: pieces that found no partner want a person too.
  if (const auto review = review::loadReview(output)) figures.take(review::countsOf(*review));
  figures.seconds = done->seconds;
  for (const pipeline::SherdSummary& sherd : done->sherds)
    figures.uncertainty_mm = std::max(figures.uncertainty_mm, sherd.uncertainty_mm);
  return figures;
}

// Of the photographs that the catalogue, or the capture, has of the batch: what went away while it
// waited would be missed by nobody.
Result<std::vector<std::string>> missingPhotographs(const upkeep::Project& project,
                                                    const records::BatchRecord& batch) {
  const Result<std::vector<records::FileRecord>> files =
      catalogue::Files(project.catalogue()).of(batch.row);
  if (!files) return files.error();
  const fs::path folder = project.batchFolder(batch.number);
  std::set<std::string> recorded;
  for (const records::FileRecord& file : *files)
    if (file.role == "photo")
      recorded.insert((project.folder() / file.path).lexically_relative(folder).generic_string());
  if (const Result<capture::Manifest> manifest = capture::readManifest(folder))
    for (const capture::ManifestEntry& entry : manifest->entries)
      if (entry.used) recorded.insert(entry.file);
  std::vector<std::string> missing;
  for (const std::string& name : recorded) {
    std::error_code failed;
    if (fs::status(folder / name, failed).type() == fs::file_type::not_found)
      missing.push_back(name);
  }
  return missing;
}

Message missingSentence(const std::vector<std::string>& missing, const fs::path& folder) {
  const std::string names =
      joined(std::span(missing).first(std::min(missing.size(), kNamedMissing)), ", ");
  return about(
      folder,
      missing.size() > kNamedMissing
          ? message("Photographs recorded for this batch are missing from its folder (%1): %2 and "
                    "%3 more. Put them back and reprocess the batch.",
                    missing.size(), names, missing.size() - kNamedMissing)
          : message("Photographs recorded for this batch are missing from its folder (%1): %2. Put "
                    "them back and reprocess the batch.",
                    missing.size(), names));
}

Result<void> hasSpace(const fs::path& project) {
  std::error_code error;
  const fs::space_info space = fs::space(project, error);
  if (error || static_cast<double>(space.available) > kLeastFree_bytes) return {};
  return Error{ErrorCode::CannotWrite,
               message("The disk has only %1 MB left, and a batch needs more. Nothing is lost: "
                       "free some space, then resume.",
                       space.available / 1000000),
               project.string()};
}

// As many as lay on the plate, though some found no partner.
int piecesOf(const catalogue::Catalogue& rows, store::BatchRow batch) {
  const auto scans = catalogue::Batches(rows).scans(batch);
  int found[2] = {0, 0};
  if (scans)
    for (const records::ScanRecord& scan : *scans)
      if (scan.isThere()) ++found[scan.side == batch::Side::Front ? 0 : 1];
  return std::max(found[0], found[1]);
}

Message leftSentence(const catalogue::Catalogue& rows, const std::string& number) {
  const auto holder = sherds::Sherds(rows).byNumber(number);
  return holder && *holder
             ? message(
                   "%1: this number was entered on the plate, but it belongs to another sherd; "
                   "check which of the two bears it, and give the other one a new number.",
                   number)
             : message(
                   "%1: this number was entered on the plate, but there is no sherd with a context "
                   "in that place; assign it in the catalogue.",
                   number);
}

// Of results that were computed elsewhere; scans, and batches without a table, have no review.
Result<BatchFigures> figuresIn(const fs::path& output, const fs::path& batch) {
  const Result<nlohmann::json> report = readJson(output / "report.json");
  if (!report) return report.error();
  BatchFigures figures;
  try {
    figures.draft = report->value("draft", false);
    for (const nlohmann::json& stage : report->at("stages"))
      figures.seconds += stage.value("seconds", 0.0);
    for (const nlohmann::json& sherd : report->at("sherds")) {
      ++figures.sherds;
      figures.ask += sherd.value("ambiguous", false) ? 1 : 0;
      figures.decided += sherd.value("decided_by", std::string()).empty() ? 0 : 1;
      figures.uncertainty_mm = std::max(figures.uncertainty_mm, sherd.value("uncertainty_mm", 0.0));
    }
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(
        message("These results of 'ostraka process' are incomplete; run it again."),
        (output / "report.json").string());
  }
  figures.sure = figures.sherds - figures.ask - figures.decided;
  if (fs::exists(batch / "rig.json"))
    if (const auto moved = checks::movedCameras(output)) figures.moved = *moved;
  if (const auto review = review::loadReview(output)) figures.take(review::countsOf(*review));
  return figures;
}

// From results to rows, after the chain has ended here or elsewhere. Throws Refused.
BatchFigures enteredFigures(upkeep::Project& project, const records::BatchRecord& begun,
                            BatchFigures figures, Progress& progress, const std::stop_token& stop) {
  catalogue::Catalogue& rows = project.catalogue();
  const fs::path output = project.resultsFolder(begun.number);
  // Who opens the review finds the candidates registered. Without them it compares them then.
  if (figures.ask > 0) {
    progress.begin("candidates", 0.02);
    const Result<void> prepared =
        review::prepareCandidates(output, kWantedCandidates, progress, stop);
    if (!prepared && prepared.error().code == ErrorCode::Cancelled)
      throw store::Refused(prepared.error());
    if (!prepared) progress.note(NoteLevel::Warning, prepared.error().sentence());
  }
  // Since it began a side may be photographed again.
  const BatchState now = valueOrThrow(catalogue::Batches(rows).get(begun.row)).state;
  if (now <= BatchState::Back && now != begun.state) throw store::Refused(Error::cancelled());
  const records::Provenance provenance{{}, "process", {}};
  progress.begin("catalogue", 0.01);
  valueOrThrow(catalogue::Batches(rows).setState(begun.row, BatchState::Computed, provenance));
  const EnteredResults entered = valueOrThrow(
      enterResults(rows, project.folder(), begun.row, output, provenance, progress, stop));
  const Result<bool> again = queueIfAsked(rows, begun.number, provenance);
  if (!again) progress.note(NoteLevel::Warning, again.error().sentence());
  for (const auto& photographs : {entered.other_photographs, entered.more_photographs})
    if (photographs) progress.note(NoteLevel::Warning, *photographs);
  for (const std::string& number : entered.numbers_left)
    progress.note(NoteLevel::Warning, leftSentence(rows, number));
  figures.numbers_left = entered.numbers_left;
  if (entered.decided_meanwhile && !(again && *again))
    progress.note(NoteLevel::Warning, message("Pairs were decided or masks edited while the batch "
                                              "was being processed; reprocess it to apply them."));
  if (auto unlike = sherds::unlikeBefore(rows, begun.row)) figures.unlike = *unlike;
  // A sherd that was on the plate and is in no scan would be missed by nobody.
  figures.sherds = piecesOf(rows, begun.row);
  if (figures.sherds != begun.counted) figures.counted = begun.counted;
  if (figures.counted > 0)
    progress.note(NoteLevel::Warning,
                  message("Sherds counted on the plate: %1, but another number was found; check "
                          "the map for a sherd that is missing or was split in two.",
                          figures.counted));
  if (const auto backup = project.backUp(); !backup)
    progress.note(NoteLevel::Warning, backup.error().sentence());
  return figures;
}

}  // namespace

Result<BatchFigures> computeBatch(const ComputeOptions& options, Progress& progress,
                                  std::stop_token stop) {
  if (const Result<void> space = hasSpace(options.project); !space) return space.error();
  Result<upkeep::Project> project = upkeep::Project::open(options.project, {}, {stop, &progress});
  if (!project) return project.error();
  catalogue::Catalogue& rows = project->catalogue();
  return rows.database().asResult([&] {
    const auto record = valueOrThrow(catalogue::Batches(rows).byNumber(options.number));
    const fs::path batch = project->batchFolder(options.number);
    const fs::path output = project->resultsFolder(options.number);
    valueOrThrow(checkNotShared(rows, options.project, record, stop));
    const auto missing = valueOrThrow(missingPhotographs(*project, record));
    std::vector<Message> warnings;
    if (!missing.empty()) warnings.push_back(missingSentence(missing, batch));
    valueOrThrow(beginComputing(rows, options.number));
    const bool albedo = valueOrThrow(catalogue::Settings(rows).texturesWithoutLight());
    BatchFigures figures =
        valueOrThrow(computed(options, batch, output, albedo, std::move(warnings), progress, stop));
    return enteredFigures(*project, record, std::move(figures), progress, stop);
  });
}

Result<BatchFigures> enterComputed(upkeep::Project& project, const records::BatchRecord& begun,
                                   Progress& progress, std::stop_token stop) {
  return project.catalogue().database().asResult([&] {
    const fs::path output = project.resultsFolder(begun.number);
    valueOrThrow(review::computedToItsEnd(output));
    BatchFigures figures = valueOrThrow(figuresIn(output, project.batchFolder(begun.number)));
    figures = enteredFigures(project, begun, std::move(figures), progress, stop);
    valueOrThrow(keepFigures(project.catalogue(), begun.number, figures));
    return figures;
  });
}

double bytesPerBatch(const fs::path& project) {
  std::vector<fs::path> batches;
  std::error_code error;
  for (fs::directory_iterator at(project / "batches", error), end; !error && at != end;
       at.increment(error))
    if (fs::exists(at->path() / "back") && !decisions::holdsScans(at->path()))
      batches.push_back(at->path());  // whole, and photographed
  std::sort(batches.begin(), batches.end(), std::greater<>());
  batches.resize(std::min(batches.size(), kNewestBatches));
  // The largest, so that the room does not grow while batches are made.
  double largest = 0;
  for (const fs::path& batch : batches) {
    const fs::path results = project / "results" / batch.filename();
    const double photographs = sizeOf(batch);
    largest = std::max(largest, photographs + (fs::exists(results / "report.json")
                                                   ? sizeOf(results)
                                                   : kResultsPerPhotographs * photographs));
  }
  return std::max(largest, batches.size() < kEnoughBatches ? kUsualBatch_bytes : kLeastBatch_bytes);
}

int roomForBatches(const fs::path& project) {
  std::error_code error;
  const fs::space_info space = fs::space(project, error);
  if (error) return -1;
  const double usable = std::max(0.0, static_cast<double>(space.available) - kLeastFree_bytes);
  return static_cast<int>(std::min(usable / bytesPerBatch(project), 1.0e6));
}

}  // namespace ostraka::intake
