#pragma once
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "catalogue/sherd.h"

namespace ostraka::catalogue {

/// A sherd that has a number and neither a pair of scans nor a model: a person asked for new
/// photographs of it, or it was entered from a list. Its number may be typed on another plate.
bool waitsForPhotographs(const SherdRecord& sherd);

/// Those of which a person asked for new photographs, by number.
Result<std::vector<SherdRecord>> toPhotographAgain(const Catalogue& catalogue);

/// What lies on the plate as `made`, a draft, is `known`: this one takes its batch and its scans,
/// and the draft is void. Within a transaction; the model comes with the results.
void takeOver(Catalogue& catalogue, const SherdRecord& known, const SherdRecord& made,
              const Act& act);

}  // namespace ostraka::catalogue
