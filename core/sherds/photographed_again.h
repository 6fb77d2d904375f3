#pragma once
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/sherd.h"

namespace ostraka::sherds {

/// A sherd that has a number and no model, of which a person asked for new photographs, or which
/// was entered from a list. Its number may be typed on another plate. Throws Refused.
bool waitsForPhotographs(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd);

/// Those of which a person asked for new photographs, by number; not those that lie on a plate
/// which is not computed yet.
Result<std::vector<records::SherdRecord>> toPhotographAgain(const catalogue::Catalogue& catalogue);

/// A front of a batch whose sherd has its scans from a later plate by now.
struct PhotographedAgain {
  store::ScanRow front;
  std::string number, batch_number;  ///< of the sherd, and where it lies now
};
Result<std::vector<PhotographedAgain>> photographedAgain(const catalogue::Catalogue& catalogue,
                                                         store::BatchRow batch);

/// A sherd of this batch that took it over from another, and is of another size than its model of
/// then: its number may have been typed on another piece.
struct UnlikeBefore {
  std::string number;
  double before_mm = 0, now_mm = 0;  ///< length, or width where that differs more
};
/// Those whose length or width, by the program, differs by more than a tenth.
Result<std::vector<UnlikeBefore>> unlikeBefore(const catalogue::Catalogue& catalogue,
                                               store::BatchRow batch);

/// What lies on the plate as `made`, a draft, is `known`: this one takes its batch and its scans,
/// and what was described and measured on the draft where it says nothing itself; the draft is
/// void. Within a transaction; the model comes with the results.
void takeOver(const catalogue::Catalogue& catalogue, const records::SherdRecord& known,
              const records::SherdRecord& made, const records::Provenance& provenance);

}  // namespace ostraka::sherds
