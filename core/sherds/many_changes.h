#pragma once
#include <span>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::sherds {

/// Catalogue::change for so many changes that others would wait too long for a single transaction:
/// a hundred sherds each, with room for the others between. All or nothing all the same: when it is
/// stopped or one is refused, what was changed already is taken back (the history tells both).
/// Changes of one sherd follow each other. Returns the changes that undo it. Errors: as change(),
/// Cancelled.
Result<std::vector<records::FieldChange>> changeMany(const catalogue::Catalogue& catalogue,
                                                     std::span<const records::FieldChange> changes,
                                                     const records::Provenance& provenance,
                                                     Progress& progress, std::stop_token stop);

/// `changes` to be done again after `undo`, which apply returned for them: they expect the values
/// that it leaves. Without those that changed nothing.
std::vector<records::FieldChange> changesAgain(std::span<const records::FieldChange> changes,
                                               std::span<const records::FieldChange> undo);

}  // namespace ostraka::sherds
