#pragma once
#include "catalogue/catalogue.h"
#include "upkeep/repair.h"

namespace ostraka::store {
class Database;
}  // namespace ostraka::store

namespace ostraka::upkeep {

/// Fills `fresh`, whose tables are empty, with the rows of `damaged` that can be read and with
/// those of `backup` in place of the others; of sherds and places that both lack, those that the
/// history or another row speaks of are made anew. All three have the same schema. What is derived
/// (search, terms, the sherds' table of measurements) is recomputed; references to missing rows are
/// cleared, or removed with their rows. Adds to report.rows.
Result<void> collectRows(store::Database& damaged, store::Database& backup, store::Database& fresh,
                         RepairReport& report);

/// For the files of this folder: sherds and places that are missing in `fresh`, with what its
/// history and the rows that point at them tell. What nothing tells is named in report.rows. Checks
/// of references are off. Throws as Database::run.
void makeLostRowsAnew(store::Database& fresh, RepairReport& report);

/// Changes rows that came from the backup as the history of `repaired` says that they were changed
/// afterwards, and adds sherds of which only the history is left; likewise the joins, bags,
/// terms and settings of tables that could not be read whole. A sherd whose number was given to
/// another loses it. last_known: the number of the backup's last row of the history.
Result<void> replayHistory(catalogue::Catalogue& repaired, std::int64_t last_known,
                           RepairReport& report);

}  // namespace ostraka::upkeep
