#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "merge/settled.h"
#include "records/records.h"
#include "upkeep/project.h"

namespace ostraka::merge {

enum class MergeMode { Preview, Enter };

struct MergeReport {
  bool entered = false;
  int added = 0, changed = 0;   ///< rows of A
  int sherds = 0, batches = 0;  ///< of the added ones
  int files = 0;                ///< copied, or to be copied where nothing is entered
  std::int64_t bytes = 0;
  std::vector<Conflict> conflicts;                ///< the settled ones, too
  std::map<std::string, std::string> renumbered;  ///< batches: numbers of B that are others in A
  std::vector<std::string> missing;               ///< files that B's catalogue names but B lacks
  bool unsettled() const;
};

/// Brings what project B holds into A, in one transaction, with its files; B is only read. Nothing
/// is written while a conflict is unsettled. Repeating a merge changes nothing. docs/merge.md has
/// the rules. Errors: UnusableInput (A itself, no project, another version's schema, a file that
/// differs from B's catalogue), Damaged, CannotWrite, Cancelled, Failed (the result would not be
/// whole); A is then unchanged.
Result<MergeReport> mergeInto(upkeep::Project& a, const std::filesystem::path& b, MergeMode mode,
                              const Settled& settled, const records::Provenance& provenance,
                              Progress& progress, std::stop_token stop);

}  // namespace ostraka::merge
