#pragma once
#include <filesystem>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"

namespace ostraka::upkeep {

/// A row that lay on a page which could not be set right.
struct RepairedRow {
  enum class From {
    Backup,   ///< as the backup has it, and changed since as the history says
    History,  ///< newer than the backup: from the history
    Nowhere   ///< not restored; `field` empty: the whole row
  };
  std::string table;
  std::int64_t row = 0;  ///< 0, not restored: rows of a table, nobody knows whether or how many
  std::string name;      ///< number, code or path; empty where none is known
  std::string field;     ///< of which the last change is not restored
  From from = From::Nowhere;
  std::string owner = {};  ///< of the number `name`, which this sherd has lost; else empty

  /// What it is, and where it came from; backup: its file.
  Message words(const std::string& backup) const;
};

struct RepairReport {
  int pages = 0, pages_by_bit = 0, pages_by_backup = 0, pages_lost = 0;
  bool interrupted = false;       ///< an earlier repair was ended, of which only `damaged` is known
  bool all_from_backup = false;   ///< nothing of the damaged file could be read
  std::filesystem::path backup;   ///< whose rows were taken; empty: none were needed
  std::filesystem::path damaged;  ///< where the damaged file is now; empty: nothing was damaged
  std::vector<RepairedRow> rows;
  /// Tables without row numbers whose middle is lost: rows of which nothing else may speak.
  std::set<std::string> cut_tables;
  Message warning;  ///< empty where the version of the damaged catalogue was known
};

/// Makes a damaged catalogue whole: pages that their own checksums prove, then row by row from the
/// whole backup of this project whose history goes furthest, and the history. Of two sherds with
/// one number, the one to which it was given keeps it; the other loses its number and nothing else.
/// Writes the new catalogue beside it, checks it, backs it up, keeps the damaged file and renames.
/// Nobody may have the project open, and nobody can open it in the meantime. A repair that was
/// killed is completed by the next one. A catalogue that is gone is made from the backups. A whole
/// catalogue is left as it is; a backup that was put in its place loses the WAL of the file that it
/// replaced, which is kept as `damaged`-wal. Errors: a newer version, as by opening; in use, no
/// whole backup where a page is lost, CannotWrite, Cancelled; then everything is as it was.
Result<RepairReport> repairCatalogue(const std::filesystem::path& project, Progress& progress,
                                     std::stop_token stop,
                                     const catalogue::Catalogue::Clock& clock = {});

}  // namespace ostraka::upkeep
