#pragma once
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>

#include "base/result.h"

namespace ostraka::upkeep {

/// What the checksums of a damaged catalogue's pages prove.
struct PageRepair {
  int pages = 0;
  int by_bit = 0;                ///< one bit was flipped back: the page's checksum is right again
  int by_backup = 0;             ///< a backup's page has the checksum that this one had
  std::set<std::uint32_t> lost;  ///< numbers, from 1, of those that stay damaged
  bool wal_damaged = false;
  int wal_pages_lost = 0;  ///< of a damaged WAL, those whose numbers are not known either
};
/// Repairs in place what the checksums prove, so pass a copy. The catalogue's pages are those of
/// the file under those that its WAL holds of saved transactions, which is merged into the file and
/// removed. Missing pages at the file's end are added and count as lost, as what cannot be read
/// does. Errors: CannotWrite.
Result<PageRepair> repairPages(const std::filesystem::path& file,
                               std::span<const std::filesystem::path> backups);

/// Puts the pages that hold the schema, where they are lost, as `backup` has them: its tables begin
/// on the same pages. Returns whether the schema of `file` can be read now.
Result<bool> takeSchemaPages(const std::filesystem::path& file, const PageRepair& repair,
                             const std::filesystem::path& backup);

}  // namespace ostraka::upkeep
