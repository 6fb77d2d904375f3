#pragma once
#include <filesystem>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::rig {

struct SheetLayoutOptions {
  double marker_mm = 0;  ///< side of the black square of each marker, as measured on the paper
  int probed = 5;        ///< photographs in which all dictionaries are tried
  int photographs = 30;  ///< that the layout is computed from; more add little
  int threads = 0;
};

/// What lies under the sherds, proposed from photographs of it.
struct SheetLayout {
  batch::Plate plate;  ///< a sheet around the markers; its middle is the origin, z up
  int photographs = 0;
  double rms_px = 0;  ///< of the markers' corners, with free cameras of one lens
  std::vector<int>
      left_out;  ///< ids read that lie elsewhere than on the sheet, or in one photograph
};

/// Whether this may be the side of a marker on a sheet. Error: UnusableInput.
Result<void> checkMarkerSide(double marker_mm);

/// Markers of equal size on a flat sheet, in photographs from any places: which of OpenCV's
/// dictionaries they are of, and where they lie. Photographs of different sizes are taken as of
/// different lenses. The size is known as well as `marker_mm`, the shape to 0.3 % where eight
/// photographs see most markers from several directions. Errors: UnusableInput (marker_mm),
/// NotEnough, Cancelled.
Result<SheetLayout> proposeSheet(const std::vector<std::filesystem::path>& photographs,
                                 const SheetLayoutOptions& options, Progress& progress,
                                 std::stop_token stop);

}  // namespace ostraka::rig
