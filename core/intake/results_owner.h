#pragma once
#include <filesystem>
#include <stop_token>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::intake {

/// Whether OUT of `ostraka process` was made from this batch's own photographs (or scans that were
/// imported): by what OUT/work/batch.json says it read, against the files that the catalogue and
/// the batch's folder have. As for the pipeline it is the same batch while a third of them are the
/// same, for one side may have been shot again. An OUT that does not say what it was made from, or
/// a batch whose photographs are nowhere, is taken at its word unless another batch has them.
/// Errors: UnusableInput, with the other batch if there is one; Cancelled.
Result<void> checkResultsAreOf(const catalogue::Catalogue& catalogue,
                               const std::filesystem::path& project,
                               const records::BatchRecord& batch, const std::filesystem::path& out,
                               const std::stop_token& stop);

}  // namespace ostraka::intake
