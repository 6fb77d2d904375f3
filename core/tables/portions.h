#pragma once
#include <functional>
#include <stop_token>

#include "tables/import_table.h"

namespace ostraka::tables {

/// Enters rows 0 to count - 1 by `enter`, some at a time as one transaction, so that others can
/// write between; of a preview all, taken back. Returns how many were entered; fewer than count
/// when a stop was asked for or a row failed, and then unfinishedImports() tells of options.source.
/// Errors: Cancelled of a preview or before the first row, the first one of `enter` with
/// how many rows are entered.
Result<std::size_t> enterInPortions(catalogue::Catalogue& catalogue, std::size_t count,
                                    const ImportOptions& options, Progress& progress,
                                    const std::stop_token& stop,
                                    const std::function<Result<void>(std::size_t)>& enter);

}  // namespace ostraka::tables
