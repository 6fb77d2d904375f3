#pragma once
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/photographed_again.h"
#include "checks/moved_cameras.h"

namespace ostraka::ui {

struct ComputeOptions {
  std::filesystem::path project;
  std::string number;             ///< B0031
  std::string dense = "builtin";  ///< builtin, colmap or openmvs
  int threads = 0;                ///< 0: all
  bool draft = false;             ///< a quick look at coarser photographs; final models come later
};

/// What the queue shows of a batch that was computed.
struct BatchFigures {
  int sherds = 0;
  int sure = 0, ask = 0;
  double uncertainty_mm = 0;  ///< the largest of its sherds; 0: none has one
  double seconds = 0;         ///< of this run
  int decided = 0;            ///< by a person; besides sure and ask
  int reshoot = 0;            ///< to be photographed again, says a person
  int again = 0;              ///< photographed again since; see shownFigures
  bool draft = false;
  int counted = 0;  ///< on the plate, where other than the scans of its fuller side; else 0
  /// Cameras that no longer stand where the known rig has them: it is to be calibrated again.
  std::vector<checks::MovedCamera> moved{};
  /// Sherds that were photographed again and are of another size now.
  std::vector<catalogue::UnlikeBefore> unlike{};
  std::vector<std::string> numbers_left{};  ///< typed on the plate; none of its sherds has them
};

/// A batch of the project from photographs (or scans) to rows of the catalogue, going on from the
/// last whole stage; at the end the catalogue is backed up. Opens the project by itself: callable
/// in any thread. The batch's state becomes Computed, then Review or Done; on an error it stays.
Result<BatchFigures> computeBatch(const ComputeOptions& options, Progress& progress,
                                  std::stop_token stop);

/// Bytes that a batch and its results will take, by those on the disk; of one that is photographed
/// and not computed yet by its photographs.
double bytesPerBatch(const std::filesystem::path& project);
/// How many more batches fit; -1 when the disk does not say.
int roomForBatches(const std::filesystem::path& project);

}  // namespace ostraka::ui
