#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "version.h"

namespace ostraka::api {

/// A sherd as the catalogue shows it. Texts are UTF-8.
struct CatalogueSherd {
  std::string id;      ///< UUID
  std::string number;  ///< empty for a draft
  /// As in an exported CSV: name of the column to its text; without those that are empty.
  std::map<std::string, std::string> fields;
  /// The measurements that count now: kind (length, thickness_mean, weight, ...) to value, in mm,
  /// mm^2 (area), mm^3 (volume), g (weight) or per cent (filled_pct, rim_pct).
  std::map<std::string, double> measurements;
  std::filesystem::path model, preview;  ///< files; empty where there is none
};

struct CatalogueContents {
  std::string id, code, title;  ///< of the project
  std::vector<CatalogueSherd> sherds;
};

/// The sherds of the project in this folder that match the filter, by number, drafts last. filter:
/// as in the window's search field (`rim thickness>6`); empty for all. What is read is of one
/// moment, while others may write. A catalogue of an older version is brought up to date first,
/// after a backup, and what an interrupted command left half written is removed, as the program
/// does when it opens a project; nothing else is changed.
/// Errors: UnusableInput (no project, a word of the filter, a newer version), CannotWrite (the
/// backup), Damaged, Failed (another program keeps the catalogue for 10 s).
OSTRAKA_API Result<CatalogueContents> readCatalogue(const std::filesystem::path& project,
                                                    std::string_view filter);

}  // namespace ostraka::api
