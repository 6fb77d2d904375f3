#include "pipeline/proposed_sheet.h"

#include <utility>
#include <vector>

#include "base/text.h"
#include "rig/sheet_layout.h"

namespace ostraka::pipeline {

namespace {
// A length that must be given; what is in mm then is a guess, and the result says so.
constexpr double kGuessedMarker_mm = 30;
}  // namespace

bool isProposed(const batch::Batch& batch) {
  return batch.plate && batch.plate_file.empty();
}

bool hasGuessedSize(const batch::Batch& batch, const ProcessOptions& options) {
  return isProposed(batch) && !options.marker_mm;
}

Result<void> proposeMissingSheet(batch::Batch& batch, const ProcessOptions& options,
                                 Progress& progress, std::stop_token stop) {
  if (batch.plate || batch.way != batch::Way::FreeCamera) return {};
  // A length that was marked is worth more than markers of a size that nobody knows.
  if (!options.marker_mm && (!batch.known_lengths.empty() || batch.board)) return {};
  std::vector<std::filesystem::path> fronts;
  for (const batch::Shot& shot : batch.shots)
    if (shot.side == batch::Side::Front) fronts.push_back(shot.file);
  rig::SheetLayoutOptions how;
  how.marker_mm = options.marker_mm.value_or(kGuessedMarker_mm);
  how.threads = options.threads;
  Result<rig::SheetLayout> sheet = rig::proposeSheet(fronts, how, progress, std::move(stop));
  if (!sheet) {
    // Without a word about markers there need not be any.
    if (!options.marker_mm && sheet.error().code == ErrorCode::NotEnough) return {};
    return Error{sheet.error().code, sheet.error().what, batch.folder.string()};
  }
  batch.plate = batch::asSheet(std::move(sheet->plate));
  const std::string markers =
      std::to_string(batch.plate->markers.size()) + " markers of " + batch.plate->dictionary;
  if (options.marker_mm)
    progress.note(NoteLevel::Warning,
                  "No plate.json describes the sheet: " + markers + " with sides of " +
                      fixed(how.marker_mm, 2) + " mm were found in the photographs (" +
                      fixed(sheet->rms_px, 2) +
                      " px) and are used instead. Measure the distance between two markers that "
                      "lie far apart and compare it with plate.json in the output folder.");
  else
    progress.note(NoteLevel::Warning,
                  "No plate.json describes the sheet: " + markers +
                      " were found in the photographs (" + fixed(sheet->rms_px, 2) +
                      " px), but their size is unknown, so the result has no scale. Measure the "
                      "side of a marker's black square and give it with --marker-mm.");
  return {};
}

}  // namespace ostraka::pipeline
