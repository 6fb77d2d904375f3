#include "pipeline/proposed_sheet.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/memory.h"
#include "base/message.h"
#include "base/text.h"
#include "rig/plate_print.h"
#include "rig/sheet_layout.h"

namespace ostraka::pipeline {

namespace {
// A length that must be given; what is in mm then is a guess, and the result says so.
constexpr double kGuessedMarker_mm = 30;
// As a calliper reads the side of a marker; what a print is off the file's by shows beyond it.
constexpr double kSameSize_mm = 0.05;

// The batch's plate, as the photographs of its front show it. Returns how well its corners fit, px.
Result<double> findSheet(batch::Batch& batch, const ProcessOptions& options, Progress& progress,
                         std::stop_token stop) {
  std::vector<std::filesystem::path> fronts;
  for (const batch::Shot& shot : batch.shots)
    if (shot.side == batch::Side::Front) fronts.push_back(shot.file);
  rig::SheetLayoutOptions how;
  how.marker_mm = options.marker_mm.value_or(kGuessedMarker_mm);
  how.threads = batch::threadsForOriginals(batch, options.threads, freeMemoryMb());
  Result<rig::SheetLayout> sheet = rig::proposeSheet(fronts, how, progress, std::move(stop));
  if (!sheet) return Error{sheet.error().code, sheet.error().what, batch.folder.string()};
  batch.plate = batch::asSheet(std::move(sheet->plate));
  batch.plate->typed_marker_mm = options.marker_mm;
  return sheet->rms_px;
}

// Two sizes of one sheet: which of them is true only a person can say.
Result<void> agreesWithFile(const batch::Batch& batch, double marker_mm) {
  double nearest = 0;  // a plate may have markers of several sizes
  for (const batch::Marker& marker : batch.plate->markers)
    if (const double side = batch::sideOf(marker);
        std::abs(side - marker_mm) < std::abs(nearest - marker_mm) || nearest == 0)
      nearest = side;
  if (std::abs(nearest - marker_mm) <= kSameSize_mm) return {};
  return Error::unusable(
      message("The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. Measure "
              "one; then correct the file, or leave the option out.",
              decimal(nearest, 2), decimal(marker_mm, 2)),
      batch.plate_file);
}
}  // namespace

bool isProposed(const batch::Batch& batch) {
  return batch.plate && batch.plate_file.empty();
}

bool hasGuessedSize(const batch::Batch& batch, const ProcessOptions& options) {
  return isProposed(batch) && !options.marker_mm;
}

Result<void> proposeMissingSheet(batch::Batch& batch, const ProcessOptions& options,
                                 Progress& progress, std::stop_token stop) {
  if (batch.plate && options.marker_mm && !batch.plate_file.empty())
    return agreesWithFile(batch, *options.marker_mm);
  if (batch.plate || batch.way != batch::Way::FreeCamera) return {};
  // A length that was marked is worth more than markers of a size that nobody knows.
  if (!options.marker_mm && (!batch.known_lengths.empty() || batch.board)) return {};
  const Result<double> rms_px = findSheet(batch, options, progress, std::move(stop));
  if (!rms_px) {
    // Without a word about markers there need not be any.
    if (!options.marker_mm && rms_px.error().code == ErrorCode::NotEnough) return {};
    return rms_px.error();
  }
  const std::size_t markers = batch.plate->markers.size();
  if (options.marker_mm)
    progress.note(
        NoteLevel::Warning,
        message(
            "No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in "
            "the photographs (%4 px) and are used instead. Measure the distance between two "
            "markers that are far apart and compare it with plate.json in the output folder.",
            markers, batch.plate->dictionary, decimal(*options.marker_mm, 2), decimal(*rms_px, 2)));
  else
    progress.note(
        NoteLevel::Warning,
        message("No plate.json describes the sheet: %1 markers of %2 were found in the photographs "
                "(%3 px), but their size is unknown, so the result has no scale. Measure the side "
                "of a marker's black square and give it with --marker-mm.",
                markers, batch.plate->dictionary, decimal(*rms_px, 2)));
  return {};
}

Result<batch::Plate> setMarkerSide(const std::filesystem::path& folder, double marker_mm,
                                   Progress& progress, std::stop_token stop) {
  if (const Result<void> good = rig::checkMarkerSide(marker_mm); !good) return good.error();
  Result<batch::Batch> batch = batch::readBatch(folder, {}, progress);
  if (!batch) return batch.error();
  if (batch->way != batch::Way::FreeCamera)
    return Error::unusable(
        message("The scale of this batch is its rig's; calibrate the rig to correct it."), folder);
  if (!batch->plate) {
    ProcessOptions options;
    options.marker_mm = marker_mm;
    if (const auto found = findSheet(*batch, options, progress, std::move(stop)); !found)
      return found.error();
  } else if (batch::markerSide(*batch->plate)) {
    batch->plate = batch::withMarkerSide(*batch->plate, marker_mm);
  } else {
    return Error::unusable(
        message("The markers of this sheet are of several sizes; correct its plate.json by hand."),
        batch->plate_file);
  }
  const Result<void> written = rig::writePlate(folder / "plate.json", *batch->plate);
  return written ? Result<batch::Plate>(*batch->plate) : written.error();
}

}  // namespace ostraka::pipeline
