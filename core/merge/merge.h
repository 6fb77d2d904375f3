#pragma once
#include <filesystem>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "merge/outcome.h"
#include "records/records.h"
#include "upkeep/project.h"

namespace ostraka::merge {

enum class MergeMode { Preview, Enter };

/// Brings what project B holds into A, in one transaction, with its files; B is only read. Nothing
/// is written while a conflict is unsettled. Repeating a merge changes nothing. docs/merge.md has
/// the rules. Errors: UnusableInput (A itself, no project, another version's schema, a file that
/// differs from B's catalogue), Damaged, CannotWrite, Cancelled, Failed (the result would not be
/// whole); A is then unchanged.
Result<MergeReport> mergeInto(upkeep::Project& a, const std::filesystem::path& b, MergeMode mode,
                              const Settled& settled, const records::Provenance& provenance,
                              Progress& progress, std::stop_token stop);

}  // namespace ostraka::merge
