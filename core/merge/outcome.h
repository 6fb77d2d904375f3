#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "merge/settled.h"

namespace ostraka::merge {

/// One thing that a row says in both projects, and how the history tells it.
struct Said {
  std::string name, row;
  std::vector<std::string> fields;
  Version a, b;                       ///< for a person
  std::string field, told_a, told_b;  ///< for the history
};

/// A file of B that A gets.
struct FileCopy {
  std::string from, to;  ///< relative to their projects
  std::string sha256;    ///< from B's catalogue; empty: the catalogue does not name the file
  bool replaces =
      false;  ///< the file in its place belonged to the same row, or to replaced results
  bool operator==(const FileCopy&) const = default;
};

/// What one merge does, or would do.
struct Outcome {
  int added = 0, changed = 0;           ///< rows of A
  std::map<std::string, int> new_rows;  ///< of the added ones, by table
  std::vector<Conflict> conflicts;
  std::map<std::string, std::string> files_of;  ///< folder of B -> folder of A, all of its files
  std::map<std::string, FileCopy> copies;       ///< by where they go: what B's catalogue names
  std::map<std::string, std::string> batches;   ///< numbers of B that are others in A
  /// Of batches that both have, by place in A: what it becomes; none: as A has it.
  std::map<std::string, std::optional<std::string>> peoples_files;
  std::map<std::string, std::string> withdrawn;  ///< in decisions.json: what lost -> its withdrawal
  bool unsettled() const;
};

}  // namespace ostraka::merge
