#pragma once
#include "base/result.h"
#include "catalogue/catalogue.h"

namespace ostraka::upkeep {

/// That every number in a catalogue from elsewhere is finite and every text UTF-8, as each that
/// this program writes: SQLite keeps anything, and a table, a JSON file or a sum takes neither.
/// Not the settings and the history, which hold names of files as the system gave them. Errors:
/// UnusableInput, which names table, column and row.
Result<void> checkValues(const catalogue::Catalogue& catalogue);

}  // namespace ostraka::upkeep
