#pragma once
#include "base/result.h"
#include "catalogue/catalogue.h"

namespace ostraka::upkeep {

/// Checks that every number in a catalogue from elsewhere is finite and every text is UTF-8, as
/// this program writes them (store::Statement): SQLite stores anything, but a table, a JSON file or
/// a sum accepts neither. Not where file names stand as the system gave them (holdsSystemNames).
/// Errors: UnusableInput, which names table, column and row.
Result<void> checkValues(const catalogue::Catalogue& catalogue);

}  // namespace ostraka::upkeep
