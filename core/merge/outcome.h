#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "merge/settled.h"

namespace ostraka::merge {

/// Setting: numbers of batches of which a merge did not find all files, each with a blank behind
/// it.
inline constexpr const char* kIncompleteBatches = "merge.incomplete";

/// One thing that a row says in both projects, and how the history tells it.
struct Said {
  std::string name, row;
  std::vector<std::string> fields;
  Version a, b;                       ///< for a person
  std::string field, told_a, told_b;  ///< for the history
};

/// The same of one text, which the history tells as it is.
inline Said saidText(const std::string& field, const std::string& row, const std::string& a,
                     const std::string& b) {
  return {field, row, {field}, {{{field, a}}}, {{{field, b}}}, field, a, b};
}

/// A reference to a row that A does not have yet.
struct Deferred {
  std::string table, column, id;
  std::int64_t row = 0;
};

/// A number that went from a sherd of A to another.
struct TakenNumber {
  std::string sherd, number;
  bool numbered = false;  ///< else the sherd is void and needs none
  std::string wanted;     ///< what a person calls it from now on; empty: nobody said
};

/// A file of B that A gets.
struct FileCopy {
  std::string from, to;  ///< relative to their projects
  std::string sha256;    ///< from B's catalogue; empty: the catalogue does not name the file
  bool replaces =
      false;  ///< the file in its place belonged to the same row, or to replaced results
  bool restores = false;  ///< A has its row, too, and lacks the file
  bool operator==(const FileCopy&) const = default;
};

struct MergeReport {
  bool entered = false;
  int added = 0, changed = 0;   ///< rows of A
  int sherds = 0, batches = 0;  ///< of the added ones
  int files = 0;                ///< copied, or to be copied where nothing is entered
  std::int64_t bytes = 0;
  std::vector<Conflict> conflicts;                ///< the settled ones, too
  std::map<std::string, std::string> renumbered;  ///< batches: numbers of B that are others in A
  /// Sherds, by uuid, whose number went to another, or that a person called otherwise: the number
  /// that they had in A, or else in B, and the one that they have now.
  std::map<std::string, std::pair<std::string, std::string>> new_numbers;
  std::vector<std::string> missing;  ///< files that B's catalogue names but B lacks
  std::vector<std::string> kept;     ///< changed meanwhile (upkeep::placeStaged)
  bool unsettled() const;
};

/// What one merge does, or would do.
struct Outcome : MergeReport {
  std::map<std::string, std::string> files_of;    ///< folder of B -> folder of A, all of its files
  std::map<std::string, std::string> incomplete;  ///< likewise, but only files that A lacks
  std::map<std::string, FileCopy> copies;         ///< by where they go: what B's catalogue names
  /// Of batches that both have, by place in A: what it becomes; none: as A has it.
  std::map<std::string, std::optional<std::string>> peoples_files;
  std::map<std::string, std::string> withdrawn;  ///< in decisions.json: what lost -> its withdrawal
};

}  // namespace ostraka::merge
