#pragma once
#include <string>

#include "base/result.h"
#include "pipeline/decisions.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// Enters what a person decided into the catalogue's append-only list, so that the sherds follow.
/// A decision about several scans becomes a row each; joins and cuts go into the list of pieces.
/// Errors: Missing when the batch or its scans are not entered yet.
Result<void> enterDecision(catalogue::Catalogue& catalogue, const std::string& batch_number,
                           const pipeline::PairDecision& decision);

/// A computed batch is done when nobody needs to look, nothing needs to be computed and its scale
/// is not in doubt, and wants a person otherwise. One that is being shot, waits or failed is left
/// as it is.
Result<void> settleBatch(catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const std::string& person, bool nothing_to_do);

/// The batch is to be computed again; the queue sees it.
Result<void> queueAgain(catalogue::Catalogue& catalogue, const std::string& batch_number,
                        const std::string& person);

}  // namespace ostraka::ui
