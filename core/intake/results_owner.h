#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "base/result.h"
#include "batch/photographs.h"
#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::intake {

/// Whether OUT of `ostraka process` was made from this batch's own photographs (or scans that were
/// imported): what OUT/work/batch.json says it read of each side, against what lies in that side's
/// folder, or, where nothing does, what the catalogue recorded of it. A side is another taking when
/// more than half of its photographs are others. Returns a sentence where single photographs differ
/// or are missing. Of a batch whose photographs are nowhere, an OUT is taken at its word unless
/// another batch has them. Errors: UnusableInput, with the side that was photographed again, or the
/// other batch if there is one, or for an OUT that does not say what it was made from; Cancelled.
Result<std::optional<Message>> checkResultsAreOf(const catalogue::Catalogue& catalogue,
                                                 const std::filesystem::path& project,
                                                 const records::BatchRecord& batch,
                                                 const std::filesystem::path& out,
                                                 const std::stop_token& stop);

/// The photographs that OUT was made from; empty where it does not say. Throws Refused.
batch::PhotographHashes photographsOf(const std::filesystem::path& out);

}  // namespace ostraka::intake
