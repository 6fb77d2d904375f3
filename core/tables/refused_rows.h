#pragma once
#include <functional>
#include <string>

#include "tables/import_table.h"

namespace ostraka::tables {

/// The rows of a table that were refused or wait for a confirmation, as the table has them behind a
/// column for the reason: to be corrected in a spreadsheet and imported again, where parseCsv
/// leaves that column out; formulas are guarded, in headings, too. Of an export folder, which has
/// no rows: reason, line, field and value, headed in the reader's language. words: a message in
/// that language.
std::string refusedRowsCsv(const ImportReport& report,
                           const std::function<std::string(const Message&)>& words);

}  // namespace ostraka::tables
