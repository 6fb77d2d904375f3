#include "pipeline/proposed_sheet.h"

#include <utility>
#include <vector>

#include "base/text.h"
#include "rig/sheet_layout.h"

namespace ostraka::pipeline {

bool isProposed(const batch::Batch& batch) {
  return batch.plate && batch.plate_file.empty();
}

Result<void> proposeMissingSheet(batch::Batch& batch, const ProcessOptions& options,
                                 Progress& progress, std::stop_token stop) {
  if (batch.plate || batch.way != batch::Way::FreeCamera || !options.marker_mm) return {};
  std::vector<std::filesystem::path> fronts;
  for (const batch::Shot& shot : batch.shots)
    if (shot.side == batch::Side::Front) fronts.push_back(shot.file);
  rig::SheetLayoutOptions how;
  how.marker_mm = *options.marker_mm;
  how.threads = options.threads;
  Result<rig::SheetLayout> sheet = rig::proposeSheet(fronts, how, progress, std::move(stop));
  if (!sheet) return Error{sheet.error().code, sheet.error().what, batch.folder.string()};
  batch.plate = batch::asSheet(std::move(sheet->plate));
  progress.note(
      NoteLevel::Warning,
      "No plate.json describes the sheet: " + std::to_string(batch.plate->markers.size()) +
          " markers of " + batch.plate->dictionary + " with sides of " + fixed(how.marker_mm, 2) +
          " mm were found in the photographs (" + fixed(sheet->rms_px, 2) +
          " px) and are taken for it. Measure the distance of two markers that lie far "
          "apart and compare it with plate.json in the output folder.");
  return {};
}

}  // namespace ostraka::pipeline
