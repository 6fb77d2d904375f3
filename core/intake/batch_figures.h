#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "checks/moved_cameras.h"
#include "review/review.h"
#include "sherds/photographed_again.h"

namespace ostraka::intake {

/// What is shown of a batch that was computed: kept in the catalogue, so that it outlives the
/// program.
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
  std::vector<sherds::UnlikeBefore> unlike{};
  std::vector<std::string> numbers_left{};  ///< typed on the plate; none of its sherds has them

  void take(const review::ReviewCounts& counts);
};

/// None where nothing was kept, or nothing that can be read.
std::optional<BatchFigures> keptFigures(const catalogue::Catalogue& catalogue,
                                        const std::string& batch_number);
/// Less what was photographed again, and the numbers that were given, since.
std::optional<BatchFigures> shownFigures(const catalogue::Catalogue& catalogue,
                                         const std::string& batch_number);
Result<void> keepFigures(catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const BatchFigures& figures);

}  // namespace ostraka::intake
